// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "common.h"
#include "dewbow/base/file.h"

// Mitsuba 3: its glass has one index, whatever the variant, so that its limit is the picture
// without colours. It takes part as what a renderer costs that does not do the work.

namespace dewbow::bench {
namespace {

/// Sodium's d line, of which catalogues give the index.
constexpr Wavelength kNominal = 587.5618 * unit::nm;

constexpr const char* kBodyFile = "body.obj";

/// Rows of the map to the world from a frame with these axes.
std::string matrix(Vec3 x, Vec3 y, Vec3 z, Vec3 origin) {
    std::string rows;
    for (const int axis : {0, 1, 2})
        rows += fmt::format("{} {} {} {} ", x[axis], y[axis], z[axis], origin[axis]);
    return fmt::format("<transform name=\"to_world\"><matrix value=\"{}0 0 0 1\"/></transform>",
                       rows);
}

/// A shape that glows towards `normal`.
std::string lamp_text(const PlainLamp& lamp, Vec3 half_u, Vec3 normal) {
    return fmt::format(
        "  <shape type=\"{}\">{}\n"
        "    <bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"0\"/></bsdf>\n"
        "    <emitter type=\"area\"><rgb name=\"radiance\" value=\"{}\"/></emitter></shape>\n",
        lamp.shape == LampShape::disc ? "disk" : "rectangle",
        matrix(half_u, lamp.half_v, normal, lamp.centre), joined(lamp.colour));
}

class Mitsuba : public Contestant {
public:
    explicit Mitsuba(std::filesystem::path program)
        : program_(std::move(program)),
          version_(version_line(program_, "--help", "Mitsuba version")) {}
    std::string name() const override { return "mitsuba-colourless"; }
    std::string version() const override { return version_; }
    bool splits_spectrum() const override { return false; }
    bool converges_to_truth() const override { return false; }

    std::vector<std::string> write(const Order& order) const override {
        write_file_atomically(order.folder / "scene.xml", mitsuba_scene(scene_order(order)));
        write_file_atomically(order.folder / kBodyFile, mitsuba_body(order.scene.plain.bodies[0]));
        return {
            program_.string(), "-m",       "scalar_rgb", "-t", std::to_string(order.threads), "-o",
            kPictureFile,      "scene.xml"};
    }
    Picture read(const Order& order) const override { return read_left_picture(order); }

private:
    std::filesystem::path program_;
    std::string version_;
};

}  // namespace

std::string mitsuba_scene(const SceneOrder& order) {
    const PlainCamera& camera = order.scene.camera;
    // Its camera looks along +z with x to the left.
    std::string text = fmt::format(
        "<scene version=\"3.0.0\">\n"
        "  <integrator type=\"path\"><integer name=\"max_depth\" value=\"{}\"/></integrator>\n"
        "  <sensor type=\"perspective\"><string name=\"fov_axis\" value=\"y\"/>\n"
        "    <float name=\"fov\" value=\"{}\"/><float name=\"near_clip\" value=\"0.0001\"/>\n    "
        "{}\n"
        "    <film type=\"hdrfilm\"><integer name=\"width\" value=\"{}\"/>"
        "<integer name=\"height\" value=\"{}\"/>\n"
        "      <string name=\"pixel_format\" value=\"rgb\"/>"
        "<string name=\"component_format\" value=\"float32\"/><rfilter type=\"box\"/></film>\n"
        "    <sampler type=\"independent\"><integer name=\"sample_count\" value=\"{}\"/>"
        "<integer name=\"seed\" value=\"{}\"/></sampler></sensor>\n",
        order.max_depth + 1,
        2.0 * std::atan(camera.tan_half_vertical_fov) * 180.0 / std::numbers::pi,
        matrix(-camera.right, camera.up, camera.forward, camera.eye), camera.width, camera.height,
        order.knobs.samples_per_pixel, order.knobs.seed & 0x7fffffffu);
    if (order.scene.surroundings)
        text += fmt::format(
            "  <emitter type=\"constant\"><rgb name=\"radiance\" value=\"{}\"/></emitter>\n",
            joined(order.scene.surroundings_colour));
    for (const PlainLamp& lamp : order.scene.lamps) {
        text += lamp_text(lamp, lamp.half_u, lamp.normal);
        if (lamp.two_sided) text += lamp_text(lamp, -lamp.half_u, -lamp.normal);
    }
    return text + fmt::format(
                      "  <shape type=\"obj\"><string name=\"filename\" value=\"{}\"/>"
                      "<boolean name=\"face_normals\" value=\"true\"/>\n"
                      "    <bsdf type=\"dielectric\"><float name=\"int_ior\" value=\"{}\"/>"
                      "<float name=\"ext_ior\" value=\"1\"/></bsdf></shape>\n</scene>\n",
                      kBodyFile, relative_index(order.scene, kNominal));
}

std::string mitsuba_body(const PlainBody& body) {
    std::string text;
    for (const Vec3& p : body.vertices) text += "v " + joined(p, " ") + "\n";
    for (const auto& t : body.triangles)
        text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
    return text;
}

std::unique_ptr<Contestant> find_mitsuba(const Programs& programs) {
    const auto program = programs.find("mitsuba");
    if (!program) return nullptr;
    return std::make_unique<Mitsuba>(*program);
}

}  // namespace dewbow::bench
