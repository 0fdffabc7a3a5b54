// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/spectra.h"

#include <fmt/format.h>

#include "dewbow/import/toml/table.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/illuminant.h"
#include "dewbow/spectrum/lamp.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow::toml_import {
namespace {

constexpr Range kTableWavelengths{200.0, 3000.0};
constexpr Range kLineWavelengths{kLambdaMin_nm, kLambdaMax_nm};
constexpr Range kLineWidths{0.01, 100.0};
constexpr Range kBlackbodyRange{500.0, 1e6};

bool is_light(SpectrumUse use) {
    return use == SpectrumUse::radiance || use == SpectrumUse::intensity ||
           use == SpectrumUse::irradiance;
}

bool may_be_colour(SpectrumUse use) { return is_light(use) || use == SpectrumUse::share; }

const Range& range_of(SpectrumUse use) {
    return use == SpectrumUse::share ? kShareRange : kAmountRange;
}

SpectrumPtr spectrum_of_rgb(const TomlDocument& document, const TomlValue& value,
                            std::string_view name, SpectrumUse use) {
    if (!may_be_colour(use)) {
        fail(document, value.place, fmt::format("{} is no colour", name),
             use == SpectrumUse::absorption ? "write a number, { lambda_nm, values }, or "
                                              "absorption_colour with absorption_depth_mm"
                                            : "write a number or { lambda_nm, values }");
    }
    const Vec3 v = read_vec3(document, value, name, range_of(use));
    const Colour<LinearSrgb> rgb{{v.x, v.y, v.z}};
    return is_light(use) ? make_emission(rgb) : make_reflectance(rgb);
}

SpectrumPtr illuminant_of(const TomlDocument& document, const TomlValue& value) {
    const std::vector<std::string> names = illuminant_names();
    return find_illuminant(names[read_choice(document, value, "illuminant", names)]);
}

SpectrumPtr lamp_of(const TomlDocument& document, const TomlValue& value, std::string_view key) {
    const std::string& name = read_text(document, value, key);
    return at_place(document, value.place, [&] { return find_lamp(name).spectrum; });
}

SpectrumPtr tabulated_of(Table& table, const TomlValue& lambdas, SpectrumUse use) {
    const TomlDocument& document = table.document();
    std::vector<double> lambda_nm = read_numbers(document, lambdas, "lambda_nm", kTableWavelengths);
    const TomlValue& values_value = table.require("values");
    std::vector<double> values =
        read_numbers(document, values_value, "values", range_of(use), lambda_nm.size());
    for (std::size_t i = 1; i < lambda_nm.size(); ++i) {
        if (lambda_nm[i] > lambda_nm[i - 1]) continue;
        fail(document, (*lambdas.array())[i].place,
             fmt::format("lambda_nm[{}] is {} after {}; wavelengths must ascend", i, lambda_nm[i],
                         lambda_nm[i - 1]));
    }
    return make_tabulated(std::move(lambda_nm), std::move(values),
                          is_light(use) ? OutsideTable::zero : OutsideTable::hold);
}

SpectrumPtr lines_of(Table& table, const TomlValue& centres_value) {
    const TomlDocument& document = table.document();
    const std::vector<double> centres =
        read_numbers(document, centres_value, "lines_nm", kLineWavelengths);
    const std::vector<double> strengths = read_numbers(document, table.require("strengths"),
                                                       "strengths", kAmountRange, centres.size());
    std::vector<Line> lines;
    for (std::size_t i = 0; i < centres.size(); ++i) {
        lines.push_back({centres[i] * unit::nm, strengths[i]});
    }
    return make_lines(std::move(lines), table.number("width_nm", kLineWidths, 1.0) * unit::nm);
}

SpectrumPtr light_of(Table& table) {
    const TomlDocument& document = table.document();
    if (const TomlValue* name = table.find("illuminant")) return illuminant_of(document, *name);
    if (const TomlValue* name = table.find("lamp")) return lamp_of(document, *name, "lamp");
    if (const TomlValue* kelvin = table.find("blackbody_K")) {
        return make_blackbody(read_number(document, *kelvin, "blackbody_K", kBlackbodyRange) *
                              unit::K);
    }
    if (const TomlValue* centres = table.find("lines_nm")) return lines_of(table, *centres);
    return nullptr;
}

const char* photometric_key(SpectrumUse use) {
    switch (use) {
        case SpectrumUse::intensity:
            return "intensity_cd";
        case SpectrumUse::irradiance:
            return "illuminance_lx";
        default:
            return "luminance_cd_m2";
    }
}

SpectrumPtr scaled(Table& table, SpectrumPtr spectrum, SpectrumUse use) {
    const char* photometric = photometric_key(use);
    if (is_light(use)) table.at_most_one_of({"scale", photometric});
    if (const auto factor = table.find_number("scale", kAmountRange)) {
        return make_scaled(std::move(spectrum), *factor);
    }
    if (!is_light(use)) return spectrum;
    const auto photometric_size = table.find_number(photometric, kAmountRange);
    if (!photometric_size) return spectrum;
    const double own = kLuminousEfficacy * xyz_from_spectrum(*spectrum)[1];
    if (own <= 0.0)
        table.fail_here(fmt::format("is black, so that it cannot have {}", photometric));
    return make_scaled(std::move(spectrum), *photometric_size / own);
}

SpectrumPtr spectrum_of_table(const TomlDocument& document, const TomlValue& value,
                              std::string_view name, SpectrumUse use) {
    Table table(document, value, fmt::format("the spectrum of {}", name));
    SpectrumPtr spectrum;
    if (use != SpectrumUse::share) table.find("scale");  // read below
    if (is_light(use)) {
        table.at_most_one_of({"rgb", "illuminant", "lamp", "blackbody_K", "lambda_nm", "lines_nm"});
        spectrum = light_of(table);
    }
    if (!spectrum) {
        if (const TomlValue* lambdas = table.find("lambda_nm")) {
            spectrum = tabulated_of(table, *lambdas, use);
        } else if (!may_be_colour(use)) {
            table.finish();
            table.fail_here("needs lambda_nm and values");
        } else if (const TomlValue* rgb = table.find("rgb")) {
            spectrum = spectrum_of_rgb(document, *rgb, "rgb", use);
        } else {
            table.finish();
            table.fail_here(
                is_light(use)
                    ? "needs one of rgb, illuminant, lamp, blackbody_K, lambda_nm, lines_nm"
                    : "needs lambda_nm and values, or rgb");
        }
    }
    if (use != SpectrumUse::share) spectrum = scaled(table, std::move(spectrum), use);
    table.finish();
    return spectrum;
}

}  // namespace

SpectrumPtr read_spectrum(const TomlDocument& document, const TomlValue& value,
                          std::string_view name, SpectrumUse use) {
    if (value.table()) return spectrum_of_table(document, value, name, use);
    if (value.array()) return spectrum_of_rgb(document, value, name, use);
    if (value.text() && is_light(use)) return lamp_of(document, value, name);
    return make_constant(read_number(document, value, name, range_of(use)));
}

}  // namespace dewbow::toml_import
