// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/diffuse_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/base/simd.h"
#include "dewbow/math/quadrature.h"

namespace dewbow {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kDegree = kDiffuseDegree, kLevels = kDiffuseLevels;
/// Directions in a hemisphere, then up (0 to 11) and down (12 to 23).
constexpr int kNodes = 12, kDirections = 2 * kNodes;
constexpr double kLastOrder = 1e-2;
constexpr int kMostOrders = 200;

/// Values of one azimuthal mode in all directions.
using Ring = std::array<double, kDirections>;
/// [mode][level]
using Field = std::vector<std::array<Ring, kLevels>>;

/// Sines of altitude, their weights, and the harmonics there.
struct Directions {
    Directions() {
        const QuadratureRule rule = gauss_legendre(kNodes);
        for (int i = 0; i < kNodes; ++i) {
            sine[i] = 0.5 + 0.5 * rule.nodes[i];
            sine[i + kNodes] = -sine[i];
            weight[i] = weight[i + kNodes] = 0.5 * rule.weights[i];
        }
        for (int i = 0; i < kNodes; ++i) legendre_harmonics(kDegree, sine[i], harmonic[i]);
    }
    Ring sine, weight;
    std::array<Harmonics, kNodes> harmonic;  ///< upwards
};

const Directions& directions() {
    static const Directions all;
    return all;
}

// Λ_l^m(−μ) = (−1)^(l−m) Λ_l^m(μ): up and down share their harmonics. `mode` is the place of the
// first of a mode's `count` harmonics, l = m, m + 1 …

/// Sums of coefficients times harmonics, in all directions.
DEWBOW_SIMD void sum_over_degrees(const Directions& all, std::size_t mode, int count,
                                  const double* coefficients, Ring& out) {
    for (int i = 0; i < kNodes; ++i) {
        const double* harmonic = &all.harmonic[i][mode];
        double even = 0.0, odd = 0.0;
        for (int l = 0; l < count; l += 2) even += coefficients[l] * harmonic[l];
        for (int l = 1; l < count; l += 2) odd += coefficients[l] * harmonic[l];
        out[i] = even + odd;
        out[i + kNodes] = even - odd;
    }
}

/// Sums over all directions of weighted values, for each harmonic.
DEWBOW_SIMD void sum_over_directions(const Directions& all, std::size_t mode, int count,
                                     const Ring& weighted, double* moments) {
    for (int l = 0; l < count; ++l) moments[l] = 0.0;
    for (int i = 0; i < kNodes; ++i) {
        const double* harmonic = &all.harmonic[i][mode];
        const double both[2] = {weighted[i] + weighted[i + kNodes],
                                weighted[i] - weighted[i + kNodes]};
        for (int l = 0; l < count; ++l) moments[l] += both[l & 1] * harmonic[l];
    }
}

/// How a layer passes light on at one slant: what enters, and a source that is linear between its
/// far and near side.
struct Pass {
    double through, far, near;
    double turn;  ///< radians that the level turns by on the way
};
Pass pass_of(double slant_depth, double turn) {
    const double t = slant_depth, e = std::exp(-t);
    const double mean = t > 1e-3 ? (1.0 - e) / t : 1.0 - 0.5 * t + t * t / 6.0;
    return {e, mean - e, 1.0 - mean, turn};
}

/// How far the level turns between two heights on a way up whose sine is known on the ground.
double turn_between(double low_m, double high_m, double sine) {
    const double middle = std::sqrt(sine * sine + (low_m + high_m) / kSkyRadius_m);
    return (high_m - low_m) * std::sqrt(1.0 - sine * sine) / (middle * kSkyRadius_m);
}

/// The air at one wavelength in levels.
struct Layers {
    explicit Layers(const AirOptics& optics) {
        const QuadratureRule rule = gauss_legendre(4);
        for (int k = 0; k < kLevels; ++k) {
            const AirParts here = air_density(diffuse_level_m(k));
            const double extinction = dot(optics.depth, here);
            air_share[k] = optics.depth.air * here.air / extinction;
            haze_share[k] = optics.haze_scattering * here.haze / extinction;
            if (k + 1 == kLevels) break;
            const AirParts mass = integrate(rule, diffuse_level_m(k), diffuse_level_m(k + 1),
                                            [](double h) { return air_density(h); });
            for (int i = 0; i < kNodes; ++i)
                pass[k][i] = pass_of(
                    dot(optics.depth, mass) / directions().sine[i],
                    turn_between(diffuse_level_m(k), diffuse_level_m(k + 1), directions().sine[i]));
        }
    }
    /// Of the extinction at a level, what air and what haze scatter.
    std::array<double, kLevels> air_share, haze_share;
    std::array<std::array<Pass, kNodes>, kLevels - 1> pass;  ///< between levels k and k + 1
};

/// Successive orders.
class Orders {
public:
    Orders(const AirOptics& optics, double asymmetry, double ground_albedo)
        : layers_(optics),
          air_(air_phase_moments()),
          haze_(haze_phase_moments(asymmetry)),
          albedo_(ground_albedo),
          field_(kDegree + 1) {}

