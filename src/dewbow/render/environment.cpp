// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/environment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/spectrum/rgb.h"

namespace dewbow {

namespace {

constexpr double kPi = std::numbers::pi;

double luminance(Colour<LinearSrgb> rgb) { return xyz_from_rgb(rgb)[1]; }

double row_theta(int row, int height) { return kPi * (row + 0.5) / height; }

/// Mean over each pixel of the brightness that radiance() interpolates between it and its
/// neighbours, times the solid angle of its row. (A bright pixel alone is then sampled with the
/// relative variance 1.44² − 1; with the same weight for all nine it would be 3.)
std::vector<double> sampling_weights(const ImageEnvironment& image) {
    const auto y_at = [&](int x, int y) {
        const int wrapped = (x + image.width) % image.width;
        const int held = std::clamp(y, 0, image.height - 1);
        return luminance(
            image.pixels[std::size_t(held) * std::size_t(image.width) + std::size_t(wrapped)]);
    };
    std::vector<double> weights;
    weights.reserve(image.pixels.size());
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            // A half of the pixel lies towards either neighbour, at 1/4 of the way on average.
            constexpr std::array<double, 3> kShare{0.125, 0.75, 0.125};
            double sum = 0.0;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    sum += kShare[std::size_t(dx + 1)] * kShare[std::size_t(dy + 1)] *
                           std::max(0.0, y_at(x + dx, y + dy));
            weights.push_back(sum * std::sin(row_theta(y, image.height)));
        }
    }
    return weights;
}

}  // namespace

EnvironmentMap::EnvironmentMap(std::shared_ptr<const ImageEnvironment> image)
    : image_(std::move(image)),
      local_from_world_(image_->world_from_object.inverse().affine()),
      world_from_local_(image_->world_from_object.affine()),
      distribution_(sampling_weights(*image_), std::size_t(image_->width),
                    std::size_t(image_->height)) {
    double sum = 0.0, weight = 0.0;
    for (int y = 0; y < image_->height; ++y) {
        const double sine = std::sin(row_theta(y, image_->height));
        for (int x = 0; x < image_->width; ++x)
            sum +=
                sine *
                luminance(
                    image_->pixels[std::size_t(y) * std::size_t(image_->width) + std::size_t(x)]);
        weight += sine * image_->width;
    }
    mean_y_ = image_->scale * sum / weight;
}

EquirectangularPlace EnvironmentMap::look_up(Vec3 direction) const {
    return equirectangular_from_direction(normalised(local_from_world_.apply_linear(direction)));
}

Colour<LinearSrgb> EnvironmentMap::radiance(Vec3 direction) const {
    const EquirectangularPlace place = look_up(direction);
    const int width = image_->width, height = image_->height;
    const double x = place.x * width - 0.5, y = place.y * height - 0.5;
    const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
    const double fx = x - x0, fy = y - y0;
    const auto pixel = [&](int px, int py) {
        return image_->pixels[std::size_t(std::clamp(py, 0, height - 1)) * std::size_t(width) +
                              std::size_t((px + width) % width)];
    };
    return image_->scale * ((1.0 - fy) * ((1.0 - fx) * pixel(x0, y0) + fx * pixel(x0 + 1, y0)) +
                            fy * ((1.0 - fx) * pixel(x0, y0 + 1) + fx * pixel(x0 + 1, y0 + 1)));
}

EnvironmentMap::Sample EnvironmentMap::sample(std::array<double, 2> u) const {
    const Distribution2D::Sample s = distribution_.sample(u[0], u[1]);
    const Vec3 local = direction_from_equirectangular(s.x, s.y);
    const double pdf = pdf_on_sphere(s.pdf, std::sin(kPi * s.y));
    return {normalised(world_from_local_.apply_linear(local)), pdf};
}

double EnvironmentMap::pdf(Vec3 direction) const {
    const EquirectangularPlace place = look_up(direction);
    return pdf_on_sphere(distribution_.pdf(place.x, place.y), place.sin_theta);
}

std::array<double, 2> EnvironmentMap::place_of(Vec3 direction) const {
    const EquirectangularPlace place = look_up(direction);
    return distribution_.inverse(place.x, place.y);
}

}  // namespace dewbow
