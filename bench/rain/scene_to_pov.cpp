// SPDX-License-Identifier: Apache-2.0

// Tells a scene's camera, sun and meshes to POV-Ray, so that its `rainbow {}` can be looked at over
// the same ground as ours.
//
//     bench_scene_to_pov examples/landscape.toml scene.inc sky.exr
//
// scene.inc declares Sun_Direction (towards the sun), Sun_Colour, and writes `camera` and the
// meshes, which are shared between places as in the scene. Diffuse materials alone are known:
// colours of vertices, or one colour. sky.exr is the scene's sky without sun and rain, an
// equirectangular picture with north in its middle. 1 is the film's white.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <map>
#include <numbers>
#include <unordered_map>
#include <vector>

#include "dewbow/base/file.h"
#include "dewbow/image/exr.h"
#include "dewbow/import/import.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow::bench {
namespace {

/// Steps of a channel between 0 and 1, in the square root: each colour is a texture of POV-Ray.
constexpr int kColourSteps = 40;

std::string text_of(Vec3 v) { return fmt::format("<{:.6g}, {:.6g}, {:.6g}>", v.x, v.y, v.z); }

void write_camera(std::ostream& out, const Scene& scene) {
    const auto& world_from_camera = scene.camera.world_from_camera;
    const auto& lens = std::get<Perspective>(scene.camera.projection);
    const double height = 2.0 * std::tan(0.5 * lens.vertical_field_of_view.to(unit::rad));
    const double aspect = double(scene.film.width) / scene.film.height;
    const auto axis = [&](Vec3 v) { return world_from_camera(Dir<Camera>{v}).v; };
    out << fmt::format("camera {{ perspective location {} direction {} right {} up {} }}\n",
                       text_of(world_from_camera(Point<Camera>{}).v), text_of(axis({0, 0, -1})),
                       text_of(axis({height * aspect, 0, 0})), text_of(axis({0, height, 0})));
}

/// What a white wall that faces the sun sends out, of the film's white.
void write_sun(std::ostream& out, const Scene& scene) {
    const double white_xyz = scene.film.white_luminance / kLuminousEfficacy;
    for (const Light& light : scene.lights) {
        const auto* sun = std::get_if<DistantLight>(&light);
        if (!sun) continue;
        const Colour<LinearSrgb> rgb =
            rgb_from_xyz<LinearSrgb>(xyz_from_spectrum(*sun->irradiance)) *
            (1.0 / (std::numbers::pi * white_xyz));
        out << fmt::format("#declare Sun_Direction = {};\n", text_of(-sun->direction.v))
            << fmt::format("#declare Sun_Colour = rgb <{:.5g}, {:.5g}, {:.5g}>;\n", rgb[0], rgb[1],
                           rgb[2]);
    }
}

/// The textures of one mesh: its colours, coarsely.
class Palette {
public:
    int index(const std::array<float, 4>& colour) {
        std::array<int, 3> key{};
        for (std::size_t c = 0; c < 3; ++c)
            key[c] = int(std::lround(std::sqrt(double(colour[c])) * kColourSteps));
        return numbers_.try_emplace(key, int(numbers_.size())).first->second;
    }
    void write(std::ostream& out) const {
        std::vector<std::array<int, 3>> colours(numbers_.size());
        for (const auto& [key, number] : numbers_) colours[std::size_t(number)] = key;
        out << fmt::format(" texture_list {{ {}", colours.size());
        for (const auto& key : colours) {
            const auto c = [&](std::size_t k) {
                const double root = double(key[k]) / kColourSteps;
                return root * root;
            };
            out << fmt::format(", texture {{ pigment {{ rgb <{:.4g},{:.4g},{:.4g}> }} }}\n", c(0),
                               c(1), c(2));
        }
        out << " }\n";
    }

private:
    std::map<std::array<int, 3>, int> numbers_;
};

void write_mesh(std::ostream& out, const Mesh& mesh, std::size_t number) {
    out << fmt::format("#declare Mesh_{} = mesh2 {{\n vertex_vectors {{ {}", number,
                       mesh.vertices.size());
    for (const auto& vertex : mesh.vertices) out << "," << text_of(vertex.v) << "\n";
    out << " }\n";
    if (!mesh.normals.empty()) {
        out << fmt::format(" normal_vectors {{ {}", mesh.normals.size());
        for (const auto& normal : mesh.normals) out << "," << text_of(normal.v) << "\n";
        out << " }\n";
    }
    Palette palette;
    std::vector<int> textures;
    for (const auto& colour : mesh.colours) textures.push_back(palette.index(colour));
    if (!textures.empty()) palette.write(out);
    out << fmt::format(" face_indices {{ {}", mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        out << fmt::format(",<{},{},{}>", a, b, c);
        if (!textures.empty())
            out << fmt::format(",{},{},{}\n", textures[a], textures[b], textures[c]);
    }
    out << " }\n}\n";
}

void write_shape(std::ostream& out, const Shape& shape, const Material& material,
                 std::size_t mesh_number, bool has_colours) {
    const auto& m = shape.world_from_object.affine().m;
    out << fmt::format("object {{ Mesh_{} matrix <", mesh_number);
    for (std::size_t column = 0; column < 4; ++column)
        for (std::size_t row = 0; row < 3; ++row)
            out << fmt::format("{}{:.6g}", column + row == 0 ? "" : ",", m[row][column]);
    out << ">";
    const auto* diffuse = std::get_if<Diffuse>(&material.surface);
    if (!has_colours && diffuse && diffuse->reflectance.spectrum) {
        const auto rgb = rgb_from_xyz<LinearSrgb>(
            xyz_from_spectrum(*diffuse->reflectance.spectrum) * (1.0 / cie_y_integral()));
        out << fmt::format(" pigment {{ rgb <{:.4g},{:.4g},{:.4g}> }}", rgb[0], rgb[1], rgb[2]);
    }
    out << " }\n";
}

/// Size of the sky's picture, and wavelengths that a colour is summed from.
constexpr int kSkyWidth = 1024, kSkyHeight = 512, kWavelengths = 48;

/// What the scene's sky sends along a direction, of the film's white.
class SkyColour {
public:
    explicit SkyColour(const Scene& scene)
        : scene_(scene), white_xyz_(scene.film.white_luminance / kLuminousEfficacy) {
        for (int k = 0; k < kWavelengths; ++k) lambda_nm_.push_back(380.0 + (k + 0.5) * kStep_nm);
    }
    Colour<LinearSrgb> along(Dir<World> direction) const {
        std::vector<double> radiance(lambda_nm_.size());
        Colour<Xyz> xyz{};
        for (const Light& light : scene_.lights) {
            const auto* dome = std::get_if<SkyDomePtr>(&light);
            if (!dome) continue;
            (*dome)->radiance_lanes(direction, lambda_nm_, radiance);
            for (std::size_t k = 0; k < radiance.size(); ++k) {
                const auto bar = cie_xyz_bar(lambda_nm_[k]);
                for (std::size_t c = 0; c < 3; ++c) xyz[c] += bar[c] * radiance[k] * kStep_nm;
            }
        }
        return rgb_from_xyz<LinearSrgb>(xyz * (1.0 / white_xyz_));
    }

private:
    static constexpr double kStep_nm = (780.0 - 380.0) / kWavelengths;
    const Scene& scene_;
    double white_xyz_;
    std::vector<double> lambda_nm_;
};

std::string sky_picture(const Scene& scene) {
    Image image{kSkyWidth, kSkyHeight, {{"R", {}}, {"G", {}}, {"B", {}}}};
    const SkyColour sky(scene);
    for (int y = 0; y < kSkyHeight; ++y)
        for (int x = 0; x < kSkyWidth; ++x) {
            const double altitude = std::numbers::pi * (0.5 - (y + 0.5) / kSkyHeight);
            const double azimuth = 2.0 * std::numbers::pi * ((x + 0.5) / kSkyWidth - 0.5);
            const auto rgb = sky.along({{std::cos(altitude) * std::sin(azimuth), std::sin(altitude),
                                         -std::cos(altitude) * std::cos(azimuth)}});
            for (std::size_t c = 0; c < 3; ++c)
                image.channels[c].values.push_back(float(std::max(rgb[c], 0.0)));
        }
    return encode_exr(image, {}, {});
}

void write_scene(std::ostream& out, const Scene& scene) {
    write_sun(out, scene);
    write_camera(out, scene);
    std::unordered_map<const Mesh*, std::size_t> numbers;
    for (const Shape& shape : scene.shapes) {
        const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&shape.geometry);
        if (!mesh) continue;
        const auto [found, is_new] = numbers.try_emplace(mesh->get(), numbers.size());
        if (is_new) write_mesh(out, **mesh, found->second);
        write_shape(out, shape, scene.materials[std::size_t(shape.material)], found->second,
                    !(*mesh)->colours.empty());
    }
}

}  // namespace
}  // namespace dewbow::bench

int main(int count, char** arguments) {
    if (count != 4) {
        std::fputs("bench_scene_to_pov SCENE.toml OUT.inc SKY.exr\n", stderr);
        return 2;
    }
    try {
        const dewbow::Scene scene = dewbow::load_scene(arguments[1]).scene;
        std::ofstream out(arguments[2]);
        dewbow::bench::write_scene(out, scene);
        dewbow::write_file_atomically(arguments[3], dewbow::bench::sky_picture(scene));
        return out.flush() ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