    /// The next order: what the field's moments scatter and the ground sends back of `onto_ground`.
    void scatter(const std::vector<Harmonics>& moments, double onto_ground) {
        for (int m = 0; m <= kDegree; ++m) {
            std::array<Ring, kLevels> source;
            for (int k = 0; k < kLevels; ++k) source[k] = source_at(k, m, moments[k]);
            flow(source, m == 0 ? albedo_ / kPi * onto_ground : 0.0, field_[m]);
        }
    }

    /// Adds what comes on top since places towards the sun have a higher one, where sources have
    /// these moments more per radian: times the angle to them, s cos φ.
    void tilt(const std::vector<Harmonics>& slope) {
        for (int m = 0; m <= kDegree; ++m) {
            std::array<Ring, kLevels> source;
            for (int k = 0; k < kLevels; ++k) source[k] = source_at(k, m, slope[k]);
            // cos φ cos mφ = (cos (m + 1)φ + cos (m − 1)φ) / 2
            flow_from_afar(source, [&](int level, int i, double more) {
                if (m < kDegree) field_[m + 1][level][i] += (m == 0 ? 1.0 : 0.5) * more;
                if (m > 0) field_[m - 1][level][i] += 0.5 * more;
            });
        }
    }

    std::vector<Harmonics> moments() const {
        const Directions& all = directions();
        std::vector<Harmonics> moments(kLevels);
        for (int m = 0; m <= kDegree; ++m)
            for (int k = 0; k < kLevels; ++k) {
                Ring weighted;
                for (int i = 0; i < kDirections; ++i)
                    weighted[i] = 0.5 * all.weight[i] * field_[m][k][i];
                const std::size_t mode = harmonic_index(kDegree, m, m);
                sum_over_directions(all, mode, kDegree + 1 - m, weighted, &moments[k][mode]);
            }
        return moments;
    }

    double ground_irradiance() const {
        double sum = 0.0;
        for (int i = 0; i < kNodes; ++i)
            sum += 2.0 * kPi * directions().weight[i] * directions().sine[i] * field_[0][0][i];
        return sum;
    }

private:
    Ring source_at(int level, int m, const Harmonics& moments) const {
        const std::size_t mode = harmonic_index(kDegree, m, m);
        std::array<double, kDegree + 1> coefficients;
        for (int l = m; l <= kDegree; ++l)
            coefficients[l - m] =
                (layers_.air_share[level] * air_[l] + layers_.haze_share[level] * haze_[l]) *
                moments[mode + (l - m)];
        Ring ring;
        sum_over_degrees(directions(), mode, kDegree + 1 - m, coefficients.data(), ring);
        return ring;
    }

    /// Radiance from its sources: nothing from above, `ground` from below.
    void flow(const std::array<Ring, kLevels>& source, double ground,
              std::array<Ring, kLevels>& field) const {
        for (int i = 0; i < kNodes; ++i) field[kLevels - 1][i] = 0.0;
        for (int k = kLevels - 2; k >= 0; --k)
            for (int i = 0; i < kNodes; ++i) {
                const Pass& p = layers_.pass[k][i];
                field[k][i] =
                    p.through * field[k + 1][i] + p.far * source[k + 1][i] + p.near * source[k][i];
            }
        for (int i = kNodes; i < kDirections; ++i) field[0][i] = ground;
        for (int k = 1; k < kLevels; ++k)
            for (int i = kNodes; i < kDirections; ++i) {
                const Pass& p = layers_.pass[k - 1][i - kNodes];
                field[k][i] =
                    p.through * field[k - 1][i] + p.far * source[k - 1][i] + p.near * source[k][i];
            }
    }

