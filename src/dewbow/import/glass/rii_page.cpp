// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/glass/rii_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dewbow/base/parse_number.h"
#include "dewbow/import/glass/yaml.h"

namespace dewbow::glass_import {
namespace {

constexpr std::size_t kMostNumbers = 300'000;
constexpr double kIndexTolerance = 1e-4;

/// Text without tags of HTML, on one line, and not longer than a citation.
std::string plain(const std::string& text) {
    constexpr std::size_t kLongest = 300;
    std::string result;
    bool in_tag = false;
    for (const char c : text) {
        if (c == '<') in_tag = true;
        const bool space = c == '\n' || c == '\r' || c == '\t' || c == ' ';
        if (!in_tag && !(space && (result.empty() || result.back() == ' ')))
            result.push_back(space ? ' ' : c);
        if (c == '>') in_tag = false;
        if (result.size() > kLongest) break;
    }
    while (!result.empty() && result.back() == ' ') result.pop_back();
    return result;
}

class PageReader {
public:
    PageReader(const std::string& file, const std::string& name) : file_(file) {
        glass_.name = name;
    }

    GlassFile read(std::string_view text) {
        const YamlNode page = parse_yaml(text, file_);
        const YamlNode* data = page.find("DATA");
        if (!data) throw InputError(SourcePlace{file_, 0, 0, {}}, "no DATA in it");
        if (data->kind != YamlNode::Kind::list) fail(*data, "DATA is no list");
        for (const YamlNode& item : data->items) read_data(item);
        if (glass_.data.form.empty())
            fail(*data, "no index in DATA: expected a formula or a table");
        read_remarks(page);
        check(*data);
        result_.glasses.push_back(std::move(glass_));
        return std::move(result_);
    }

private:
    [[noreturn]] void fail(const YamlNode& node, const std::string& what) const {
        throw InputError(SourcePlace{file_, node.line, 0, {}}, what);
    }
    void note(const YamlNode& node, const std::string& text) {
        result_.notes.push_back({{file_, node.line, 0, {}}, text});
    }

    const YamlNode& required(const YamlNode& map, const char* key) const {
        const YamlNode* node = map.find(key);
        if (!node || node->kind != YamlNode::Kind::scalar)
            fail(map, fmt::format("no {} in this part of DATA", key));
        return *node;
    }

    std::vector<double> numbers(const YamlNode& node) const {
        std::vector<double> values;
        std::string_view rest = node.text;
        constexpr std::string_view kSpaces = " \t\r\n,";
        for (;;) {
            const std::size_t start = rest.find_first_not_of(kSpaces);
            if (start == std::string_view::npos) return values;
            const std::size_t end = std::min(rest.find_first_of(kSpaces, start), rest.size());
            const std::string_view word = rest.substr(start, end - start);
            const auto value = parse_number<double>(word);
            if (!value || !std::isfinite(*value))
                fail(node, fmt::format("\"{}\" is not a number", word.substr(0, 40)));
            if (values.size() == kMostNumbers)
                fail(node, fmt::format("more than {} numbers", kMostNumbers));
            values.push_back(*value);
            rest.remove_prefix(end);
        }
    }

    void read_data(const YamlNode& item) {
        if (item.kind != YamlNode::Kind::map) fail(item, "a part of DATA is no map");
        const std::string& type = required(item, "type").text;
        if (type.starts_with("formula ")) {
            read_formula(item, type.substr(8));
        } else if (type == "tabulated n" || type == "tabulated nk" || type == "tabulated k") {
            read_table(item, type.substr(10));
        } else {
            note(item, fmt::format("DATA of type \"{}\" is not used", type.substr(0, 40)));
        }
    }

    void read_formula(const YamlNode& item, const std::string& number) {
        if (number.size() != 1 || number[0] < '1' || number[0] > '9')
            fail(item, fmt::format("formula {}; expected 1 to 9", number.substr(0, 40)));
        if (!glass_.data.form.empty()) return note(item, "a second index is not used");
        glass_.data.form = "rii_" + number;
        glass_.data.coefficients = numbers(required(item, "coefficients"));
        const YamlNode* range = item.find("wavelength_range");
        if (!range) {
            range = item.find("range");  // before 2023
            if (range) note(*range, "the range is called \"range\", as in older pages");
        }
        if (!range) return note(item, "the formula states no range");
        const std::vector<double> ends = numbers(*range);
        if (ends.size() != 2 || !(ends[0] > 0.0 && ends[1] > ends[0]))
            fail(*range, "the range is no pair of rising wavelengths");
        set_range(ends[0], ends[1]);
    }

