// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <numbers>

#include "common.h"
#include "dewbow/base/file.h"
#include "dewbow/spectrum/rgb.h"

// pbrt-v4: spectral, with the index as a table. A path that meets dispersive glass keeps one of its
// four wavelengths.

namespace dewbow::bench {
namespace {

/// pbrt works with 360–830 nm. Outside a table its index would be 1, and its lights 0.
constexpr int kFirst_nm = 359, kLast_nm = 831;

template <class F>
std::string table(F value) {
    std::string text;
    for (int nm = kFirst_nm; nm <= kLast_nm; ++nm)
        text += fmt::format("{} {}\n", nm, value(double(nm) * unit::nm));
    return "[\n" + text + "]";
}

/// Light in pbrt is a spectrum, scaled so that its Y becomes `scale`.
std::string light_text(const Spectrum& radiance, const Colour<LinearSrgb>& colour) {
    const double y = xyz_from_rgb(colour)[1];
    return fmt::format("\"spectrum L\" {} \"float scale\" [{}]",
                       table([&](Wavelength lambda) { return radiance(lambda); }), y);
}

std::string camera_text(const PlainCamera& camera) {
    // Columns of the map from the world to the camera, which looks along +z with x to the right.
    std::string columns;
    for (const int axis : {0, 1, 2})
        columns +=
            fmt::format("{} {} {} 0\n", camera.right[axis], camera.up[axis], camera.forward[axis]);
    const Vec3 e = -camera.eye;
    const double aspect = double(camera.width) / camera.height;
    return fmt::format(
        "Transform [\n{}{} {} {} 1 ]\n"
        "Camera \"perspective\" \"float fov\" [{}] \"float screenwindow\" [{} {} -1 1]\n",
        columns, dot(camera.right, e), dot(camera.up, e), dot(camera.forward, e),
        2.0 * std::atan(camera.tan_half_vertical_fov) * 180.0 / std::numbers::pi, -aspect, aspect);
}

std::string lamp_text(const PlainLamp& lamp) {
    // The shape between (−1, −1) and (1, 1) in the plane z = 0, normal +z.
    std::string text = fmt::format("AttributeBegin\nTransform [\n{} 0\n{} 0\n{} 0\n{} 1 ]\n",
                                   joined(lamp.half_u, " "), joined(lamp.half_v, " "),
                                   joined(lamp.normal, " "), joined(lamp.centre, " "));
    text += "Material \"diffuse\" \"spectrum reflectance\" [300 0 900 0]\n";
    text += fmt::format("AreaLightSource \"diffuse\" \"bool twosided\" {} {}\n",
                        lamp.two_sided ? "true" : "false", light_text(*lamp.radiance, lamp.colour));
    text += lamp.shape == LampShape::disc
                ? "Shape \"disk\" \"float radius\" [1]\n"
                : "Shape \"trianglemesh\" \"point3 P\" [-1 -1 0  1 -1 0  1 1 0  -1 1 0]\n"
                  "  \"integer indices\" [0 1 2  0 2 3]\n";
    return text + "AttributeEnd\n";
}

std::string body_text(const PlainScene& scene) {
    std::string points, indices;
    for (const Vec3& p : scene.body.vertices) points += joined(p, " ") + "\n";
    for (const auto& t : scene.body.triangles)
        indices += fmt::format("{} {} {}\n", t[0], t[1], t[2]);
    return fmt::format(
        "Material \"dielectric\" \"spectrum eta\" {}\n"
        "Shape \"trianglemesh\" \"point3 P\" [\n{}]\n\"integer indices\" [\n{}]\n",
        table([&](Wavelength lambda) { return relative_index(scene, lambda); }), points, indices);
}

class Pbrt : public Contestant {
public:
    explicit Pbrt(std::filesystem::path program)
        : program_(std::move(program)),
          version_(version_line(program_, "/dev/null", "pbrt version")) {}
    std::string name() const override { return "pbrt-path"; }
    std::string version() const override { return version_; }
    bool splits_spectrum() const override { return false; }
    bool converges_to_truth() const override { return true; }
    int possible_samples_per_pixel(int wanted) const override {
        return int(std::bit_ceil(unsigned(wanted)));  // of its Sobol' sampler, a power of two
    }

    std::vector<std::string> write(const Order& order) const override {
        write_file_atomically(order.folder / "scene.pbrt", pbrt_scene(scene_order(order)));
        return {program_.string(), "--quiet", "--nthreads", std::to_string(order.threads),
                "scene.pbrt"};
    }
    Picture read(const Order& order) const override { return read_left_picture(order); }

private:
    std::filesystem::path program_;
    std::string version_;
};

}  // namespace

std::string pbrt_scene(const SceneOrder& order) {
    const PlainScene& scene = order.scene;
    std::string text = camera_text(scene.camera);
    text += fmt::format(
        "Film \"rgb\" \"integer xresolution\" [{}] \"integer yresolution\" [{}]\n"
        "  \"string filename\" \"{}\" \"bool savefp16\" false\n"
        "PixelFilter \"box\" \"float xradius\" [0.5] \"float yradius\" [0.5]\n"
        "Sampler \"zsobol\" \"integer pixelsamples\" [{}] \"integer seed\" [{}]\n"
        "Integrator \"path\" \"integer maxdepth\" [{}]\n"
        "WorldBegin\n",
        scene.camera.width, scene.camera.height, kPictureFile, order.knobs.samples_per_pixel,
        order.knobs.seed & 0x7fffffffu, order.max_depth);
    if (scene.surroundings)
        text += "LightSource \"infinite\" " +
                light_text(*scene.surroundings, scene.surroundings_colour) + "\n";
    for (const PlainLamp& lamp : scene.lamps) text += lamp_text(lamp);
    return text + body_text(scene);
}

std::unique_ptr<Contestant> find_pbrt(const Programs& programs) {
    const auto program = programs.find("pbrt");
    if (!program) return nullptr;
    return std::make_unique<Pbrt>(*program);
}

}  // namespace dewbow::bench
