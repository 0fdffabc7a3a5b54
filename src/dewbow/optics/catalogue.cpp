// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "dewbow/base/error.h"
#include "dewbow/base/named.h"
#include "dewbow/base/parse_number.h"
#include "dewbow/optics/embedded_data.h"
#include "dewbow/spectrum/csv_table.h"

namespace dewbow {
namespace {

constexpr std::string_view kExtinctionHeader = "name,lambda_nm_and_k,source";
constexpr double kFreezing_K = 273.15;

void add_extinction(std::vector<Glass>& glasses) {
    for (const auto& row : rows_of_csv(optics::data::extinction_csv(), kExtinctionHeader)) {
        const auto glass = std::find_if(glasses.begin(), glasses.end(),
                                        [&](const Glass& g) { return g.name == row[0]; });
        if (glass == glasses.end()) continue;
        const std::vector<double> numbers = numbers_of_field(row[1]);
        for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
            glass->k.push_back({numbers[i], numbers[i + 1]});
        glass->k_source = row[2];
    }
}

struct Catalogue {
    std::vector<Glass> glasses;
    std::size_t in_first_file = 0;
};

const Catalogue& catalogue() {
    static const Catalogue all = [] {
        Catalogue read;
        read.glasses = glasses_of_csv(optics::data::catalogue_csv(), "data/glasses/catalogue.csv");
        read.in_first_file = read.glasses.size();
        for (Glass& glass : glasses_of_csv(optics::data::makers_csv(), "data/glasses/makers.csv"))
            read.glasses.push_back(std::move(glass));
        add_extinction(read.glasses);
        return read;
    }();
    return all;
}

/// Names and aliases of some glasses, and whose they are.
struct Names {
    std::vector<std::string> names;
    std::vector<std::size_t> owner;

    explicit Names(std::size_t count) {
        const auto glasses = glass_catalogue().first(count);
        for (std::size_t i = 0; i < count; ++i) add(glasses[i].name, i);
        for (std::size_t i = 0; i < count; ++i)
            for (const std::string& alias : glasses[i].aliases) add(alias, i);
    }
    void add(const std::string& name, std::size_t glass) {
        names.push_back(name);
        owner.push_back(glass);
    }
};

std::size_t index_of(std::string_view name) {
    static const Names first(catalogue().in_first_file), all(glass_catalogue().size());
    if (const auto found = match_named(name, first.names)) return first.owner[*found];
    return all.owner[find_named("glass", name, all.names)];
}

/// "25C", "25°C", "25 C", "298.15K", in °C.
double temperature_C(std::string_view text) {
    std::string_view number = text;
    const bool kelvin = number.ends_with('K');
    for (const std::string_view unit : {"K", "C", "°", " "})
        if (number.ends_with(unit)) number.remove_suffix(unit.size());
    const auto value = parse_number<double>(number);
    if (!value || number.size() == text.size())
        throw InputError(
            fmt::format("\"{}\" is no temperature; expected one such as 25C or 298.15K", text));
    return kelvin ? *value - kFreezing_K : *value;
}

/// "35", "35 g/kg", in g/kg.
double salinity_g_kg(std::string_view text) {
    std::string_view number = text;
    for (const std::string_view unit : {"g/kg", " "})
        if (number.ends_with(unit)) number.remove_suffix(unit.size());
    while (number.starts_with(' ')) number.remove_prefix(1);
    if (const auto value = parse_number<double>(number)) return *value;
    throw InputError(fmt::format("\"{}\" is no salinity; expected one such as 35 (g/kg)", text));
}

/// Water by IAPWS' formula, with what salt adds to it.
Glass at_temperature(Glass glass, std::string_view text) {
    const bool is_sea = glass.name == "fluid/sea-water";
    if (glass.name != "fluid/water" && !is_sea)
        throw InputError(
            fmt::format("{} has no temperature: only fluid/water and fluid/sea-water can have one",
                        glass.name));
    const std::size_t comma = is_sea ? text.find(',') : std::string_view::npos;
    const double t = temperature_C(text.substr(0, comma));
    glass.aliases.clear();
    if (is_sea) {
        double salinity = glass.data.coefficients[1];
        if (comma != std::string_view::npos) salinity = salinity_g_kg(text.substr(comma + 1));
        glass.name += fmt::format("@{:.6g}C,{:.6g}", t, salinity);
        glass.description = fmt::format("sea water, {:.6g} °C, {:.6g} g/kg salt", t, salinity);
        glass.data.coefficients = {t, salinity};
        make_dispersion(glass.data);
        return glass;
    }
    glass.name += fmt::format("@{:.6g}C", t);
    glass.description = fmt::format("water, {:.6g} °C, 101325 Pa", t);
    glass.lambda_min_nm = 200.0;
    glass.lambda_max_nm = 1100.0;
    glass.data = {"water", {t}, IndexReference::vacuum, DataRange{200.0, 1100.0}};
    glass.n_d = glass.v_d = 0.0;
    glass.accuracy = 2e-5;
    glass.source = "IAPWS R9-97 (1997); density: G. S. Kell, J. Chem. Eng. Data 20, 97 (1975)";
    glass.licence = "published formula";
    make_dispersion(glass.data);  // the temperature is refused here, if it must be
    return glass;
}

}  // namespace

std::span<const Glass> glass_catalogue() { return catalogue().glasses; }

Glass find_glass(std::string_view name) {
    const std::size_t at = name.find('@');
    const Glass& glass = glass_catalogue()[index_of(name.substr(0, at))];
    if (at == std::string_view::npos) return glass;
    return at_temperature(glass, name.substr(at + 1));
}

}  // namespace dewbow
