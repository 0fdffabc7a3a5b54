// SPDX-License-Identifier: Apache-2.0
#include "aliasing/prisms.h"

#include <cmath>
#include <functional>

#include "dewbow/optics/catalogue.h"
#include "dewbow/optics/equivalents.h"
#include "dewbow/optics/paper_index.h"

namespace dewbow::bench {
namespace {

constexpr double kDegrees = 60.0;  ///< arc minutes

struct Substance {
    const char* name;
    const char* glass;
    double times;  ///< its dispersive power, by which its slope is multiplied
};
constexpr Substance kSubstances[] = {
    {"water", "fluid/water", 1.0},    {"BK7", "schott/N-BK7", 1.0},
    {"F2", "schott/F2", 1.0},         {"SF11", "schott/SF11", 1.0},
    {"2 × SF11", "schott/SF11", 2.0}, {"4 × SF11", "schott/SF11", 4.0},
};

double against_air(const Dispersion& dispersion, Wavelength lambda) {
    return dispersion(lambda).value / (*air())(lambda).value;
}

using Slope = std::function<double(const Dispersion&, double eta_red, double w)>;

std::vector<Prism> prisms(Angle apex, const Slope& slope_of) {
    std::vector<Prism> result;
    for (const Substance& substance : kSubstances) {
        const DispersionPtr dispersion = make_dispersion(find_glass(substance.glass).data);
        Prism prism;
        prism.name = substance.name;
        prism.w = substance.times * dispersive_power(index_in_air(dispersion));
        prism.eta_red = against_air(*dispersion, kPaperRed);
        prism.slope =
            substance.times * slope_of(*dispersion, prism.eta_red, prism.w / substance.times);
        if (const auto spread = spread_arcmin(prism.eta_red, prism.slope, apex)) {
            prism.spread_arcmin = *spread;
            result.push_back(prism);
        }
    }
    return result;
}

}  // namespace

std::optional<double> spread_arcmin(double eta_red, double slope, Angle apex) {
    const double a = apex.to(unit::rad);
    const double incidence = std::asin((eta_red + 0.5 * slope) * std::sin(0.5 * a));
    const auto exit = [&](double n) {
        return std::asin(n * std::sin(a - std::asin(std::sin(incidence) / n)));
    };
    const double spread = exit(eta_red + slope) - exit(eta_red);
    if (!std::isfinite(spread)) return std::nullopt;
    return (spread * unit::rad).to(unit::deg) * kDegrees;
}

std::vector<Prism> real_prisms(Angle apex) {
    return prisms(apex, [](const Dispersion& dispersion, double eta_red, double) {
        return against_air(dispersion, kPaperViolet) - eta_red;
    });
}

std::vector<Prism> paper_prisms(Angle apex) {
    return prisms(apex, [](const Dispersion&, double eta_red, double w) {
        return linear_index(eta_red, w, IndexReading::intended).slope;
    });
}

}  // namespace dewbow::bench
