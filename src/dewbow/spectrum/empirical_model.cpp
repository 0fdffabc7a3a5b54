// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/empirical_model.h"

#include <algorithm>

#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/illuminant.h"
#include "dewbow/spectrum/primaries_matrix.h"

namespace dewbow {
namespace {

template <class Space>
using Nodes = std::array<Colour<Space>, kEmpiricalNodes>;

double node_nm(std::size_t i) {
    return (kEmpiricalViolet + double(i) * kEmpiricalStep).to(unit::nm);
}

/// ∫ dλ of what is linear between the nodes.
template <class Space>
Colour<Space> area_under(const Nodes<Space>& nodes) {
    Colour<Space> sum = 0.5 * (nodes.front() + nodes.back());
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i) sum = sum + nodes[i];
    return sum * kEmpiricalStep.to(unit::nm);
}

Nodes<Xyz> spectrum_under_b() {
    const SpectrumPtr b = find_illuminant("B");
    Nodes<Xyz> nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        nodes[i] = Colour<Xyz>{cie_xyz_bar(node_nm(i))} * (*b)(node_nm(i) * unit::nm);
    return nodes;
}

MonitorRgb without_negatives(MonitorRgb rgb, NegativeColours negative, const Triple& luminances) {
    const double least = std::min({rgb[0], rgb[1], rgb[2]});
    if (negative == NegativeColours::keep || least >= 0.0) return rgb;
    if (negative == NegativeColours::limit) {
        const double y = dot(luminances, rgb.v);
        for (double& channel : rgb.v) channel = y + (channel - y) * y / (y - least);
    }
    for (double& channel : rgb.v) channel = std::max(channel, 0.0);
    return rgb;
}

}  // namespace

EmpiricalCurves empirical_curves(const RgbPrimaries& monitor, NegativeColours negative,
                                 EmpiricalWhite white) {
    const Nodes<Xyz> xyz = spectrum_under_b();
    const Colour<Xyz> sum = area_under(xyz);
    const double per_luminance = 1.0 / sum[1];
    const Matrix3 xyz_from_monitor = white == EmpiricalWhite::monitor
                                         ? matrix_of_primaries(monitor)
                                         : matrix_of_primaries(monitor, (sum * per_luminance).v);
    const Matrix3 monitor_from_xyz = inverse(xyz_from_monitor);

    EmpiricalCurves curves{};
    for (std::size_t i = 0; i < curves.per_nm.size(); ++i) {
        const MonitorRgb rgb{monitor_from_xyz * (xyz[i] * per_luminance).v};
        curves.per_nm[i] = without_negatives(rgb, negative, xyz_from_monitor[1]);
    }
    curves.area = area_under(curves.per_nm).v;
    for (MonitorRgb& rgb : curves.per_nm)
        for (std::size_t c = 0; c < 3; ++c) rgb[c] /= curves.area[c];
    return curves;
}

MonitorRgb EmpiricalCurves::at(Wavelength lambda) const {
    const double place = (lambda - kEmpiricalViolet) / kEmpiricalStep;
    // A wavelength worked out from f may lie a rounding beyond the ends.
    constexpr double kRounding = 1e-9, kLast = kEmpiricalNodes - 1;
    if (!(place >= -kRounding && place <= kLast + kRounding)) return {};
    const double within = std::clamp(place, 0.0, kLast);
    const std::size_t i = std::min(std::size_t(within), std::size_t(kEmpiricalNodes - 2));
    const double t = within - double(i);
    return (1.0 - t) * per_nm[i] + t * per_nm[i + 1];
}

}  // namespace dewbow
