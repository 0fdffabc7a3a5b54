// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/terrain/terrain.h"

#include <algorithm>
#include <cmath>

#include "dewbow/base/parallel.h"
#include "dewbow/base/random.h"
#include "dewbow/math/gradient_noise.h"

namespace dewbow {
namespace {

/// Not 2, and each octave turned by the golden angle: lattices that coincide would show.
constexpr double kLacunarity = 1.92;
constexpr double kTurn_rad = 2.39996;
/// Added to each octave of noise, so that few of them are below 0. [Musgrave, as in terrain.h]
constexpr double kOffset = 0.7;
/// More octaves than any ground has: 1.92^24 is 6e6.
constexpr int kMostOctaves = 24;
/// Waves across the terrain's largest hills that patches of colour are wide.
constexpr double kPatchesPerFeature = 4.0;

double smooth_step(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Noise that is cut where its waves come near to the cells.
/// @param x, z  in wavelengths of the first octave.   @param cell  likewise, > 0.
double hybrid_multifractal(double x, double z, double cell, double roughness, std::uint64_t seed) {
    const double gain = std::pow(kLacunarity, roughness - 1.0);
    const double turn_cos = std::cos(kTurn_rad), turn_sin = std::sin(kTurn_rad);
    double sum = 0.0, weight = 1.0, amplitude = 1.0, wavelength = 1.0;
    for (int octave = 0; octave < kMostOctaves; ++octave) {
        const double resolved = smooth_step(2.0, 4.0, wavelength / cell);
        if (octave > 0 && resolved == 0.0) break;
        const std::uint64_t own = hash_combine(seed, std::uint64_t(octave));
        const double noise = gradient_noise({x, 0.5, z}, own);
        const double signal = (noise + kOffset) * amplitude;
        sum += weight * signal * (octave == 0 ? 1.0 : resolved);
        weight = std::clamp(weight * signal, 0.0, 1.0);
        amplitude *= gain, wavelength /= kLacunarity;
        const double turned = (turn_cos * x - turn_sin * z) * kLacunarity;
        z = (turn_sin * x + turn_cos * z) * kLacunarity, x = turned;
    }
    return sum;
}

/// Positions of the grid's lines along an edge of 2, from −1 to 1.
std::vector<double> grid_lines(int cells, double middle_finer) {
    const double slope = 1.0 / middle_finer;
    std::vector<double> lines;
    for (int i = 0; i <= cells; ++i) {
        const double u = 2.0 * i / cells - 1.0;
        lines.push_back(u * (slope + (1.0 - slope) * u * u));
    }
    return lines;
}

class Ground {
public:
    explicit Ground(const Terrain& terrain)
        : terrain_(terrain),
          half_m_(0.5 * terrain.size.to(unit::m)),
          feature_m_(terrain.feature.to(unit::m)),
          lines_(grid_lines(terrain.cells, terrain.middle_finer)),
          relief_(std::size_t(side()) * std::size_t(side())) {
        for_each_vertex([&](int i, int j) { relief_[index(i, j)] = raw(i, j); });
        const auto [low, high] = std::minmax_element(relief_.begin(), relief_.end());
        const double lowest = *low, range = std::max(*high - *low, 1e-300);
        for (double& relief : relief_) relief = (relief - lowest) / range;
    }

    std::shared_ptr<const Mesh> mesh() const {
        auto mesh = std::make_shared<Mesh>();
        mesh->name = "terrain";
        mesh->vertices.resize(relief_.size());
        mesh->normals.resize(relief_.size());
        mesh->texcoords[0].resize(relief_.size());
        if (!terrain_.colours.empty()) mesh->colours.resize(relief_.size());
        for_each_vertex([&](int i, int j) {
            const std::size_t k = index(i, j);
            mesh->vertices[k] = {vertex(i, j)};
            mesh->normals[k] = {normal(i, j)};
            mesh->texcoords[0][k] = {float(0.5 + 0.5 * line(i)), float(0.5 + 0.5 * line(j))};
            if (!terrain_.colours.empty()) mesh->colours[k] = colour(i, j);
        });
        for (int j = 0; j < terrain_.cells; ++j)
            for (int i = 0; i < terrain_.cells; ++i) {
                const auto a = std::uint32_t(index(i, j)), b = std::uint32_t(index(i + 1, j));
                const auto c = std::uint32_t(index(i, j + 1)),
                           d = std::uint32_t(index(i + 1, j + 1));
                mesh->triangles.push_back({a, c, d});
                mesh->triangles.push_back({a, d, b});
            }
        return mesh;
    }

private:
    int side() const { return terrain_.cells + 1; }
    std::size_t index(int i, int j) const {
        return std::size_t(j) * std::size_t(side()) + std::size_t(i);
    }
    double line(int i) const { return lines_[std::size_t(i)]; }
    template <class Do>
    void for_each_vertex(const Do& act) const {
        parallel_for(std::size_t(side()), [&](std::size_t j) {
            for (int i = 0; i < side(); ++i) act(i, int(j));
        });
    }
    /// Width of the wider cell beside line i, in halves of an edge.
    double spacing(int i) const {
        const int last = terrain_.cells;
        return std::max(line(std::min(i + 1, last)) - line(std::min(i, last - 1)),
                        line(std::max(i, 1)) - line(std::max(i - 1, 0)));
    }

    double raw(int i, int j) const {
        const double unit = half_m_ / feature_m_;
        const double cell = std::max(spacing(i), spacing(j)) * unit;
        return hybrid_multifractal(line(i) * unit, line(j) * unit, cell, terrain_.roughness,
                                   terrain_.seed);
    }
    /// What valley and border leave of the relief.
    double share(int i, int j) const {
        double share = 1.0;
        if (terrain_.island) {
            const double r = std::hypot(line(i), line(j));
            share *= 1.0 - smooth_step(0.0, 1.0, r);
        }
        if (const auto& valley = terrain_.valley) {
            const double a = valley->azimuth.to(unit::rad);
            const double off_m = half_m_ * (line(i) * std::cos(a) + line(j) * std::sin(a));
            const double d = off_m / valley->width.to(unit::m);
            share *= 1.0 - valley->depth * std::exp(-d * d);
        }
        return share;
    }
    double height_m(int i, int j) const {
        return terrain_.height.to(unit::m) * relief_[index(i, j)] * share(i, j);
    }
    Vec3 vertex(int i, int j) const {
        return {half_m_ * line(i), height_m(i, j), half_m_ * line(j)};
    }
    Vec3 normal(int i, int j) const {
        const int last = terrain_.cells;
        const Vec3 along_x = vertex(std::min(i + 1, last), j) - vertex(std::max(i - 1, 0), j);
        const Vec3 along_z = vertex(i, std::min(j + 1, last)) - vertex(i, std::max(j - 1, 0));
        return normalised(cross(along_z, along_x));
    }
    std::array<float, 4> colour(int i, int j) const {
        const auto& colours = terrain_.colours;
        const double scale = kPatchesPerFeature * half_m_ / feature_m_;
        const double noise = gradient_noise({line(i) * scale, 0.5, line(j) * scale},
                                            hash_combine(terrain_.seed, kMostOctaves));
        const double share = std::clamp(
            height_m(i, j) / terrain_.height.to(unit::m) + terrain_.mottling * noise, 0.0, 1.0);
        const double place = share * double(colours.size() - 1);
        const auto first = std::min(std::size_t(place), colours.size() - 1);
        const auto second = std::min(first + 1, colours.size() - 1);
        const auto t = float(place - double(first));
        std::array<float, 4> result{0.0f, 0.0f, 0.0f, 1.0f};
        for (std::size_t c = 0; c < 3; ++c)
            result[c] = colours[first][c] + t * (colours[second][c] - colours[first][c]);
        return result;
    }

    const Terrain& terrain_;
    double half_m_, feature_m_;
    std::vector<double> lines_;
    std::vector<double> relief_;  ///< 0 to 1, [z][x]
};

}  // namespace

std::shared_ptr<const Mesh> make_terrain(const Terrain& terrain) { return Ground(terrain).mesh(); }

}  // namespace dewbow
