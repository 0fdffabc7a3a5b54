// SPDX-License-Identifier: Apache-2.0
#pragma once

// What Mie theory adds to the sum of orders: where that is not good enough, at few wavelengths and
// radii. Over Σ x² it is smooth in the wavelength, and falls like 1/x.

#include <span>
#include <vector>

#include "dewbow/rainbow/automatic_error.h"
#include "dewbow/rainbow/cloud_scattering.h"
#include "dewbow/rainbow/composition.h"
#include "dewbow/rainbow/wavelength_fit.h"

namespace dewbow {

/// The sum of orders for one cloud of spheres at any wavelength near a reference.
class SummedOrders {
public:
    SummedOrders(const Cloud& cloud, Wavelength reference, const CompositionFamily& compositions);
    /// With averages that are known already.
    SummedOrders(const Cloud& cloud, Wavelength reference, const CompositionFamily& compositions,
                 DropAverages averages)
        : cloud_(cloud),
          reference_(reference),
          compositions_(compositions),
          averages_(std::move(averages)) {}

    const DropAverages& averages() const { return averages_; }  ///< at the reference
    /// Size parameters over those at the reference.
    double ratio(Wavelength lambda) const;
    /// Σ share |S|².
    std::vector<Intensities> at(Wavelength lambda, std::span<const Angle> angles) const;

private:
    const Cloud& cloud_;
    Wavelength reference_;
    const CompositionFamily& compositions_;
    DropAverages averages_;
};

class MieCorrection {
public:
    /// @param budget_ns  CPU time that it may take, about: more of it buys more radii, and so less
    ///                   of the interference between orders that is left by chance.
    MieCorrection(const Cloud& cloud, const SummedOrders& orders,
                  std::span<const Wavelength> wavelengths, std::span<const Angle> angles,
                  std::span<const AngleRange> exact, double budget_ns);

    std::size_t node_count() const { return fit_.nodes().size(); }
    std::size_t radius_count() const { return radius_count_; }  ///< at each node
    /// Numbers of the angles that are corrected, and how much of it counts there.
    std::span<const std::size_t> corrected() const { return corrected_; }
    std::span<const double> weights() const { return weights_; }
    /// At angle corrected()[c] and wavelength number w, over Σ x²; not weighted.
    Intensities at(std::size_t w, std::size_t c) const;
    /// Adds it to Σ share |S|² [angle].
    void add(std::size_t w, double x_squared, std::span<Intensities> sum) const;
    Efficiencies efficiencies(std::size_t w) const;

private:
    DropSums at_node(std::size_t node, const Cloud& cloud, const SummedOrders& orders,
                     std::span<const Angle> angles) const;

    WavelengthFit fit_;
    std::size_t radius_count_ = 0;
    std::vector<std::size_t> corrected_;
    std::vector<double> weights_;
    std::vector<DropSums> nodes_;
};

/// Σ weights of efficiencies at nodes, and of intensities at angle number a over Σ x².
Efficiencies mixed_efficiencies(std::span<const DropSums> nodes, std::span<const double> weights);
Intensities mixed_intensities(std::span<const DropSums> nodes, std::span<const double> weights,
                              std::size_t a);

}  // namespace dewbow
