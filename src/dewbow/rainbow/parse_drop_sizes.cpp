// SPDX-License-Identifier: Apache-2.0

// The text form of drop sizes: kind:name,key=value,…

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "dewbow/base/error.h"
#include "dewbow/base/parse_number.h"
#include "dewbow/rainbow/drop_sizes.h"

namespace dewbow {
namespace {

using namespace unit;

constexpr std::string_view kForms =
    "expected a radius such as 0.5mm, or one of normal, lognormal, gamma, deirmendjian, fog, rain "
    "with its parameters, such as normal:mean=0.5mm,width=10%";

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// "12.5mm" as number and unit; nothing without a number in front.
std::optional<std::pair<double, std::string_view>> number_and_unit(std::string_view text) {
    for (std::size_t length = text.size(); length > 0; --length)
        if (const auto number = parse_number<double>(text.substr(0, length)))
            return std::pair{*number, trimmed(text.substr(length))};
    return std::nullopt;
}

Length parse_radius(std::string_view text, std::string_view key) {
    static const std::vector<std::pair<std::string, Length>> units = {
        {"nm", 1e-9 * m}, {"um", um}, {"µm", um}, {"μm", um}, {"mm", mm}, {"cm", cm}, {"m", m}};
    const auto parsed = number_and_unit(text);
    if (!parsed)
        throw InputError(
            fmt::format("{} \"{}\" is no length; expected one such as 0.5mm or 10um", key, text));
    const auto [number, unit_name] = *parsed;
    std::vector<std::string> names;
    for (const auto& [name, unit] : units) {
        if (name == unit_name) return number * unit;
        names.push_back(name);
    }
    throw InputError(
        unit_name.empty()
            ? fmt::format("{} {} has no unit; expected one such as {}mm", key, text, text)
            : fmt::format("{} {} has the unknown unit \"{}\"", key, text, unit_name),
        unit_name.empty() ? "" : hint_for(unit_name, names));
}

double parse_share(std::string_view text, std::string_view key) {
    const auto parsed = number_and_unit(text);
    if (parsed && parsed->second.empty()) return parsed->first;
    if (parsed && parsed->second == "%") return 0.01 * parsed->first;
    throw InputError(
        fmt::format("{} \"{}\" is no share; expected one such as 10% or 0.1", key, text));
}

double parse_rate(std::string_view text, std::string_view key) {
    const auto parsed = number_and_unit(text);
    if (parsed && parsed->second == "mm/h") return parsed->first;
    throw InputError(
        fmt::format("{} \"{}\" is no rain rate; expected one such as 5mm/h", key, text));
}

double parse_plain(std::string_view text, std::string_view key) {
    if (const auto number = parse_number<double>(text)) return *number;
    throw InputError(fmt::format("{} \"{}\" is no number", key, text));
}

/// What stands after the colon. Each getter takes its item away; what is left at the end is an
/// error.
class Items {
public:
    Items(std::string_view kind, std::string_view text) : kind_(kind) {
        while (!trimmed(text).empty()) {
            const auto comma = std::min(text.find(','), text.size());
            const std::string_view item = trimmed(text.substr(0, comma));
            const auto equals = item.find('=');
            if (equals == std::string_view::npos)
                items_.push_back({"", item});
            else
                items_.push_back(
                    {trimmed(item.substr(0, equals)), trimmed(item.substr(equals + 1))});
            text.remove_prefix(std::min(comma + 1, text.size()));
        }
    }

    /// The name without `=`, one of `names`, or empty if it is left out.
    std::string_view name(const std::vector<std::string>& names) {
        const auto found = find("");
        if (!found) return {};
        if (std::find(names.begin(), names.end(), *found) == names.end())
            throw InputError(fmt::format("unknown {} \"{}\"", kind_, *found),
                             hint_for(*found, names));
        return *found;
    }

    bool has(std::string_view key) const {
        return std::any_of(items_.begin(), items_.end(),
                           [&](const auto& item) { return item.first == key; });
    }

    template <class Parse>
    auto value(std::string_view key, const Parse& parse, const char* example) {
        expected_.emplace_back(key);
        const auto text = find(key);
        if (!text)
            throw InputError(fmt::format("{} drop sizes without {}; expected one such as {}={}",
                                         kind_, key, key, example),
                             misspelt(key));
        return parse(*text, key);
    }

    void end() const {
        if (items_.empty()) return;
        const auto& [key, text] = items_.front();
        if (key.empty())
            throw InputError(fmt::format("\"{}\" has no place in {} drop sizes", text, kind_),
                             hint_for(text, expected_));
        throw InputError(
            fmt::format("{} drop sizes have no {}, or not with the others or twice", kind_, key),
            hint_for(key, expected_));
    }

private:
    std::optional<std::string_view> find(std::string_view key) {
        const auto item = std::find_if(items_.begin(), items_.end(),
                                       [&](const auto& i) { return i.first == key; });
        if (item == items_.end()) return std::nullopt;
        const std::string_view text = item->second;
        items_.erase(item);
        return text;
    }
    /// A hint if an item is nearly called `key`.
    std::string misspelt(std::string_view key) const {
        const std::vector<std::string> right = {std::string(key)};
        for (const auto& [name, text] : items_)
            if (!nearest_word(name, right).empty())
                return fmt::format("\"{}\" is nearly {}", name, key);
        return {};
    }

