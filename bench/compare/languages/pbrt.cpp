// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <numbers>

#include "common.h"
#include "dewbow/base/file.h"
#include "dewbow/spectrum/rgb.h"
#include "interfaces.h"

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
    // In the plane z = 0, normal +z. The map does not scale: pbrt would take the disc's area as it
    // is before.
    const double u = length(lamp.half_u), v = length(lamp.half_v);
    std::string text = fmt::format("AttributeBegin\nTransform [\n{} 0\n{} 0\n{} 0\n{} 1 ]\n",
                                   joined(lamp.half_u / u, " "), joined(lamp.half_v / v, " "),
                                   joined(lamp.normal, " "), joined(lamp.centre, " "));
    text += "Material \"diffuse\" \"spectrum reflectance\" [300 0 900 0]\n";
    text += fmt::format("AreaLightSource \"diffuse\" \"bool twosided\" {} {}\n",
                        lamp.two_sided ? "true" : "false", light_text(*lamp.radiance, lamp.colour));
    text += lamp.shape == LampShape::disc ? fmt::format("Shape \"disk\" \"float radius\" [{}]\n", u)
                                          : fmt::format(
                                                "Shape \"trianglemesh\" \"point3 P\" [-{0} -{1} 0  "
                                                "{0} -{1} 0  {0} {1} 0  -{0} {1} "
                                                "0]\n  \"integer indices\" [0 1 2  0 2 3]\n",
                                                u, v);
    return text + "AttributeEnd\n";
}

std::string surface_text(const PlainBody& surface) {
    if (surface.sphere)
        return fmt::format(
            "AttributeBegin\nTranslate {}\nShape \"sphere\" \"float radius\" [{}]\nAttributeEnd\n",
            joined(surface.sphere->centre, " "), surface.sphere->radius);
    std::string points, indices;
    for (const Vec3& p : surface.vertices) points += joined(p, " ") + "\n";
    for (const auto& t : surface.triangles) indices += fmt::format("{} {} {}\n", t[0], t[1], t[2]);
    return fmt::format("Shape \"trianglemesh\" \"point3 P\" [\n{}]\n\"integer indices\" [\n{}]\n",
                       points, indices);
}

std::string bodies_text(const PlainScene& scene) {
    std::string text;
    for (const Interface& interface : interfaces_of(scene))
        text += fmt::format(
            "Material \"dielectric\" \"spectrum eta\" {}\n{}",
            table([&](Wavelength lambda) { return relative_index(scene, interface, lambda); }),
            surface_text(interface.surface));
    return text;
}

std::string receiver_text(const PlainReceiver& r) {
    const Vec3 corners[] = {r.centre - r.half_u - r.half_v, r.centre + r.half_u - r.half_v,
                            r.centre + r.half_u + r.half_v, r.centre - r.half_u + r.half_v};
    std::string points;
    for (const Vec3 corner : corners) points += joined(corner, " ") + "\n";
    return fmt::format(
        "Material \"diffuse\" \"spectrum reflectance\" [300 {0} 900 {0}]\n"
        "Shape \"trianglemesh\" \"point3 P\" [\n{1}]\n\"integer indices\" [0 1 2  0 2 3]\n",
        r.reflectance, points);
}

std::string spot_text(const PlainSpot& spot) {
    /// From full light to none, since it wants to fall off somewhere.
    constexpr double kEdge_deg = 1e-4;
    const double y = xyz_from_rgb(spot.colour)[1];
    return fmt::format(
        "LightSource \"spot\" \"spectrum I\" {} \"float scale\" [{}]\n"
        "  \"point3 from\" [{}] \"point3 to\" [{}] \"float coneangle\" [{}] "
        "\"float conedeltaangle\" [{}]\n",
        table([&](Wavelength lambda) { return (*spot.intensity)(lambda); }), y,
        joined(spot.position, " "), joined(spot.position + spot.direction, " "),
        spot.half_angle_rad * 180.0 / std::numbers::pi, kEdge_deg);
}

/// The size of a pixel on the first receiver that the camera looks at, m.
double pixel_there_m(const PlainScene& scene) {
    const Things things(scene);
    const auto met = things.first(scene.camera.eye, scene.camera.forward, 0);
    return met ? met->distance * 2.0 * scene.camera.tan_half_vertical_fov / scene.camera.height
               : 1.0;
}

/// What differs between pbrt's ways to a picture.
struct PbrtWay {
    std::string name, integrator;
    bool images = false;
};