    void set_range(double low_um, double high_um) {
        glass_.lambda_min_nm = 1e3 * low_um;
        glass_.lambda_max_nm = 1e3 * high_um;
        glass_.data.range = DataRange{glass_.lambda_min_nm, glass_.lambda_max_nm};
    }

    /// @param columns  "n", "k" or "nk", after the wavelength.
    void read_table(const YamlNode& item, const std::string& columns) {
        const YamlNode& node = required(item, "data");
        const std::vector<double> values = numbers(node);
        const std::size_t width = 1 + columns.size();
        if (values.empty() || values.size() % width != 0)
            fail(node, fmt::format("{} numbers; expected rows of {}", values.size(), width));
        std::vector<std::size_t> rows;
        for (std::size_t i = 0; i < values.size(); i += width) rows.push_back(i);
        const auto wavelength = [&](std::size_t row) { return values[row]; };
        if (!std::is_sorted(rows.begin(), rows.end(),
                            [&](auto a, auto b) { return wavelength(a) < wavelength(b); })) {
            note(node, "the wavelengths do not rise: sorted");
            std::stable_sort(rows.begin(), rows.end(),
                             [&](auto a, auto b) { return wavelength(a) < wavelength(b); });
        }
        const std::size_t before = rows.size();
        rows.erase(std::unique(rows.begin(), rows.end(),
                               [&](auto a, auto b) { return wavelength(a) == wavelength(b); }),
                   rows.end());
        if (rows.size() < before) note(node, "a wavelength stands there twice: the first counts");
        if (!(values[rows.front()] > 0.0)) fail(node, "a wavelength is not positive");

        if (columns[0] == 'n') take_index(item, values, rows);
        if (columns.back() == 'k')
            for (const std::size_t row : rows)
                glass_.k.push_back({1e3 * values[row], std::max(values[row + width - 1], 0.0)});
    }

    void take_index(const YamlNode& item, const std::vector<double>& values,
                    const std::vector<std::size_t>& rows) {
        if (!glass_.data.form.empty()) return note(item, "a second index is not used");
        glass_.data.form = rows.size() > 1 ? "table" : "constant";
        for (const std::size_t row : rows) {
            if (rows.size() > 1) glass_.data.coefficients.push_back(values[row]);
            glass_.data.coefficients.push_back(values[row + 1]);
        }
        set_range(values[rows.front()], values[rows.back()]);
    }

    void read_remarks(const YamlNode& page) {
        const YamlNode* references = page.find("REFERENCES");
        glass_.source = references ? plain(references->text) : file_;
        if (const YamlNode* comments = page.find("COMMENTS"))
            glass_.description = plain(comments->text);
        if (const YamlNode* conditions = page.find("CONDITIONS")) read_direction(*conditions);
        const YamlNode* properties = page.find("PROPERTIES");
        if (!properties) return;
        const auto property = [&](const char* key) {
            const YamlNode* node = properties->find(key);
            const auto value = node ? parse_number<double>(node->text) : std::nullopt;
            return value && *value > 0.0 && std::isfinite(*value) ? *value : 0.0;
        };
        glass_.n_d = property("nd");
        glass_.v_d = property("Vd");
    }

    void read_direction(const YamlNode& conditions) {
        const YamlNode* direction = conditions.find("direction");
        if (!direction) return;
        glass_.birefringent = true;
        glass_.extraordinary = direction->text == "e";
    }

    void check(const YamlNode& data) {
        DispersionPtr dispersion;
        try {
            dispersion = make_dispersion(glass_.data);
        } catch (const InputError& error) {
            fail(data, error.sentence());
        }
        const double n_d = (*dispersion)(kLined).value / (*air())(kLined).value;
        if (glass_.n_d > 0.0 && !(std::abs(n_d - glass_.n_d) <= kIndexTolerance))
            note(data, fmt::format("the data give n_d {:.6f}, and PROPERTIES say {:.6f}", n_d,
                                   glass_.n_d));
    }

    const std::string file_;
    GlassFile result_;
    Glass glass_;
};

}  // namespace

GlassFile read_rii_page(std::string_view text, const std::string& file, const std::string& name) {
    return PageReader(file, name).read(text);
}

}  // namespace dewbow::glass_import
