// SPDX-License-Identifier: Apache-2.0
#include "rainbow_option_value.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "dewbow/base/error.h"
#include "dewbow/base/parse_number.h"
#include "option_value.h"

namespace dewbow {
namespace {

std::vector<std::string_view> split_at(std::string_view text, char mark) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t at = text.find(mark);
        parts.push_back(text.substr(0, at));
        if (at == std::string_view::npos) return parts;
        text.remove_prefix(at + 1);
    }
}

std::string_view without_unit(std::string_view text, std::string_view unit_name) {
    if (!unit_name.empty() && text.ends_with(unit_name)) text.remove_suffix(unit_name.size());
    return text;
}

std::optional<double> number_in(std::string_view text, const Range& range) {
    const auto value = parse_number<double>(text);
    return value && range.contains(*value) ? value : std::nullopt;
}

/// The numbers of "FROM:TO:STEP", or nothing where it is none.
std::optional<std::vector<double>> steps_from(std::string_view text, const Range& range) {
    const auto parts = split_at(text, ':');
    if (parts.size() != 3) return std::nullopt;
    const auto from = number_in(parts[0], range), to = number_in(parts[1], range);
    const auto step = number_in(parts[2], {0.0, range.high, true, false});
    if (!from || !to || !step || *to < *from || (*to - *from) / *step > kMostListed)
        return std::nullopt;
    return stepped(*from, *to, *step);
}

/// Ascending numbers between commas, or nothing.
std::optional<std::vector<double>> list_from(std::string_view text, const Range& range) {
    std::vector<double> list;
    for (const std::string_view part : split_at(text, ',')) {
        const auto value = number_in(part, range);
        if (!value || (!list.empty() && *value <= list.back())) return std::nullopt;
        list.push_back(*value);
    }
    return list;
}

/// n and k of "1.33+1e-8i"; what stands before the sign that is not an exponent's.
std::optional<std::pair<std::string_view, std::string_view>> complex_parts(std::string_view text) {
    if (!text.ends_with('i')) return std::nullopt;
    text.remove_suffix(1);
    for (std::size_t at = text.size(); at-- > 1;) {
        const bool sign = text[at] == '+' || text[at] == '-';
        if (sign && text[at - 1] != 'e' && text[at - 1] != 'E')
            return std::pair(text.substr(0, at), text.substr(at));
    }
    return std::nullopt;
}

}  // namespace

Length parse_drop_radius(std::string_view option, std::string_view text) {
    constexpr std::pair<std::string_view, Length> kUnits[] = {
        {"nm", 1e-9 * unit::m}, {"mm", unit::mm}, {"um", unit::um},
        {"µm", unit::um},       {"cm", unit::cm}, {"m", unit::m}};
    for (const auto& [name, unit] : kUnits) {
        if (!text.ends_with(name)) continue;
        const auto number = parse_number<double>(without_unit(text, name));
        if (!number) break;
        const Length radius = *number * unit;
        if (kDropRadii_mm.contains(radius.to(unit::mm))) return radius;
        break;
    }
    refuse_value(option, text, "a length with its unit such as 0.3mm or 10um, from 1nm to 10mm");
}

double parse_in_range(std::string_view option, std::string_view text, const Range& range,
                      std::string_view unit_name) {
    if (const auto value = number_in(without_unit(text, unit_name), range)) return *value;
    refuse_value(
        option, text,
        fmt::format("a number {}{}{}", range.text(), unit_name.empty() ? "" : " ", unit_name));
}

std::vector<double> parse_list(std::string_view option, std::string_view text, const Range& range,
                               std::string_view unit_name) {
    const std::string_view numbers = without_unit(text, unit_name);
    const bool steps = numbers.find(':') != std::string_view::npos;
    if (const auto list = steps ? steps_from(numbers, range) : list_from(numbers, range))
        return *list;
    refuse_value(option, text,
                 fmt::format("ascending numbers A,B,… or FROM:TO:STEP with at most {} steps, {} {}",
                             kMostListed, range.text(), unit_name));
}

std::vector<std::string> parse_words(std::string_view option,
                                     const std::vector<std::string>& texts) {
    std::vector<std::string> words;
    for (const std::string& text : texts)
        for (const std::string_view word : split_at(text, ',')) {
            if (word.empty()) refuse_value(option, text, "a name, or several between commas");
            words.emplace_back(word);
        }
    return words;
}

Orders parse_orders(std::string_view option, const std::vector<std::string>& texts) {
    Orders orders;
    for (const std::string& text : texts)
        for (const std::string_view part : split_at(text, ',')) {
            const auto order = parse_number<int>(part);
            if (!order || *order < 0 || *order > kHighestOrder)
                refuse_value(option, text,
                             fmt::format("whole numbers from 0 to {} such as 2 or 2,3: the chords "
                                         "of the light in the drop",
                                         kHighestOrder));
            orders.push_back(*order);
        }
    return orders;
}

ComplexIndex parse_drop_index(std::string_view option, std::string_view text) {
    const auto parts = complex_parts(text);
    const auto n = number_in(parts ? parts->first : text, kDropIndices);
    const auto k = parts ? number_in(parts->second, kDropExtinctions) : std::optional(0.0);
    if (n && k) return {*n, *k};
    refuse_value(option, text,
                 fmt::format("n such as 1.333, or n+ki such as 1.33+1e-8i where the drop absorbs; "
                             "n above {} and at most {}, k {} to {}",
                             kDropIndices.low, kDropIndices.high, kDropExtinctions.low,
                             kDropExtinctions.high));
}

}  // namespace dewbow
