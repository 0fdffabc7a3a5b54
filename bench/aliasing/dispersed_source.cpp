// SPDX-License-Identifier: Apache-2.0
#include "aliasing/dispersed_source.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "dewbow/spectrum/spectral_samples.h"

namespace dewbow::bench {
namespace {

using Rgb = MonitorRgb;

constexpr double kBeyond = 8.0;  ///< standard deviations where a Gaussian's tail is below 1e-15
/// Steps along a picture, in standard deviations of the sharpest blur; the largest difference lies
/// within 1 % of the largest found.
constexpr double kStep = 0.5, kMargin = 4.0;

/// Φ, the integral of the normal distribution.
double phi(double z) {
    if (z < -kBeyond) return 0.0;
    if (z > kBeyond) return 1.0;
    return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}
/// J'' = Φ.
double phi_twice_integrated(double z) {
    if (z < -kBeyond) return 0.0;
    const double density = std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
    return 0.5 * ((z * z + 1.0) * phi(z) + z * density);
}

const SpectralModel& paper_colours() {
    static const SpectralModelPtr model = make_spectral_model({});
    return *model;
}
Colour<Opponent> opponent(Rgb rgb) { return opponent_from_xyz(paper_colours().xyz(rgb)); }

double blur(const Lobe& lobe, const Sight& sight) {
    return std::sqrt(lobe.sigma_arcmin * lobe.sigma_arcmin + sight.pixel * sight.pixel / 12.0);
}

/// Where the density of white bends, and by how much its slope changes there.
struct Bend {
    double f = 0.0;
    Colour<Opponent> change;
};
std::vector<Bend> bends() {
    std::vector<Bend> result;
    Colour<Opponent> before;
    for (int j = 0; j <= kPaperSamples; ++j) {
        const double f = double(j) / kPaperSamples, next = double(j + 1) / kPaperSamples;
        Colour<Opponent> slope;
        if (j < kPaperSamples)
            slope = double(kPaperSamples) *
                    opponent(paper_colours().density(next) - paper_colours().density(f));
        result.push_back({f, slope - before});
        before = slope;
    }
    return result;
}

/// A half plane's edge at angle 0 instead of the source: white for angles above.
Colour<Opponent> edge_in_the_limit(const Sight& sight, double angle) {
    static const std::vector<Bend> all = bends();
    Colour<Opponent> seen;
    for (std::size_t c = 0; c < 3; ++c)
        for (const Lobe& lobe : lobes(c)) {
            const double sigma = blur(lobe, sight), share = sigma / sight.spread;
            double sum = 0.0;
            for (const Bend& bend : all)
                sum +=
                    bend.change[c] * phi_twice_integrated((angle - sight.spread * bend.f) / sigma);
            seen[c] += lobe.weight * share * share * sum;
        }
    return seen;
}

struct Sample {
    double f = 0.0;
    Colour<Opponent> colour;
};

PreparedSpectralSampling sampling(int samples, Jitter jitter, bool correlated) {
    return {make_spectral_model({}), {samples, jitter, correlated, false}};
}
Sample seen(const SpectralSample& sample) { return {sample.f_index, opponent(sample.rgb)}; }

std::vector<Sample> fixed_samples(int samples) {
    const PreparedSpectralSampling prepared = sampling(samples, Jitter::none, false);
    std::vector<Sample> result;
    for (int k = 0; k < samples; ++k) result.push_back(seen(prepared.sample(k, 0.5)));
    return result;
}

Colour<Opponent> edge_with(const std::vector<Sample>& set, const Sight& sight, double angle) {
    Colour<Opponent> seen;
    for (std::size_t c = 0; c < 3; ++c)
        for (const Lobe& lobe : lobes(c)) {
            const double scale = 1.0 / blur(lobe, sight);
            for (const Sample& sample : set)
                seen[c] +=
                    lobe.weight * sample.colour[c] * phi((angle - sight.spread * sample.f) * scale);
        }
    return seen;
}

/// Angles at which a picture may differ from its limit: around both edges of the source.
std::vector<double> angles_at_edges(const Sight& sight) {
    const double sigma = blur(lobes(0)[0], sight), margin = kMargin * sigma;
    std::vector<double> angles;
    for (const double edge : {-0.5 * sight.source, 0.5 * sight.source}) {
        const double last = edge + sight.spread + margin;
        double angle = edge - margin;
        if (!angles.empty()) angle = std::max(angle, angles.back() + kStep * sigma);
        for (; angle <= last; angle += kStep * sigma) angles.push_back(angle);
    }
    return angles;
}

/// Mean and products of random colours.
struct Moments {
    double n = 0.0;
    Triple sum{};
    Matrix3 products;