    std::string_view kind_;
    std::vector<std::pair<std::string_view, std::string_view>> items_;
    std::vector<std::string> expected_;
};

DropSizesPtr parse_normal(Items& items) {
    const Length mean = items.value("mean", parse_radius, "0.5mm");
    return normal_drop_sizes(mean, items.value("width", parse_share, "10%"));
}

DropSizesPtr parse_lognormal(Items& items) {
    const Length mean = items.value("mean", parse_radius, "0.5mm");
    return lognormal_drop_sizes(mean, items.value("width", parse_share, "10%"));
}

DropSizesPtr parse_gamma(Items& items) {
    if (items.has("effective-radius") || items.has("effective-variance")) {
        const Length radius = items.value("effective-radius", parse_radius, "10um");
        return effective_gamma_drop_sizes(radius,
                                          items.value("effective-variance", parse_share, "0.1"));
    }
    const Length mean = items.value("mean", parse_radius, "0.5mm");
    return gamma_drop_sizes(mean, items.value("width", parse_share, "10%"));
}

struct NamedGamma {
    std::string name;
    double alpha, gamma, mode_um;
};

const NamedGamma& find_named(const std::vector<NamedGamma>& rows, std::string_view name) {
    return *std::find_if(rows.begin(), rows.end(),
                         [&](const auto& row) { return row.name == name; });
}

std::vector<std::string> names_of(const std::vector<NamedGamma>& rows) {
    std::vector<std::string> names;
    for (const NamedGamma& row : rows) names.push_back(row.name);
    return names;
}

DropSizesPtr parse_deirmendjian(Items& items) {
    // Given there as b, which is α / (γ r_c^γ): 1.5, 8.9443 and 15.1186 with r in µm.
    //                                                                  [Deirmendjian 1969, p. 78]
    static const std::vector<NamedGamma> rows = {
        {"cloud-c1", 6.0, 1.0, 4.0}, {"haze-m", 1.0, 0.5, 0.05}, {"haze-l", 2.0, 0.5, 0.07}};
    const std::string_view name = items.name(names_of(rows));
    if (!name.empty()) {
        const NamedGamma& row = find_named(rows, name);
        return deirmendjian_drop_sizes(row.alpha, row.gamma, row.mode_um * um);
    }
    const double alpha = items.value("alpha", parse_plain, "6");
    const double gamma = items.value("gamma", parse_plain, "1");
    return deirmendjian_drop_sizes(alpha, gamma, items.value("mode", parse_radius, "4um"));
}

DropSizesPtr parse_fog(Items& items) {
    //           [Rasshofer, Spies & Spies, Adv. Radio Sci. 9, 49 (2011), after Vasseur & Gibbins
    //           1996]
    static const std::vector<NamedGamma> rows = {{"strong-advection", 3.0, 1.0, 10.0},
                                                 {"moderate-advection", 3.0, 1.0, 8.0},
                                                 {"strong-spray", 6.0, 1.0, 4.0},
                                                 {"moderate-spray", 6.0, 1.0, 2.0}};
    const std::vector<std::string> names = names_of(rows);
    const std::string_view name = items.name(names);
    if (name.empty())
        throw InputError("fog without its kind; expected one such as fog:strong-advection",
                         hint_for("", names));
    const NamedGamma& row = find_named(rows, name);
    return deirmendjian_drop_sizes(row.alpha, row.gamma, row.mode_um * um);
}

DropSizesPtr parse_rain(Items& items) {
    const std::string_view name = items.name({"marshall-palmer", "ulbrich"});
    if (name.empty())
        throw InputError(
            "rain without its law; expected rain:marshall-palmer,rate=5mm/h or "
            "rain:ulbrich,rate=5mm/h,shape=2");
    const double rate = items.value("rate", parse_rate, "5mm/h");
    if (name == "marshall-palmer") return marshall_palmer_drop_sizes(rate);
    return ulbrich_drop_sizes(rate, items.value("shape", parse_plain, "2"));
}

}  // namespace

DropSizesPtr parse_drop_sizes(std::string_view text) {
    static const std::vector<std::pair<std::string, DropSizesPtr (*)(Items&)>> kinds = {
        {"normal", parse_normal}, {"lognormal", parse_lognormal},
        {"gamma", parse_gamma},   {"deirmendjian", parse_deirmendjian},
        {"fog", parse_fog},       {"rain", parse_rain}};
    const std::string_view whole = trimmed(text);
    const auto colon = whole.find(':');
    const std::string_view kind = trimmed(whole.substr(0, colon));
    if (kind.empty()) throw InputError("no drop sizes", std::string(kForms));

    std::vector<std::string> names;
    for (const auto& [name, parse] : kinds) {
        names.push_back(name);
        if (name != kind) continue;
        Items items(kind, colon == std::string_view::npos ? "" : whole.substr(colon + 1));
        const DropSizesPtr sizes = parse(items);
        items.end();
        return sizes;
    }
    if (colon == std::string_view::npos && number_and_unit(kind))
        return single_drop_size(parse_radius(kind, "radius"));
    const std::string near = nearest_word(kind, names);
    throw InputError(
        fmt::format("unknown drop sizes \"{}\"", kind),
        near.empty() ? std::string(kForms) : fmt::format("did you mean \"{}\"?", near));
}

}  // namespace dewbow
