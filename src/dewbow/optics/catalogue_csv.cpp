// SPDX-License-Identifier: Apache-2.0

// Glasses as lines of a table.

#include <fmt/format.h>

#include <algorithm>

#include "dewbow/base/error.h"
#include "dewbow/base/parse_number.h"
#include "dewbow/optics/catalogue.h"
#include "dewbow/spectrum/csv_table.h"

namespace dewbow {
namespace {

constexpr std::string_view kHeader =
    "name,aliases,description,form,coefficients,reference,n_d,V_d,accuracy,lambda_min_nm,"
    "lambda_max_nm,ray,source,licence";
enum Column {
    kName,
    kAliases,
    kDescription,
    kForm,
    kCoefficients,
    kReference,
    kNd,
    kVd,
    kAccuracy,
    kLambdaMin,
    kLambdaMax,
    kRay,
    kSource,
    kLicence,
    kColumns
};

/// A row of the file, for what has to be said about it.
struct Row {
    std::vector<std::string> fields;
    std::string_view text;
    SourcePlace place;

    InputError error(const std::string& sentence) const {
        return InputError(place, sentence, std::string(text));
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

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(separator), text.size());
        parts.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return parts;
}

IndexReference reference_named(const Row& row, std::string_view text) {
    if (text == "air") return IndexReference::air;
    if (text == "vacuum") return IndexReference::vacuum;
    throw row.error(fmt::format("\"{}\"; expected air or vacuum", text));
}

void read_ray(const Row& row, std::string_view text, Glass& glass) {
    if (!text.empty() && text != "o" && text != "e")
        throw row.error(fmt::format("\"{}\"; expected o, e or nothing as the ray", text));
    glass.birefringent = !text.empty();
    glass.extraordinary = text == "e";
}

Glass glass_from(const Row& row) {
    const auto& f = row.fields;
    if (f.size() != kColumns)
        throw row.error(fmt::format("{} fields; expected {}", f.size(), int{kColumns}));
    Glass glass;
    glass.name = f[kName];
    for (const std::string_view alias : split(f[kAliases], ';'))
        glass.aliases.push_back(std::string(alias));
    glass.description = f[kDescription];
    glass.lambda_min_nm = number(row, f[kLambdaMin]);
    glass.lambda_max_nm = number(row, f[kLambdaMax]);
    glass.data.form = f[kForm];
    for (const std::string_view c : split(f[kCoefficients], ' '))
        glass.data.coefficients.push_back(number(row, c));
    glass.data.reference = reference_named(row, f[kReference]);
    glass.data.range = DataRange{glass.lambda_min_nm, glass.lambda_max_nm};
    glass.n_d = number_or_zero(row, f[kNd]);
    glass.v_d = number_or_zero(row, f[kVd]);
    glass.accuracy = number_or_zero(row, f[kAccuracy]);
    read_ray(row, f[kRay], glass);
    glass.source = f[kSource];
    glass.licence = f[kLicence];
    return glass;
}

/// In double quotes where it must be. Lines end rows here, so that one inside a field is a space.
std::string quoted(std::string_view text) {
    std::string inside;
    for (const char c : text) {
        if (c == '"') inside.push_back(c);
        inside.push_back(c == '\n' || c == '\r' ? ' ' : c);
    }
    const bool plain = text.find_first_of(",\"") == std::string::npos;
    return plain ? inside : fmt::format("\"{}\"", inside);
}

std::string number_text(double value) { return value == 0.0 ? "" : fmt::format("{}", value); }

std::string joined(const auto& parts, char separator) {
    std::string text;
    for (const auto& part : parts) {
        if (!text.empty()) text.push_back(separator);
        text += fmt::format("{}", part);
    }
    return text;
}

std::string_view reference_text(IndexReference reference) {
    return reference == IndexReference::air ? "air" : "vacuum";
}

std::string_view ray_text(const Glass& glass) {
    if (!glass.birefringent) return "";
    return glass.extraordinary ? "e" : "o";
}

}  // namespace

std::string_view glass_csv_header() { return kHeader; }

std::vector<Glass> glasses_of_csv(std::string_view text, const std::string& file) {
    std::vector<Glass> glasses;
    std::size_t line = 0;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view row_text = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const Row row{csv_fields(row_text), row_text, {file, ++line, 0, {}}};
        if (row_text.empty()) continue;
        if (line > 1)
            glasses.push_back(glass_from(row));
        else if (row_text != kHeader)
            throw row.error(fmt::format("expected the columns {}", kHeader));
    }
    return glasses;
}

std::string csv_line_of(const Glass& glass) {
    std::string line;
    const auto add = [&](std::string_view field) {
        if (!line.empty()) line.push_back(',');
        line += quoted(field);
    };
    add(glass.name);
    add(joined(glass.aliases, ';'));
    add(glass.description);
    add(glass.data.form);
    add(joined(glass.data.coefficients, ' '));
    add(reference_text(glass.data.reference));
    add(number_text(glass.n_d));
    add(number_text(glass.v_d));
    add(number_text(glass.accuracy));
    add(fmt::format("{:.7g}", glass.lambda_min_nm));
    add(fmt::format("{:.7g}", glass.lambda_max_nm));
    add(ray_text(glass));
    add(glass.source);
    add(glass.licence);
    return line;
}

}  // namespace dewbow
