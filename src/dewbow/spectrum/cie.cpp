// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/cie.h"

#include <algorithm>

#include "dewbow/base/check.h"
#include "dewbow/spectrum/csv_table.h"
#include "dewbow/spectrum/embedded_data.h"

namespace dewbow {
namespace {

constexpr int kCells = 470;  ///< of 1 nm, from kLambdaMin_nm to kLambdaMax_nm

/// x̄, ȳ, z̄ at one wavelength of the table, padded so that a row is half a cache line.
struct alignas(32) Row {
    double bar[4] = {};
};
using Table = std::array<Row, kCells + 1>;

Table read_table() {
    const auto columns = columns_of_csv(spectrum::data::cie_xyz_1931_2deg_1nm_csv());
    DEWBOW_CHECK(columns.size() == 4 && columns[0].size() == kCells + 1, "471 rows of 4 columns");
    Table table;
    for (std::size_t i = 0; i < table.size(); ++i) {
        DEWBOW_CHECK(columns[0][i] == kLambdaMin_nm + double(i), "1 nm from row to row");
        for (std::size_t c = 0; c < 3; ++c) table[i].bar[c] = columns[c + 1][i];
    }
    return table;
}

const Table& table() {
    static const Table kTable = read_table();
    return kTable;
}

/// out += weight × (x̄, ȳ, z̄)(lambda_nm)
inline void add_bars(const Table& rows, double lambda_nm, double weight, double out[4]) {
    const double place = lambda_nm - kLambdaMin_nm;
    if (!(place >= 0.0 && place <= double(kCells))) return;
    const int i = std::min(int(place), kCells - 1);
    const double above = weight * (place - double(i));
    const double below = weight - above;
    const Row& a = rows[std::size_t(i)];
    const Row& b = rows[std::size_t(i) + 1];
    for (int c = 0; c < 4; ++c) out[c] += below * a.bar[c] + above * b.bar[c];
}

}  // namespace

std::array<double, 3> cie_xyz_bar(double lambda_nm) {
    double sum[4] = {};
    add_bars(table(), lambda_nm, 1.0, sum);
    return {sum[0], sum[1], sum[2]};
}

Colour<Xyz> xyz_from_spectrum(const Spectrum& spectrum) {
    constexpr double kStep_nm = 0.5;
    constexpr std::size_t kIntervals = 2 * std::size_t(kCells);
    std::array<double, kIntervals + 1> lambda_nm{}, value{};
    for (std::size_t i = 0; i <= kIntervals; ++i)
        lambda_nm[i] = kLambdaMin_nm + double(i) * kStep_nm;
    spectrum.eval_lanes(lambda_nm, value);
    double sum[4] = {};
    for (std::size_t i = 0; i <= kIntervals; ++i) {
        const bool at_end = i == 0 || i == kIntervals;
        add_bars(table(), lambda_nm[i], value[i] * kStep_nm * (at_end ? 0.5 : 1.0), sum);
    }
    return {{sum[0], sum[1], sum[2]}};
}

Colour<Xyz> xyz_from_lanes(const WavelengthPacket& packet, std::span<const double> values) {
    DEWBOW_CHECK(values.size() == std::size_t(packet.count), "one value for each lane");
    const Table& rows = table();
    double sum[4] = {};
    for (std::size_t k = 0; k < values.size(); ++k) {
        add_bars(rows, packet.lambda_nm[k], values[k] / packet.pdf_per_nm[k], sum);
    }
    const double scale = 1.0 / double(packet.count);
    return {{sum[0] * scale, sum[1] * scale, sum[2] * scale}};
}

double cie_y_integral() {
    static const double kIntegral = xyz_from_spectrum(*make_constant(1.0))[1];
    return kIntegral;
}

}  // namespace dewbow