    /// Radiance from sources, each times the angle over the sphere to it, given to `add`.
    template <class Add>
    void flow_from_afar(const std::array<Ring, kLevels>& source, const Add& add) const {
        for (int i = 0; i < kDirections; ++i) {
            const bool up = i < kNodes;
            double plain = 0.0, afar = 0.0;
            for (int step = 1; step < kLevels; ++step) {
                const int level = up ? kLevels - 1 - step : step,
                          before = up ? level + 1 : level - 1;
                const Pass& p = layers_.pass[up ? level : before][up ? i : i - kNodes];
                const double mean = 0.5 * (source[before][i] + source[level][i]);
                // What the layer itself sends comes from turn · ∫ (τ'/τ) e^−τ' dτ' = turn · far.
                afar = p.through * (afar + p.turn * plain) + p.turn * p.far * mean;
                plain = p.through * plain + p.far * source[before][i] + p.near * source[level][i];
                add(level, i, afar);
            }
        }
    }

    Layers layers_;
    PhaseMoments air_, haze_;
    double albedo_;
    Field field_;
};

void add(std::vector<Harmonics>& sum, double factor, const std::vector<Harmonics>& order) {
    for (int k = 0; k < kLevels; ++k)
        for (std::size_t n = 0; n < kDiffuseHarmonics; ++n) sum[k][n] += factor * order[k][n];
}

/// The largest mean radiance at any level.
double largest(const std::vector<Harmonics>& moments) {
    double most = 0.0;
    for (const Harmonics& level : moments) most = std::max(most, level[0]);
    return most;
}

}  // namespace

double diffuse_level_m(int k) {
    const double v = static_cast<double>(k) / (kLevels - 1);
    return kSkyTop_m * v * v * v;
}

PhaseMoments air_phase_moments() {
    constexpr double kAnisotropy = (1.0 - kAirAnisotropy) / (1.0 + 2.0 * kAirAnisotropy);
    PhaseMoments moments{};
    moments[0] = 1.0;
    moments[2] = 0.5 * kAnisotropy;
    return moments;
}

PhaseMoments haze_phase_moments(double asymmetry) {
    PhaseMoments moments;
    for (int l = 0; l <= kDegree; ++l) moments[l] = (2 * l + 1) * std::pow(asymmetry, l);
    return moments;
}

std::vector<Harmonics> beam_moments(const AirOptics& optics, const SunPlace& sun,
                                    const SunMasses& masses) {
    Harmonics towards;
    legendre_harmonics(kDegree, sun.sine, towards);
    for (int m = 0; m <= kDegree; ++m)
        for (int l = m; l <= kDegree; ++l)
            towards[harmonic_index(kDegree, m, l)] *= (m == 0 ? 1.0 : 2.0) / (4.0 * kPi);
    std::vector<Harmonics> moments(kLevels, Harmonics{});
    for (int k = 0; k < kLevels; ++k) {
        const double height = diffuse_level_m(k);
        const double beam = visible_share_of_sun(height, sun.sine) *
                            std::exp(-dot(optics.depth, masses.at(height, sun.sine)));
        for (std::size_t n = 0; n < kDiffuseHarmonics; ++n) moments[k][n] = beam * towards[n];
    }
    return moments;
}

DiffuseField diffuse_field(const AirOptics& optics, double asymmetry, double ground_albedo,
                           const std::vector<Harmonics>& beam, double onto_ground,
                           const std::vector<Harmonics>& slope) {
    DiffuseField field{std::vector<Harmonics>(kLevels, Harmonics{})};
    Orders orders(optics, asymmetry, ground_albedo);
    orders.scatter(beam, onto_ground);
    if (!slope.empty()) orders.tilt(slope);
    double before = 0.0;
    for (field.orders = 1; field.orders < kMostOrders; ++field.orders) {
        const std::vector<Harmonics> moments = orders.moments();
        const double reflected = orders.ground_irradiance(), now = largest(moments);
        const bool last = now < kLastOrder * largest(field.moments);
        // High orders are alike: each is the same share of the one before, and so is their sum.
        const double factor = last ? before / (before - now) : 1.0;
        add(field.moments, factor, moments);
        field.ground_irradiance += factor * reflected;
        if (last) break;
        before = now;
        orders.scatter(moments, reflected);
    }
    return field;
}

Harmonics DiffuseField::at(double height_m) const {
    const double y =
        std::clamp(std::cbrt(height_m / kSkyTop_m) * (kLevels - 1), 0.0, kLevels - 1.0);
    const int k = std::min(static_cast<int>(y), kLevels - 2);
    const double t = y - k;
    Harmonics between;
    for (std::size_t n = 0; n < between.size(); ++n)
        between[n] = (1.0 - t) * moments[k][n] + t * moments[k + 1][n];
    return between;
}

}  // namespace dewbow
