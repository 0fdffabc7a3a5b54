// SPDX-License-Identifier: Apache-2.0
#include "dewbow/export/scattering_files.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "dewbow/image/exr.h"

namespace dewbow {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kMeaning =
    "phase function P of light polarised perpendicular and parallel to the scattering plane, and "
    "their mean; the mean integrates to 4 pi sr over the sphere: P / (4 pi) is per sr";
constexpr const char* kEfficiencies =
    "Q_ext, Q_sca: cross sections over the drops' mean geometric cross section; g: mean cosine of "
    "the scattering angle";

/// Degrees without what the way through radians adds.
double degrees_of(Angle angle) { return std::round(angle.to(unit::deg) * 1e12) / 1e12; }

std::string text_of(const Attribute& fact) {
    return std::visit([](const auto& value) { return fmt::format("{}", value); }, fact.value);
}

/// "model" of "dewbow:model".
std::string short_name(const Attribute& fact) { return fact.name.substr(fact.name.find(':') + 1); }

std::string one_line(std::string text) {
    for (char& c : text)
        if (c == '\n' || c == '\r') c = ' ';
    return text;
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

double square_mm(Area area) { return area / (unit::mm * unit::mm); }

Attributes with_report(const ScatteringTable& table, Attributes facts) {
    if (!table.report.empty()) facts.push_back({"dewbow:report", table.report});
    if (std::isfinite(table.stated_error))
        facts.push_back({"dewbow:statedError", table.stated_error});
    facts.push_back(
        {"dewbow:meanCrossSectionSquareMillimetres", square_mm(table.mean_cross_section)});
    return facts;
}

std::string head_of_csv(const ScatteringTable& table, const Attributes& facts) {
    std::string text;
    for (const Attribute& fact : with_report(table, facts))
        text += fmt::format("# {}: {}\n", short_name(fact), one_line(text_of(fact)));
    text += fmt::format("# {}\n# {}\n# wavelengths are in vacuum\n", kMeaning, kEfficiencies);
    for (std::size_t i = 0; i < table.wavelengths.size(); ++i) {
        const Efficiencies& q = table.efficiencies[i];
        text +=
            fmt::format("# {} nm: Q_ext {:.9g}, Q_sca {:.9g}, g {:.9g}\n",
                        table.wavelengths[i].to(unit::nm), q.extinction, q.scattering, q.asymmetry);
    }
    return text;
}

Json phase_json(const ScatteringTable& table, std::size_t wavelength,
                double (*part)(const Intensities&)) {
    Json values = Json::array();
    for (std::size_t i = 0; i < table.angles.size(); ++i)
        values.push_back(number(part(table.at(i, wavelength))));
    return values;
}

Json wavelength_json(const ScatteringTable& table, std::size_t i) {
    const Efficiencies& q = table.efficiencies[i];
    return {
        {"wavelength_nm", table.wavelengths[i].to(unit::nm)},
        {"Q_ext", number(q.extinction)},
        {"Q_sca", number(q.scattering)},
        {"g", number(q.asymmetry)},
        {"P_unpolarised",
         phase_json(table, i, [](const Intensities& p) { return p.unpolarised(); })},
        {"P_perpendicular",
         phase_json(table, i, [](const Intensities& p) { return p.perpendicular; })},
        {"P_parallel", phase_json(table, i, [](const Intensities& p) { return p.parallel; })},
    };
}

float or_zero(double value) { return std::isfinite(value) ? static_cast<float>(value) : 0.0f; }

std::string listed(const std::vector<double>& values) {
    std::string text;
    for (const double value : values) text += fmt::format("{}{}", text.empty() ? "" : " ", value);
    return text;
}

}  // namespace

std::string csv_of(const ScatteringTable& table, const Attributes& facts) {
    std::string text = head_of_csv(table, facts);
    text +=
        "wavelength_nm,scattering_angle_deg,angle_from_antisolar_deg,P_unpolarised,P_perpendicular,"
        "P_parallel\n";
    for (std::size_t j = 0; j < table.wavelengths.size(); ++j)
        for (std::size_t i = 0; i < table.angles.size(); ++i) {
            const Intensities& p = table.at(i, j);
            const double degrees = degrees_of(table.angles[i]);
            text += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n",
                                table.wavelengths[j].to(unit::nm), degrees, 180.0 - degrees,
                                p.unpolarised(), p.perpendicular, p.parallel);
        }
    return text;
}

std::string json_of(const ScatteringTable& table, const Attributes& facts) {
    Json json{{"facts", Json::object()},
              {"units", {{"P", kMeaning}, {"Q", kEfficiencies}, {"wavelength_nm", "in vacuum"}}}};
    for (const Attribute& fact : with_report(table, facts))
        std::visit([&](const auto& value) { json["facts"][short_name(fact)] = value; }, fact.value);
    Json angles = Json::array(), antisolar = Json::array(), wavelengths = Json::array();
    for (const Angle angle : table.angles) {
        angles.push_back(degrees_of(angle));
        antisolar.push_back(degrees_of(180.0 * unit::deg - angle));
    }
    for (std::size_t i = 0; i < table.wavelengths.size(); ++i)
        wavelengths.push_back(wavelength_json(table, i));
    json["scattering_angle_deg"] = std::move(angles);
    json["angle_from_antisolar_deg"] = std::move(antisolar);
    json["wavelengths"] = std::move(wavelengths);
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string exr_of(const ScatteringTable& table, const Attributes& facts) {
    const std::size_t width = table.angles.size(), height = table.wavelengths.size();
    Image image;
    image.width = static_cast<int>(width);
    image.height = static_cast<int>(height);
    const auto add = [&](const char* name, auto value_at) {
        Channel channel{name, std::vector<float>(width * height)};
        for (std::size_t y = 0; y < height; ++y)
            for (std::size_t x = 0; x < width; ++x)
                channel.values[y * width + x] = or_zero(value_at(x, y));
        image.channels.push_back(std::move(channel));
    };
    add("P.perpendicular",
        [&](std::size_t x, std::size_t y) { return table.at(x, y).perpendicular; });
    add("P.parallel", [&](std::size_t x, std::size_t y) { return table.at(x, y).parallel; });
    add("Q.extinction",
        [&](std::size_t, std::size_t y) { return table.efficiencies[y].extinction; });
    add("Q.scattering",
        [&](std::size_t, std::size_t y) { return table.efficiencies[y].scattering; });
    add("g", [&](std::size_t, std::size_t y) { return table.efficiencies[y].asymmetry; });

    Attributes attributes = with_report(table, facts);
    std::vector<double> angles, wavelengths;
    for (const Angle angle : table.angles) angles.push_back(degrees_of(angle));
    for (const Wavelength lambda : table.wavelengths) wavelengths.push_back(lambda.to(unit::nm));
    attributes.push_back({"dewbow:scatteringAnglesDegrees", listed(angles)});
    attributes.push_back({"dewbow:wavelengthsNanometres", listed(wavelengths)});
    attributes.push_back({"dewbow:meaning", std::string(kMeaning) + "; " + kEfficiencies});
    return encode_exr(image, attributes, {});
}

}  // namespace dewbow