std::string integrator_text(const SceneOrder& order, const std::string& integrator) {
    /// Vertices of a light or camera path of those that keep them all: they connect each with each.
    constexpr int kMostVertices = 16;
    const int spp = order.knobs.samples_per_pixel;
    const bool keeps_vertices = integrator == "bdpt" || integrator == "mlt";
    std::string text =
        fmt::format("Integrator \"{}\" \"integer maxdepth\" [{}]", integrator,
                    keeps_vertices ? std::min(order.max_depth, kMostVertices) : order.max_depth);
    if (integrator == "mlt") text += fmt::format(" \"integer mutationsperpixel\" [{}]", spp);
    if (integrator == "sppm")
        // It shrinks from two pixels.
        text += fmt::format(" \"float radius\" [{}] \"integer seed\" [{}]",
                            2.0 * pixel_there_m(order.scene), order.knobs.seed & 0x7fffffffu);
    return text + '\n';
}

class Pbrt : public Contestant {
public:
    Pbrt(PbrtWay way, std::filesystem::path program)
        : way_(std::move(way)),
          program_(std::move(program)),
          version_(version_line(program_, "/dev/null", "pbrt version")) {}
    std::string name() const override { return way_.name; }
    bool shows(const PlainScene& scene) const override {
        return scene.has_caustics() || way_.images;
    }
    std::string version() const override { return version_; }
    bool splits_spectrum() const override { return false; }
    bool converges_to_truth() const override { return true; }
    int possible_samples_per_pixel(int wanted) const override {
        return int(std::bit_ceil(unsigned(wanted)));  // of its Sobol' sampler, a power of two
    }

    std::vector<std::string> write(const Order& order) const override {
        write_file_atomically(order.folder / "scene.pbrt",
                              pbrt_scene(scene_order(order), way_.integrator));
        return {program_.string(), "--quiet", "--nthreads", std::to_string(order.threads),
                "scene.pbrt"};
    }
    Picture read(const Order& order) const override { return read_left_picture(order); }

private:
    PbrtWay way_;
    std::filesystem::path program_;
    std::string version_;
};

}  // namespace

std::string pbrt_scene(const SceneOrder& order, const std::string& integrator) {
    const PlainScene& scene = order.scene;
    std::string text = camera_text(scene.camera);
    text += fmt::format(
        "Film \"rgb\" \"integer xresolution\" [{}] \"integer yresolution\" [{}]\n"
        "  \"string filename\" \"{}\" \"bool savefp16\" false\n"
        "PixelFilter \"box\" \"float xradius\" [0.5] \"float yradius\" [0.5]\n"
        "Sampler \"zsobol\" \"integer pixelsamples\" [{}] \"integer seed\" [{}]\n"
        "{}WorldBegin\n",
        scene.camera.width, scene.camera.height, kPictureFile, order.knobs.samples_per_pixel,
        order.knobs.seed & 0x7fffffffu, integrator_text(order, integrator));
    if (scene.surroundings)
        text += "LightSource \"infinite\" " +
                light_text(*scene.surroundings, scene.surroundings_colour) + "\n";
    for (const PlainLamp& lamp : scene.lamps) text += lamp_text(lamp);
    for (const PlainSun& sun : scene.suns) text += lamp_text(lamp_for(sun));
    for (const PlainSpot& spot : scene.spots) text += spot_text(spot);
    for (const PlainReceiver& receiver : scene.receivers) text += receiver_text(receiver);
    return text + bodies_text(scene);
}

namespace {

std::unique_ptr<Contestant> find(const Programs& programs, PbrtWay way) {
    const auto program = programs.find("pbrt");
    if (!program) return nullptr;
    return std::make_unique<Pbrt>(std::move(way), *program);
}

}  // namespace

std::unique_ptr<Contestant> find_pbrt(const Programs& programs) {
    return find(programs, {"pbrt-path", "path", true});
}
std::unique_ptr<Contestant> find_pbrt_lightpath(const Programs& programs) {
    return find(programs, {"pbrt-lightpath", "lightpath"});
}
std::unique_ptr<Contestant> find_pbrt_bdpt(const Programs& programs) {
    return find(programs, {"pbrt-bdpt", "bdpt"});
}
std::unique_ptr<Contestant> find_pbrt_sppm(const Programs& programs) {
    return find(programs, {"pbrt-sppm", "sppm"});
}
std::unique_ptr<Contestant> find_pbrt_mlt(const Programs& programs) {
    return find(programs, {"pbrt-mlt", "mlt"});
}

}  // namespace dewbow::bench
