// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "dewbow/base/error.h"
#include "dewbow/base/named.h"
#include "dewbow/base/parse_number.h"
#include "dewbow/optics/embedded_data.h"
#include "dewbow/spectrum/csv_table.h"

namespace dewbow {
namespace {

constexpr const char* kFileName = "data/glasses/catalogue.csv";
constexpr std::string_view kHeader =
    "name,description,form,coefficients,reference,n_d,V_d,lambda_min_nm,lambda_max_nm,source";
enum Column {
    kName,
    kDescription,
    kForm,
    kCoefficients,
    kReference,
    kNd,
    kVd,
    kLambdaMin,
    kLambdaMax,
    kSource,
    kColumns
};

/// A row of the file, for what has to be said about it.
struct Row {
    std::vector<std::string> fields;
    std::string_view text;
    std::size_t line = 0;

    InputError error(const std::string& sentence) const {
        return InputError({kFileName, line, 0, {}}, sentence, std::string(text));
    }
};

double number(const Row& row, std::string_view text) {
    if (const auto value = parse_number<double>(text)) return *value;
    throw row.error(fmt::format("\"{}\" is not a number", text));
}

/// An empty field is 0: not published.
double number_or_zero(const Row& row, std::string_view text) {
    return text.empty() ? 0.0 : number(row, text);
}

std::vector<double> numbers(const Row& row, std::string_view text) {
    std::vector<double> values;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        values.push_back(number(row, text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return values;
}

IndexReference reference_named(const Row& row, std::string_view text) {
    if (text == "air") return IndexReference::air;
    if (text == "vacuum") return IndexReference::vacuum;
    throw row.error(fmt::format("\"{}\"; expected air or vacuum", text));
}

Glass glass_from(const Row& row) {
    const auto& f = row.fields;
    if (f.size() != kColumns)
        throw row.error(fmt::format("{} fields; expected {}", f.size(), int{kColumns}));
    Glass glass;
    glass.name = f[kName];
    glass.description = f[kDescription];
    glass.data = {f[kForm], numbers(row, f[kCoefficients]), reference_named(row, f[kReference])};
    glass.n_d = number_or_zero(row, f[kNd]);
    glass.v_d = number_or_zero(row, f[kVd]);
    glass.lambda_min_nm = number(row, f[kLambdaMin]);
    glass.lambda_max_nm = number(row, f[kLambdaMax]);
    glass.source = f[kSource];
    return glass;
}

std::vector<Glass> glasses_from(std::string_view text) {
    std::vector<Glass> glasses;
    std::size_t line = 0;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view row_text = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const Row row{csv_fields(row_text), row_text, ++line};
        if (row_text.empty()) continue;
        if (line > 1)
            glasses.push_back(glass_from(row));
        else if (row_text != kHeader)
            throw row.error(fmt::format("expected the columns {}", kHeader));
    }
    return glasses;
}

}  // namespace

std::span<const Glass> glass_catalogue() {
    static const std::vector<Glass> glasses = glasses_from(optics::data::catalogue_csv());
    return glasses;
}

const Glass& find_glass(std::string_view name) {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const Glass& glass : glass_catalogue()) all.push_back(glass.name);
        return all;
    }();
    return glass_catalogue()[find_named("glass", name, names)];
}

}  // namespace dewbow
