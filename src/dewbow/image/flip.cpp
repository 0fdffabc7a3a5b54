// SPDX-License-Identifier: Apache-2.0
#include "dewbow/image/flip.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "dewbow/base/check.h"
#include "dewbow/base/error.h"
#include "dewbow/spectrum/lab.h"
#include "dewbow/spectrum/rgb.h"

// Numbers and symbols are those of the paper: §4.1 colour, §4.2 features, §4.3 both.

namespace dewbow {
namespace {

/// An opponent space that is linear in light: Y_y, c_x, c_z.
struct OpponentSpace {};

/// One number a pixel.
struct Plane {
    int width = 0, height = 0;
    std::vector<double> values;

    double at(int x, int y) const {
        const int column = std::clamp(x, 0, width - 1), row = std::clamp(y, 0, height - 1);
        return values[std::size_t(row) * std::size_t(width) + std::size_t(column)];
    }
};
using Planes = std::array<Plane, 3>;

/// Weights of the pixels -radius … radius.
struct Kernel {
    std::vector<double> weights;
    int radius() const { return int(weights.size() / 2); }
};

template <class Weight>
Kernel make_kernel(int radius, const Weight& weight) {
    Kernel kernel;
    for (int x = -radius; x <= radius; ++x) kernel.weights.push_back(weight(double(x)));
    return kernel;
}

Plane convolve(const Plane& plane, const Kernel& along_x, const Kernel& along_y) {
    Plane rows = plane, result = plane;
    const auto size = [&](int x, int y) {
        return std::size_t(y) * std::size_t(plane.width) + std::size_t(x);
    };
    for (int y = 0; y < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x) {
            double sum = 0.0;
            for (int k = -along_x.radius(); k <= along_x.radius(); ++k)
                sum += along_x.weights[std::size_t(k + along_x.radius())] * plane.at(x + k, y);
            rows.values[size(x, y)] = sum;
        }
    for (int y = 0; y < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x) {
            double sum = 0.0;
            for (int k = -along_y.radius(); k <= along_y.radius(); ++k)
                sum += along_y.weights[std::size_t(k + along_y.radius())] * rows.at(x, y + k);
            result.values[size(x, y)] = sum;
        }
    return result;
}

const Colour<Xyz>& white() {
    static const Colour<Xyz> value = xyz_from_rgb(Colour<LinearSrgb>{{1.0, 1.0, 1.0}});
    return value;
}

Colour<OpponentSpace> opponent_from_rgb(Colour<LinearSrgb> rgb) {
    const Colour<Xyz> xyz = xyz_from_rgb(rgb);
    const double x = xyz[0] / white()[0], y = xyz[1] / white()[1], z = xyz[2] / white()[2];
    return {{116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)}};
}

Colour<LinearSrgb> rgb_from_opponent(Colour<OpponentSpace> opponent) {
    const double y = (opponent[0] + 16.0) / 116.0;
    const double x = opponent[1] / 500.0 + y, z = y - opponent[2] / 200.0;
    return rgb_from_xyz<LinearSrgb>(Colour<Xyz>{{x * white()[0], y * white()[1], z * white()[2]}});
}

Planes opponent_planes(const Image& image) {
    Planes planes;
    std::array<const Channel*, 3> channels{image.find("R"), image.find("G"), image.find("B")};
    for (std::size_t c = 0; c < 3; ++c) {
        if (!channels[c]) throw InputError("FLIP compares pictures by their channels R, G and B");
        planes[c] = {image.width, image.height, {}};
    }
    for (std::size_t i = 0; i < channels[0]->values.size(); ++i) {
        Colour<LinearSrgb> rgb;
        for (std::size_t c = 0; c < 3; ++c) {
            const double value = double(channels[c]->values[i]);
            rgb[c] = std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : 0.0;
        }
        const Colour<OpponentSpace> opponent = opponent_from_rgb(rgb);
        for (std::size_t c = 0; c < 3; ++c) planes[c].values.push_back(opponent[c]);
    }
    return planes;
}

/// a √(π/b) exp(−π² x² / b), x in degrees: how contrast is passed on, by frequency a Gaussian.
struct Sensitivity {
    double a = 0.0, b = 1.0;
};
/// Table 1 of the paper: achromatic, red–green, blue–yellow, each a sum of two.
constexpr std::array<std::array<Sensitivity, 2>, 3> kSensitivities = {
    {{{{1.0, 0.0047}, {0.0, 1e-5}}},
     {{{1.0, 0.0053}, {0.0, 1e-5}}},
     {{{34.1, 0.04}, {13.5, 0.025}}}}};
/// The widest of them, which gives all kernels their radius of three standard deviations.
constexpr double kWidest = 0.04;

/// What the eye resolves of one channel.
Plane see(const Plane& plane, const std::array<Sensitivity, 2>& sensitivities,
          double pixels_per_degree) {
    using std::numbers::pi;
    const int radius =
        int(std::ceil(3.0 * std::sqrt(kWidest / (2.0 * pi * pi)) * pixels_per_degree));
    Plane seen{plane.width, plane.height, std::vector<double>(plane.values.size(), 0.0)};
    double total = 0.0;
    for (const Sensitivity& s : sensitivities) {
        if (s.a == 0.0) continue;
        const Kernel kernel = make_kernel(radius, [&](double x) {
            const double degrees = x / pixels_per_degree;
            return std::exp(-pi * pi * degrees * degrees / s.b);
        });
        double sum = 0.0;
        for (const double weight : kernel.weights) sum += weight;
        const double scale = s.a * std::sqrt(pi / s.b);
        total += scale * sum * sum;
        const Plane part = convolve(plane, kernel, kernel);
        for (std::size_t i = 0; i < part.values.size(); ++i)
            seen.values[i] += scale * part.values[i];
    }
    for (double& value : seen.values) value /= total;
    return seen;
}

/// L*a*b* with the chroma scaled by 0.01 L*, for the effect of Hunt.
Colour<CieLab> hunt_lab(Colour<LinearSrgb> rgb) {
    Colour<CieLab> lab = lab_from_xyz(xyz_from_rgb(rgb), white());
    lab[1] *= 0.01 * lab[0];
    lab[2] *= 0.01 * lab[0];
    return lab;
}

double hyab(Colour<CieLab> a, Colour<CieLab> b) {
    return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

constexpr double kColourExponent = 0.7;      ///< q_c
constexpr double kKnee = 0.4;                ///< p_c: share of the largest difference,
constexpr double kKneeValue = 0.95;          ///< p_t: and what it becomes
constexpr double kFeatureWidth_deg = 0.082;  ///< w: of a feature that is seen
constexpr double kFeatureExponent = 0.5;     ///< q_f

/// Largest difference in sRGB, which is that between green and blue.
double largest_difference() {
    return std::pow(hyab(hunt_lab({{0.0, 1.0, 0.0}}), hunt_lab({{0.0, 0.0, 1.0}})),
                    kColourExponent);
}

double colour_difference(Colour<LinearSrgb> a, Colour<LinearSrgb> b, double largest) {
    const double difference = std::pow(hyab(hunt_lab(a), hunt_lab(b)), kColourExponent);
    const double knee = kKnee * largest;
    if (difference < knee) return kKneeValue / knee * difference;
    return kKneeValue + (difference - knee) / (largest - knee) * (1.0 - kKneeValue);
}

/// Seen colours, clamped to what a screen shows.
std::vector<Colour<LinearSrgb>> seen_colours(const Planes& planes, double pixels_per_degree) {
    Planes seen;
    for (std::size_t c = 0; c < 3; ++c)
        seen[c] = see(planes[c], kSensitivities[c], pixels_per_degree);
    std::vector<Colour<LinearSrgb>> colours;
    for (std::size_t i = 0; i < seen[0].values.size(); ++i) {
        Colour<LinearSrgb> rgb =
            rgb_from_opponent({{seen[0].values[i], seen[1].values[i], seen[2].values[i]}});
        for (double& channel : rgb.v) channel = std::clamp(channel, 0.0, 1.0);
        colours.push_back(rgb);
    }
    return colours;
}

/// Scaled so that positive weights sum to 1 and negative ones to −1.
void normalise_signs(Kernel& kernel) {
    double positive = 0.0, negative = 0.0;
    for (const double weight : kernel.weights) (weight > 0.0 ? positive : negative) += weight;
    for (double& weight : kernel.weights) weight /= weight > 0.0 ? positive : -negative;
}

/// Strengths of edges and of points in the luminance, each the length of its two directions.
struct Features {
    std::vector<double> edges, points;
};
std::vector<double> feature_strength(const Plane& luminance, const Kernel& across,
                                     const Kernel& along) {
    const Plane x = convolve(luminance, across, along), y = convolve(luminance, along, across);
    std::vector<double> strength;
    for (std::size_t i = 0; i < x.values.size(); ++i)
        strength.push_back(std::hypot(x.values[i], y.values[i]));
    return strength;
}
Features features_of(const Plane& achromatic, double pixels_per_degree) {
    Plane luminance = achromatic;
    for (double& value : luminance.values) value = (value + 16.0) / 116.0;
    const double deviation = 0.5 * kFeatureWidth_deg * pixels_per_degree;
    const int radius = int(std::ceil(3.0 * deviation));
    const auto gaussian = [&](double x) {
        return std::exp(-x * x / (2.0 * deviation * deviation));
    };
    Kernel along = make_kernel(radius, gaussian);
    double sum = 0.0;
    for (const double weight : along.weights) sum += weight;
    for (double& weight : along.weights) weight /= sum;
    Kernel edge = make_kernel(radius, [&](double x) { return -x * gaussian(x); });
    Kernel point = make_kernel(
        radius, [&](double x) { return (x * x / (deviation * deviation) - 1.0) * gaussian(x); });
    normalise_signs(edge);
    normalise_signs(point);
    return {feature_strength(luminance, edge, along), feature_strength(luminance, point, along)};
}

}  // namespace

std::vector<double> flip(const Image& image, const Image& reference, double pixels_per_degree) {
    DEWBOW_CHECK(pixels_per_degree > 0.0, "a degree holds pixels");
    if (image.width != reference.width || image.height != reference.height)
        throw InputError(fmt::format("a picture of {} x {} is compared with one of {} x {}",
                                     image.width, image.height, reference.width, reference.height));
    const Planes a = opponent_planes(image), b = opponent_planes(reference);
    const auto seen_a = seen_colours(a, pixels_per_degree);
    const auto seen_b = seen_colours(b, pixels_per_degree);
    const Features features_a = features_of(a[0], pixels_per_degree);
    const Features features_b = features_of(b[0], pixels_per_degree);
    const double largest = largest_difference();
    std::vector<double> differences;
    for (std::size_t i = 0; i < seen_a.size(); ++i) {
        const double colour = colour_difference(seen_a[i], seen_b[i], largest);
        const double feature = std::max(std::abs(features_a.edges[i] - features_b.edges[i]),
                                        std::abs(features_a.points[i] - features_b.points[i]));
        const double weight = std::pow(feature / std::numbers::sqrt2, kFeatureExponent);
        differences.push_back(std::pow(colour, 1.0 - weight));
    }
    return differences;
}

}  // namespace dewbow
