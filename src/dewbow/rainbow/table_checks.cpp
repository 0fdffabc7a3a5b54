// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/table_checks.h"

#include <fmt/format.h>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

using namespace unit;

/// Wavelengths that are asked for: where waves in water are what they are here.
constexpr Wavelength kShortest = 100.0 * nm, kLongest = 20000.0 * nm;

}  // namespace

void check_wavelengths(const std::vector<Wavelength>& wavelengths) {
    if (wavelengths.empty()) throw InputError("no wavelengths; expected at least one");
    for (std::size_t i = 0; i < wavelengths.size(); ++i) {
        const double value = wavelengths[i].to(nm);
        if (!(wavelengths[i] >= kShortest && wavelengths[i] <= kLongest))
            throw InputError(fmt::format("wavelength {:.6g} nm; expected {:.6g} to {:.6g} nm",
                                         value, kShortest.to(nm), kLongest.to(nm)));
        if (i > 0 && !(wavelengths[i] > wavelengths[i - 1]))
            throw InputError(
                fmt::format("wavelength {:.6g} nm after {:.6g} nm; expected ascending ones", value,
                            wavelengths[i - 1].to(nm)));
    }
}

void check_scattering_angles(const std::vector<Angle>& angles) {
    if (angles.empty()) throw InputError("no angles; expected at least one");
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const double value = angles[i].to(deg);
        if (!(angles[i] >= 0.0 * deg && angles[i] <= 180.0 * deg))
            throw InputError(
                fmt::format("scattering angle {:.6g} deg; expected 0 to 180 deg", value));
        if (i > 0 && !(angles[i] > angles[i - 1]))
            throw InputError(
                fmt::format("scattering angle {:.6g} deg after {:.6g} deg; expected ascending ones",
                            value, angles[i - 1].to(deg)));
    }
}

}  // namespace dewbow
