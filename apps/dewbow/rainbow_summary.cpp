// SPDX-License-Identifier: Apache-2.0
#include "rainbow_summary.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "dewbow/rainbow/drop_ray.h"
#include "rainbow_degrees.h"

namespace dewbow {
namespace {

using Json = nlohmann::ordered_json;

/// Where widths are measured: the ends of what is called visible.
constexpr Wavelength kViolet = 400.0 * unit::nm, kRed = 700.0 * unit::nm;
/// The brightest angle of a bow lies so far into the bright side of the ray of least deflection,
/// and no farther: half this for drops of 10 µm.
constexpr double kInside_deg = 12.0, kOutside_deg = 2.0;

struct Peak {
    double antisolar_deg = 0.0, phase = 0.0, polarisation = 0.0;
};

struct Bow {
    std::string name;
    int order = 2;
    double radius_deg = 0.0;  ///< of the ray of least deflection, around the antisolar point
    double width_deg = 0.0;   ///< between violet and red, of a point sun
    std::optional<Peak> peak;
};

/// Nothing where the table has no angles there, or the model knows nothing.
std::optional<Peak> peak_of(const ScatteringTable& table, const DescartesRay& bow) {
    const double from = bow.bright_side > 0 ? -kOutside_deg : -kInside_deg;
    const double to = bow.bright_side > 0 ? kInside_deg : kOutside_deg;
    std::optional<Peak> peak;
    for (std::size_t i = 0; i < table.angles.size(); ++i) {
        const double inside = (table.angles[i] - bow.scattering_angle).to(unit::deg);
        const Intensities& p = table.at(i, 0);
        if (inside < from || inside > to || !std::isfinite(p.unpolarised())) continue;
        if (peak && p.unpolarised() <= peak->phase) continue;
        peak = Peak{180.0 - degrees_of(table.angles[i]), p.unpolarised(),
                    (p.perpendicular - p.parallel) / (p.perpendicular + p.parallel)};
    }
    return peak;
}

Bow bow_of_order(const std::string& name, int order, const DropOptics& optics,
                 const ScatteringTable& table) {
    const auto ray = [&](Wavelength lambda) { return descartes_ray(optics.index(lambda), order); };
    const DescartesRay bow = ray(table.wavelengths.front());
    return {name, order, bow.radius().to(unit::deg),
            std::abs((ray(kRed).radius() - ray(kViolet).radius()).to(unit::deg)),
            peak_of(table, bow)};
}

std::vector<Bow> bows_of(const DropOptics& optics, const ScatteringTable& table) {
    std::vector<Bow> bows;
    const double n = optics.index(table.wavelengths.front()).value;
    if (n < 2.0) bows.push_back(bow_of_order("primary", 2, optics, table));
    if (n < 3.0) bows.push_back(bow_of_order("secondary", 3, optics, table));
    return bows;
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::string bow_text(const Bow& bow, Angle sun_altitude) {
    const double top = bow.radius_deg - degrees_of(sun_altitude);
    std::string text =
        fmt::format("{:<10}{:7.2f}°  {:9.2f}°", bow.name, bow.radius_deg, bow.width_deg);
    text += top > 0.0 ? fmt::format("  {:7.1f}°", top) : fmt::format("  {:>8}", "below");
    if (bow.peak)
        text += fmt::format("  {:9.2f}°  {:8.4g}  {:9.3f}", bow.peak->antisolar_deg,
                            bow.peak->phase, bow.peak->polarisation);
    return text + "\n";
}

}  // namespace

std::string summary_text(RainbowTables& tables) {
    const RainbowSetup& setup = tables.setup();
    const ScatteringTable& table = tables.get({kSodium}, whole_circle());
    const DropOptics& optics = setup.request.optics;
    const Wavelength lambda = table.wavelengths.front();
    const Efficiencies& q = table.efficiencies.front();
    std::string text =
        fmt::format("drops {}, n = {:.5f} at {:g} nm; sun {:g}° high, its disc {:.4g}° in radius\n",
                    setup.drops, optics.index(lambda).value, lambda.to(unit::nm),
                    degrees_of(setup.sun_altitude), degrees_of(setup.request.disc.radius));
    text += fmt::format("model {}: Q_ext {:.6g}, Q_sca {:.6g}, g {:.6g}\n", setup.models.front(),
                        q.extinction, q.scattering, q.asymmetry);
    if (!table.report.empty()) text += table.report + "\n";
    text += "\nbow        radius  400-700 nm       top   brightest         P  polarised\n";
    for (const Bow& bow : bows_of(optics, table)) text += bow_text(bow, setup.sun_altitude);
    return text +
           "radius: around the antisolar point, of the ray of least deflection; top: above the "
           "horizon;\nP: phase function, whose mean over the sphere is 1; polarised: its degree\n";
}

std::string summary_json(RainbowTables& tables, const std::vector<std::string>& files) {
    const RainbowSetup& setup = tables.setup();
    const ScatteringTable& table = tables.get({kSodium}, whole_circle());
    const Efficiencies& q = table.efficiencies.front();
    const Wavelength lambda = table.wavelengths.front();
    Json bows = Json::array();
    for (const Bow& bow : bows_of(setup.request.optics, table)) {
        Json json{{"name", bow.name},
                  {"order", bow.order},
                  {"radius_deg", bow.radius_deg},
                  {"width_400_700nm_deg", bow.width_deg},
                  {"top_above_horizon_deg", bow.radius_deg - degrees_of(setup.sun_altitude)}};
        if (bow.peak) {
            json["brightest_deg"] = bow.peak->antisolar_deg;
            json["phase_function"] = bow.peak->phase;
            json["degree_of_polarisation"] = number(bow.peak->polarisation);
        }
        bows.push_back(std::move(json));
    }
    const Json json{{"version", DEWBOW_VERSION},
                    {"model", setup.models.front()},
                    {"drops", setup.drops},
                    {"wavelength_nm", lambda.to(unit::nm)},
                    {"index", setup.request.optics.index(lambda).value},
                    {"sun_altitude_deg", degrees_of(setup.sun_altitude)},
                    {"sun_radius_deg", degrees_of(setup.request.disc.radius)},
                    {"Q_ext", number(q.extinction)},
                    {"Q_sca", number(q.scattering)},
                    {"g", number(q.asymmetry)},
                    {"report", table.report},
                    {"stated_error", number(table.stated_error)},
                    {"bows", bows},
                    {"files", files}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace dewbow
