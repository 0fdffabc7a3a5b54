// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "dewbow/base/error.h"
#include "dewbow/base/parse_number.h"
#include "dewbow/optics/embedded_data.h"

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

/// The fields of one line of CSV; within quotes commas are text and "" is a quote. [RFC 4180]
std::vector<std::string> csv_fields(std::string_view line) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
            fields.back() += '"';
            ++i;
        } else if (c == '"') {
            quoted = !quoted;
        } else if (c == ',' && !quoted) {
            fields.emplace_back();
        } else {
            fields.back() += c;
        }
    }
    return fields;
}

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

// ---- names ----

/// What of a name counts: letters in lower case, digits and the slash.
std::string folded(std::string_view name) {
    std::string result;
    for (const char c : name) {
        if (c == '-' || c == ' ' || c == '_') continue;
        result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return result;
}

std::string without_maker(const std::string& name) { return name.substr(name.find('/') + 1); }

/// The glasses that `name` can mean: the one of that full name, or all with it after the slash.
std::vector<const Glass*> glasses_named(std::string_view name) {
    const std::string wanted = folded(name);
    std::vector<const Glass*> found;
    for (const Glass& glass : glass_catalogue()) {
        if (folded(glass.name) == wanted) return {&glass};
        if (folded(without_maker(glass.name)) == wanted) found.push_back(&glass);
    }
    return found;
}

std::string full_names(const std::vector<const Glass*>& glasses) {
    std::string names;
    for (const Glass* glass : glasses) names += (names.empty() ? "" : ", ") + glass->name;
    return names;
}

/// "did you mean schott/F2?": nearest among the full names if a maker was given, among the rest if
/// not.
std::string hint_for_glass(std::string_view name) {
    const bool has_maker = name.find('/') != std::string_view::npos;
    std::vector<std::string> candidates;
    std::vector<const Glass*> all;
    for (const Glass& glass : glass_catalogue()) {
        candidates.push_back(has_maker ? glass.name : without_maker(glass.name));
        all.push_back(&glass);
    }
    std::string nearest = nearest_word(name, candidates);
    if (nearest.empty() && has_maker)  // a maker that is not here, of a glass that is
        nearest = without_maker(std::string(name));
    const auto meant = nearest.empty() ? std::vector<const Glass*>{} : glasses_named(nearest);
    if (!meant.empty()) return fmt::format("did you mean {}?", full_names(meant));
    return fmt::format("known are {}", full_names(all));
}

}  // namespace

std::span<const Glass> glass_catalogue() {
    static const std::vector<Glass> glasses = glasses_from(optics::data::catalogue_csv());
    return glasses;
}

const Glass& find_glass(std::string_view name) {
    const auto found = glasses_named(name);
    if (found.size() == 1) return *found.front();
    if (found.empty())
        throw InputError(fmt::format("unknown glass \"{}\"", name), hint_for_glass(name));
    throw InputError(fmt::format("glass \"{}\" is ambiguous", name),
                     fmt::format("write one of {}", full_names(found)));
}

}  // namespace dewbow
