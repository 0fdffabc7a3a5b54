// SPDX-License-Identifier: Apache-2.0
#include "dewbow/math/airy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

namespace dewbow {
namespace {

/// What the header promises.
constexpr double kOfEnvelope = 1e-14;

struct Row {
    double x;
    AiryPair exact;
};

/// tests/reference/airy.csv: 40-digit arithmetic.
std::vector<Row> reference_rows() {
    std::ifstream file(DEWBOW_SOURCE_DIR "/tests/reference/airy.csv");
    std::vector<Row> rows;
    for (std::string line; std::getline(file, line);) {
        std::istringstream fields(line);
        Row row{};
        char comma;
        if (fields >> row.x >> comma >> row.exact.value >> comma >> row.exact.derivative)
            rows.push_back(row);
    }
    return rows;
}

/// The sizes that errors of Ai and Ai' are measured by.
AiryPair envelope(const Row& row) {
    if (row.x > 1.0) return {std::abs(row.exact.value), std::abs(row.exact.derivative)};
    const double root4 = std::sqrt(std::sqrt(std::max(std::abs(row.x), 1.0)));
    return {std::numbers::inv_sqrtpi / root4, std::numbers::inv_sqrtpi * root4};
}

void expect_near(const AiryPair& found, const Row& row, double tolerance) {
    const AiryPair size = envelope(row);
    EXPECT_NEAR(found.value / size.value, row.exact.value / size.value, tolerance) << row.x;
    EXPECT_NEAR(found.derivative / size.derivative, row.exact.derivative / size.derivative,
                tolerance)
        << row.x;
}

TEST(Airy, AgreesWithFortyDigits) {
    const std::vector<Row> rows = reference_rows();
    ASSERT_GT(rows.size(), 80u);
    for (const Row& row : rows) expect_near(airy(row.x), row, kOfEnvelope);
}

TEST(Airy, VanishesAtThePublishedZeros) {
    // Zeros of Ai and Ai' to ten digits.                                     [NIST DLMF
    // table 9.9.1]
    constexpr double kPrinted = 5e-11 * 1.5;  // half a digit, times the slopes there
    for (double zero : {-2.3381074105, -4.0879494441, -5.5205598281, -12.8287767529})
        EXPECT_NEAR(airy(zero).value, 0.0, kPrinted);
    for (double zero : {-1.0187929716, -3.2481975822, -4.8200992112, -12.3847883718})
        EXPECT_NEAR(airy(zero).derivative / std::abs(zero), 0.0, kPrinted);
}

TEST(Airy, NotANumberStaysOne) { EXPECT_TRUE(std::isnan(airy(std::nan("")).value)); }

TEST(AiryTable, KeepsItsPromise) {
    const AiryTable& table = AiryTable::instance();
    for (const Row& row : reference_rows())
        if (row.x >= AiryTable::kLowest && row.x <= AiryTable::kHighest)
            expect_near(table.inside(row.x), row, AiryTable::kError);
    // Between nodes, against airy(): an odd step meets every distance from a node.
    for (double x = AiryTable::kLowest; x <= AiryTable::kHighest; x += 0.0113)
        expect_near(table.inside(x), {x, airy(x)}, AiryTable::kError);
}

TEST(AiryTable, EvaluatesAnyArgument) {
    const std::vector<double> x{-600.0, -512.0, -1.0, 16.0, 17.0, -2.0, std::nan(""), 3.0};
    std::vector<double> value(x.size()), derivative(x.size());
    AiryTable::instance().eval(x, value, derivative);
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (std::isnan(x[i])) {
            EXPECT_TRUE(std::isnan(value[i]) && std::isnan(derivative[i]));
            continue;
        }
        expect_near({value[i], derivative[i]}, {x[i], airy(x[i])}, AiryTable::kError);
    }
}

}  // namespace
}  // namespace dewbow