    void add(const Colour<Opponent>& x) {
        n += 1.0;
        for (std::size_t i = 0; i < 3; ++i) {
            sum[i] += x[i];
            for (std::size_t j = 0; j < 3; ++j) products[i][j] += x[i] * x[j];
        }
    }
    double covariance(std::size_t i, std::size_t j) const {
        return products[i][j] / n - sum[i] / n * sum[j] / n;
    }
};
void add_covariance(Matrix3& total, const Moments& moments) {
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) total[i][j] += moments.covariance(i, j);
}

/// Places within an interval that stand for all.
constexpr int kPlaces = 64;

/// Covariance of one set's sum where the light at f counts by `lit(f)`.
template <class Lit>
Matrix3 set_covariance(int samples, bool correlated, const Lit& lit) {
    const PreparedSpectralSampling prepared = sampling(samples, Jitter::both, correlated);
    const auto at = [&](int k, int place) {
        const Sample sample = seen(prepared.sample(k, (place + 0.5) / kPlaces));
        return lit(sample.f) * sample.colour;
    };
    Matrix3 total;
    if (correlated) {
        Moments common;
        for (int place = 0; place < kPlaces; ++place) {
            Colour<Opponent> sum;
            for (int k = 0; k < samples; ++k) sum = sum + at(k, place);
            common.add(sum);
        }
        add_covariance(total, common);
        return total;
    }
    for (int k = 0; k < samples; ++k) {
        Moments own;
        for (int place = 0; place < kPlaces; ++place) own.add(at(k, place));
        add_covariance(total, own);
    }
    return total;
}

double visible_noise(Colour<Opponent> mean, const Matrix3& of_set, int sets, double pixel_arcmin) {
    Matrix3 of_pixel = of_set;
    for (Triple& row : of_pixel.rows)
        for (double& x : row) x /= sets;
    return rms_difference(mean, seen_covariance(of_pixel, pixel_arcmin));
}

}  // namespace

Colour<Opponent> seen_in_the_limit(const Sight& sight, double angle) {
    return edge_in_the_limit(sight, angle + 0.5 * sight.source) -
           edge_in_the_limit(sight, angle - 0.5 * sight.source);
}

Colour<Opponent> seen_with_samples(const Sight& sight, int samples, double angle) {
    const std::vector<Sample> set = fixed_samples(samples);
    return edge_with(set, sight, angle + 0.5 * sight.source) -
           edge_with(set, sight, angle - 0.5 * sight.source);
}

double aliasing(const Sight& sight, int samples) {
    const std::vector<Sample> set = fixed_samples(samples);
    double most = 0.0;
    for (const double angle : angles_at_edges(sight)) {
        const double left = angle + 0.5 * sight.source, right = angle - 0.5 * sight.source;
        const Colour<Opponent> limit =
            edge_in_the_limit(sight, left) - edge_in_the_limit(sight, right);
        const Colour<Opponent> seen = edge_with(set, sight, left) - edge_with(set, sight, right);
        most = std::max(most, visible_difference(seen, limit));
    }
    return most;
}

double noise(const Sight& sight, int samples, bool correlated, int sets) {
    constexpr int kAngles = 120;
    const double from = -0.5 * sight.source, to = sight.spread + 0.5 * sight.source;
    double most = 0.0;
    for (int i = 0; i <= kAngles; ++i) {
        const double angle = from + (to - from) * i / kAngles;
        const Matrix3 covariance = set_covariance(samples, correlated, [&](double f) {
            return std::abs(angle - sight.spread * f) <= 0.5 * sight.source ? 1.0 : 0.0;
        });
        most = std::max(
            most, visible_noise(seen_in_the_limit(sight, angle), covariance, sets, sight.pixel));
    }
    return most;
}

double noise_of_white(int samples, bool correlated, int sets, double pixel_arcmin) {
    const Matrix3 covariance = set_covariance(samples, correlated, [](double) { return 1.0; });
    return visible_noise(opponent({{1.0, 1.0, 1.0}}), covariance, sets, pixel_arcmin);
}

}  // namespace dewbow::bench
