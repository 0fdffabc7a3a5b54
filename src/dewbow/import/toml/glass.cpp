// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/glass.h"

#include <array>

#include "dewbow/import/glass/glass_file.h"
#include "dewbow/import/named_glass.h"
#include "dewbow/import/toml/spectra.h"
#include "dewbow/optics/paper_index.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow::toml_import {
namespace {

constexpr Range kIndexRange{1.0, 10.0};
constexpr Range kAbbeRange{1.0, 1e6};
constexpr Range kDispersivePowerRange{0.0, 1e3};
constexpr Range kRangeRange{1.0, 1e9};  ///< wavelengths in nm
constexpr Range kTransmittanceRange{0.0, 1.0, true, false};
constexpr Range kAnisotropyRange{-1.0, 1.0, true, true};

const std::vector<std::string>& form_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const DispersionForm& form : dispersion_forms()) all.push_back(form.name);
        return all;
    }();
    return names;
}

DispersionPtr glass_of(const TomlDocument& document, const TomlValue& value, Diagnostics* notes) {
    const std::string& name = read_text(document, value, "glass");
    const SourcePlace place{document.file, value.place.line, value.place.column, {}};
    return at_place(document, value.place, [&] {
        return is_glass_file_reference(name) ? glass_of_file(name, place, notes)
                                             : named_glass(name, place, notes);
    });
}

DispersionPtr formula_of(const TomlDocument& document, const TomlValue& value) {
    static const std::array<std::string, 2> kReferences = {"air", "vacuum"};
    Table table(document, value, "dispersion");
    const std::size_t form = read_choice(document, table.require("form"), "form", form_names());
    DispersionData data;
    data.form = form_names()[form];
    data.coefficients =
        read_numbers(document, table.require("coefficients"), "coefficients", kCoordinateRange);
    if (const TomlValue* reference = table.find("reference")) {
        const std::size_t which = read_choice(document, *reference, "reference", kReferences);
        data.reference = which == 0 ? IndexReference::air : IndexReference::vacuum;
    }
    if (const TomlValue* range = table.find("range_nm")) {
        const std::vector<double> ends = read_numbers(document, *range, "range_nm", kRangeRange);
        if (ends.size() != 2) table.fail_here("range_nm wants two wavelengths");
        data.range = DataRange{ends[0], ends[1]};
    }
    table.finish();
    return at_place(document, value.place, [&] { return make_dispersion(data); });
}

DispersionPtr number_of(Table& table, const TomlValue& value) {
    const double ior = read_number(table.document(), value, "ior", kIndexRange);
    const auto abbe = table.find_number("abbe", kAbbeRange);
    if (ior == 1.0) return air();
    const DispersionData data = abbe ? DispersionData{"abbe", {ior, *abbe}, IndexReference::air}
                                     : DispersionData{"constant", {ior}, IndexReference::air};
    return at_place(table.document(), value.place, [&] { return make_dispersion(data); });
}

/// The paper's index, of `eta_red` and `w`.
DispersionPtr paper_line_of(Table& table, const TomlValue& value) {
    const TomlDocument& document = table.document();
    const double eta_red = read_number(document, value, "eta_red", kIndexRange);
    const double w = table.require_number("w", kDispersivePowerRange);
    IndexReading reading = IndexReading::intended;
    SpectralSpacing spacing = SpectralSpacing::frequency;
    table.word("index_reading", index_reading_names(), reading);
    table.word("index_spacing", spectral_spacing_names(), spacing);
    return at_place(document, value.place,
                    [&] { return paper_index(eta_red, w, reading, spacing); });
}

SpectrumPtr read_absorption(Table& table) {
    table.at_most_one_of({"absorption_per_m", "absorption_colour"});
    const TomlDocument& document = table.document();
    if (const TomlValue* spectrum = table.find("absorption_per_m")) {
        return read_spectrum(document, *spectrum, "absorption_per_m", SpectrumUse::absorption);
    }
    const TomlValue* colour = table.find("absorption_colour");
    if (!colour) return nullptr;
    const Vec3 rgb = read_vec3(document, *colour, "absorption_colour", kTransmittanceRange);
    return make_absorption({{rgb.x, rgb.y, rgb.z}}, table.require_length("absorption_depth"));
}

void read_scattering(Table& table, Medium& medium) {
    const TomlValue* spectrum = table.find("scattering_per_m");
    const auto anisotropy = table.find_number("anisotropy", kAnisotropyRange);
    if (anisotropy && !spectrum) table.fail_here("has anisotropy, but no scattering_per_m");
    if (!spectrum) return;
    medium.scattering =
        read_spectrum(table.document(), *spectrum, "scattering_per_m", SpectrumUse::scattering);
    medium.phase = henyey_greenstein(anisotropy.value_or(0.0));
}

}  // namespace

DispersionPtr read_index(Table& table, Diagnostics* notes) {
    table.at_most_one_of({"glass", "dispersion", "ior", "eta_red"});
    for (const char* other : {"glass", "dispersion", "ior"})
        for (const char* key : {"w", "index_reading", "index_spacing"})
            table.at_most_one_of({other, key});
    if (const TomlValue* value = table.find("glass"))
        return glass_of(table.document(), *value, notes);
    if (const TomlValue* value = table.find("dispersion"))
        return formula_of(table.document(), *value);
    if (const TomlValue* value = table.find("ior")) return number_of(table, *value);
    if (const TomlValue* value = table.find("eta_red")) return paper_line_of(table, *value);
    table.fail_missing({"glass", "dispersion", "ior", "eta_red"},
                       "needs one of glass, dispersion, ior, eta_red");
}

MediumPtr read_medium(Table& table, const std::string& name, int priority, Diagnostics* notes) {
    auto medium = std::make_shared<Medium>();
    medium->name = name;
    medium->index = read_index(table, notes);
    medium->absorption = read_absorption(table);
    medium->priority = priority;
    read_scattering(table, *medium);
    return medium;
}

}  // namespace dewbow::toml_import
