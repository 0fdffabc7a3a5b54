// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a drop does to light, as one question that several models answer: how much of a plane wave
// does it send into each direction, in each polarisation?
//
// Conventions of Bohren & Huffman (1983): time factor e^{-iωt}, index n + ik with k >= 0,
// scattering angle θ = 0 forward. dσ/dΩ = |S|² / k² with the wave number k = 2π/λ in the medium
// around the drop; for light without polarisation |S|² is the mean of both.

#include <array>
#include <complex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dewbow/base/quantity.h"
#include "dewbow/optics/refraction.h"

namespace dewbow {

/// Index of a drop against what is around it: n + ik, n > 0, k >= 0.
struct ComplexIndex {
    double n = 1.0, k = 0.0;
    constexpr ComplexIndex(double n_, double k_) : n(n_), k(k_) {}
    constexpr ComplexIndex(RelativeIndex real) : n(real.value) {}
    constexpr bool is_real() const { return k == 0.0; }
    constexpr std::complex<double> value() const { return {n, k}; }
};

/// S_1 (E perpendicular to the scattering plane) and S_2 (parallel).   [Bohren & Huffman, eq. 3.12]
struct Amplitudes {
    std::complex<double> perpendicular, parallel;
};

/// |S_1|² and |S_2|², without dimension.
struct Intensities {
    double perpendicular = 0.0, parallel = 0.0;
    constexpr double unpolarised() const { return 0.5 * (perpendicular + parallel); }
};

/// Cross sections over πa², and the mean cosine of the scattering angle.
struct Efficiencies {
    double extinction = 0.0, scattering = 0.0;
    double asymmetry = 0.0;  ///< g
};

/// Orders of light in a drop: p = 0 is reflected outside, p >= 1 runs along p chords inside
/// (2 the primary bow, 3 the secondary).
inline constexpr int kHighestOrder = 7;
using Orders = std::vector<int>;

/// By how much a drop that is not a sphere turns the light of each order towards larger scattering
/// angles; zero for spheres. [order]                                 [Möbius 1910; see
/// drop_shape.h]
using BowShifts = std::array<Angle, kHighestOrder + 1>;

/// A drop as a model sees it.
struct Drop {
    double size_parameter = 0.0;  ///< x = 2πa/λ, λ in the medium around; a of the sphere of equal
                                  ///< volume
    BowShifts shifts{};
    bool is_sphere() const { return shifts == BowShifts{}; }
};

/// A model of scattering. Objects are immutable, and may be shared by threads.
class ScatteringModel {
public:
    virtual ~ScatteringModel() = default;
    /// Its row of scattering_models().
    virtual std::string_view name() const = 0;

    /// Intensities of `drops`, all of one index, at scattering angles `theta` (0 to 180°,
    /// ascending) into `out`: [drop][angle], row-major.
    ///
    /// Wave models give the value at the angle. Rays give the mean over the cell around it, which
    /// ends halfway to the neighbours (and at 0° and 180°): at the bow itself theirs is infinite.
    /// Where a model does not hold (see the model), it gives NaN; `mie`, `debye`, `descartes` and
    /// `auto` never do. Throws InputError for drops or indices that the model cannot treat.
    virtual void intensities(ComplexIndex index, std::span<const Drop> drops,
                             std::span<const Angle> theta, std::span<Intensities> out) const = 0;

    /// Throws InputError as above.
    virtual Efficiencies efficiencies(ComplexIndex index, const Drop& drop) const = 0;
};

/// A model that knows phases.
class AmplitudeModel : public ScatteringModel {
public:
    /// Amplitudes of one drop at `theta`, any angles in any order.
    virtual void amplitudes(ComplexIndex index, const Drop& drop, std::span<const Angle> theta,
                            std::span<Amplitudes> out) const = 0;
};

}  // namespace dewbow
