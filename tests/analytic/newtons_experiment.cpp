// SPDX-License-Identifier: Apache-2.0
#include "newtons_experiment.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "dewbow/math/quadrature.h"

namespace dewbow::kit {

namespace {

/// Where the line o + t d meets the plane n · p = distance.
Vec3 on_plane(Vec3 o, Vec3 d, Vec3 n, double distance) {
    return o + d * ((distance - dot(n, o)) / dot(n, d));
}

struct Refracted {
    Vec3 direction;
    double transmittance;  ///< Fresnel's, of unpolarised light
};

/// Into a medium of the relative index `eta` behind a plane whose unit normal points along the ray.
/// Snell's law keeps the component within the plane: d_∥ / eta.
Refracted refract(Vec3 d, Vec3 normal, double eta) {
    const double cos_i = dot(d, normal);
    const Vec3 within = (d - normal * cos_i) * (1.0 / eta);
    const double cos2_t = 1.0 - dot(within, within);
    if (!(cos2_t > 0.0)) throw std::logic_error("reflected totally");
    const double cos_t = std::sqrt(cos2_t);
    const double s = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    const double p = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    return {within + normal * cos_t, 1.0 - 0.5 * (s * s + p * p)};
}

}  // namespace

double NewtonsExperiment::incidence_rad() const {
    return std::asin(index_between * std::sin(0.5 * apex_rad));
}
Vec3 NewtonsExperiment::sunward() const {
    const double rise = incidence_rad() - 0.5 * apex_rad;
    return {std::cos(rise), std::sin(rise), 0.0};
}
Vec3 NewtonsExperiment::slit_centre() const {
    // The middle of the face, between the apex and the corner on the left.
    const Vec3 entry{-0.5 * side * std::sin(0.5 * apex_rad), side * std::cos(0.5 * apex_rad) / 6.0,
                     0.0};
    return entry - sunward() * slit_distance;
}
Vec3 NewtonsExperiment::across_slit() const {
    const Vec3 d = sunward();
    return {-d.y, d.x, 0.0};
}
Vec3 NewtonsExperiment::onward() const {
    const Vec3 d = sunward();
    return {d.x, -d.y, 0.0};
}
Vec3 NewtonsExperiment::wall_centre() const {
    const Vec3 exit{0.5 * side * std::sin(0.5 * apex_rad), side * std::cos(0.5 * apex_rad) / 6.0,
                    0.0};
    return exit + onward() * wall_distance;
}
Vec3 NewtonsExperiment::along_wall() const {
    const Vec3 d = onward();
    return {d.y, -d.x, 0.0};
}

SpotOnWall spot_on_wall(const NewtonsExperiment& setup, double n, double absorption_per_m,
                        int nodes) {
    const double c = std::cos(0.5 * setup.apex_rad), s = std::sin(0.5 * setup.apex_rad);
    const Vec3 left{-c, s, 0}, right{c, s, 0}, z{0, 0, 1};
    const double apex_y = 2.0 / 3.0 * setup.side * c, base_y = -setup.side * c / 3.0;
    const double face_distance = apex_y * s;
    const Vec3 axis = setup.sunward(), across = setup.across_slit();
    const Vec3 wall = setup.wall_centre(), out = setup.onward();
    const auto expect_on_face = [&](Vec3 p) {
        if (p.y > apex_y || p.y < base_y || std::abs(p.z) > 0.5 * setup.length)
            throw std::logic_error("a ray misses a face of the prism");
    };

    const QuadratureRule rule = gauss_legendre(nodes);
    const double sin_radius = std::sin(setup.sun_radius_rad);
    const double radiance = 1.0 / (std::numbers::pi * sin_radius * sin_radius);
    const int turns = 2 * nodes;
    SpotOnWall spot;
    for (std::size_t r = 0; r < rule.nodes.size(); ++r)
        for (int turn = 0; turn < turns; ++turn) {
            // Even in cos θ, so that nodes weigh solid angle.
            const double half_range = 0.5 * (1.0 - std::cos(setup.sun_radius_rad));
            const double cos_theta = 1.0 - half_range * (1.0 + rule.nodes[r]);
            const double sin_theta = std::sqrt(1.0 - cos_theta * cos_theta);
            const double phi = 2.0 * std::numbers::pi * (turn + 0.5) / turns;
            const Vec3 d = axis * cos_theta + across * (sin_theta * std::cos(phi)) +
                           z * (sin_theta * std::sin(phi));
            const double solid_angle =
                half_range * rule.weights[r] * 2.0 * std::numbers::pi / turns;
            for (std::size_t i = 0; i < rule.nodes.size(); ++i)
                for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
                    const Vec3 at = setup.slit_centre() +
                                    across * (0.5 * setup.slit_width * rule.nodes[i]) +
                                    z * (0.5 * setup.slit_height * rule.nodes[k]);
                    const double area = 0.25 * setup.slit_width * setup.slit_height *
                                        rule.weights[i] * rule.weights[k];
                    const Vec3 entry = on_plane(at, d, left, face_distance);
                    const Refracted inside = refract(d, -left, n);
                    const Vec3 exit = on_plane(entry, inside.direction, right, face_distance);
                    const Refracted outside = refract(inside.direction, right, 1.0 / n);
                    expect_on_face(entry);
                    expect_on_face(exit);
                    const Vec3 end = on_plane(exit, outside.direction, out, dot(out, wall)) - wall;
                    const double power = radiance * cos_theta * solid_angle * area *
                                         inside.transmittance * outside.transmittance *
                                         std::exp(-absorption_per_m * length(exit - entry));
                    spot.power += power;
                    spot.u += power * dot(end, setup.along_wall());
                    spot.v += power * end.z;
                }
        }
    spot.u /= spot.power;
    spot.v /= spot.power;
    return spot;
}

double n_sf11(double vacuum_nm) {
    // Of dry air at 20 °C: Edlén's formula for 15 °C, thinned. [Edlén 1966] The glass's index is
    // asked for by the wavelength in air; what the formula leaves out of n is below 1e-8.
    const double wave_number = 1e3 / vacuum_nm, s = wave_number * wave_number;  // µm⁻¹, µm⁻²
    const double refractivity =
        1e-8 * (8342.13 + 2406030.0 / (130.0 - s) + 15997.0 / (38.9 - s)) * 288.15 / 293.15;
    const double l = vacuum_nm * 1e-3 / (1.0 + refractivity), l2 = l * l;
    return std::sqrt(1.0 + 1.73759695 * l2 / (l2 - 0.013188707) +
                     0.313747346 * l2 / (l2 - 0.0623068142) + 1.89878101 * l2 / (l2 - 155.23629));
}

}  // namespace dewbow::kit
