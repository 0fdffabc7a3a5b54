// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "dewbow/scene/scene.h"

namespace dewbow {
namespace {

constexpr int kWidth = 256, kHeight = 128;

/// Radiance of the walls, by the Y that it has. Dark: a gem is seen by the contrast of what it
/// reflects.
constexpr double kSurround = 0.1;

/// A soft box seen from the centre: a rectangle on the sphere with edges that fade.
struct SoftBox {
    double longitude_deg, latitude_deg;  ///< of its centre; longitude 0 is the picture's centre, −z
    double half_width_deg, half_height_deg;  ///< measured on the sphere around its centre
    double edge_deg;                         ///< over which it fades to nothing
    double radiance;
    Colour<LinearSrgb> tint;
};

// Together they let a white surface that looks up shine with about 1.2 times the film's white.
// Chosen by eye for faceted stones and prisms: a large key from the upper left behind the camera, a
// long strip from the right for edges, a top light for tables, a low weak one from behind for
// transmission. Longitude 180 is +z, where a framed camera stands; 90 is +x.
constexpr SoftBox kBoxes[] = {
    {-130.0, 35.0, 24.0, 18.0, 6.0, 3.2, {{1.0, 0.98, 0.95}}},
    {105.0, 15.0, 7.0, 38.0, 4.0, 2.6, {{0.95, 0.98, 1.0}}},
    {0.0, 80.0, 20.0, 20.0, 7.0, 3.6, {{1.0, 1.0, 1.0}}},
    {15.0, 14.0, 26.0, 5.0, 8.0, 0.6, {{1.0, 1.0, 1.0}}},
};

Vec3 direction_at(double longitude_deg, double latitude_deg) {
    const Angle longitude = longitude_deg * unit::deg, latitude = latitude_deg * unit::deg;
    return {cos(latitude) * sin(longitude), sin(latitude), -cos(latitude) * cos(longitude)};
}

/// 1 within `half`, 0 beyond `half + edge`, smooth between (cubic).
double soft_step(double distance, double half, double edge) {
    const double t = std::clamp((half + edge - distance) / edge, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// How much of `box` is seen along the unit vector `direction`, 0 to 1.
double coverage(const SoftBox& box, Vec3 direction) {
    const Vec3 centre = direction_at(box.longitude_deg, box.latitude_deg);
    const Vec3 right = direction_at(box.longitude_deg + 90.0, 0.0);
    const Vec3 up = cross(right, centre);
    const double ahead = dot(direction, centre);
    if (ahead <= 0.0) return 0.0;
    const double degrees = unit::rad.to(unit::deg);
    const double across = std::abs(std::atan2(dot(direction, right), ahead)) * degrees;
    const double along = std::abs(std::atan2(dot(direction, up), ahead)) * degrees;
    return soft_step(across, box.half_width_deg, box.edge_deg) *
           soft_step(along, box.half_height_deg, box.edge_deg);
}

Colour<LinearSrgb> radiance_along(Vec3 direction) {
    // A floor half as bright as the walls, so that up and down differ.
    const double surround = kSurround * std::clamp(0.75 + 0.5 * direction.y, 0.5, 1.0);
    Colour<LinearSrgb> sum{{surround, surround, surround}};
    for (const SoftBox& box : kBoxes) {
        sum = sum + box.tint * (box.radiance * coverage(box, direction));
    }
    return sum;
}

}  // namespace

std::shared_ptr<const ImageEnvironment> make_studio_environment() {
    auto studio = std::make_shared<ImageEnvironment>();
    studio->width = kWidth;
    studio->height = kHeight;
    studio->pixels.reserve(std::size_t(kWidth) * kHeight);
    for (int row = 0; row < kHeight; ++row) {
        for (int column = 0; column < kWidth; ++column) {
            studio->pixels.push_back(radiance_along(direction_at(
                360.0 * (column + 0.5) / kWidth - 180.0, 90.0 - 180.0 * (row + 0.5) / kHeight)));
        }
    }
    return studio;
}

}  // namespace dewbow
