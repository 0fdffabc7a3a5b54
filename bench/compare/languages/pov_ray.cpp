// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common.h"
#include "dewbow/base/file.h"
#include "interfaces.h"

// POV-Ray 3.7. Its dispersion: n(λ) = n₀ D^(−(λ − 555 nm)/350 nm), a ray split at the first
// refraction into N rays at the middles of N equal bands over 380–730 nm, coloured by a table of
// hues and never jittered; Fresnel reflection at n₀. Caustics are photon maps: photons are shot at
// the bodies, and those that are nearest to a point tell its light.

namespace dewbow::bench {
namespace {

constexpr Wavelength kNominal = 555.0 * unit::nm;
constexpr Wavelength kFirst = 380.0 * unit::nm, kLast = 730.0 * unit::nm;

/// POV-Ray's own greatest max_trace_level.
constexpr int kMostDepth = 256;

/// Rays that would add less than this share are not followed. Seen on the diamond: 1e-4 adds 5e-4
/// of the light, POV-Ray's default of 1/255 loses 2e-3 and saves a seventh of the time.
constexpr double kBailout = 1e-3;

/// Rays along each side of a pixel where photons tell the light.
constexpr int kPhotonSide = 2;

std::string camera_text(const PlainCamera& camera) {
    const double height = 2.0 * camera.tan_half_vertical_fov;
    return fmt::format(
        "camera {{\n  perspective location <{}>\n  direction <{}>\n  right <{}>\n  up <{}>\n}}\n",
        joined(camera.eye), joined(camera.forward),
        joined(camera.right * (height * camera.width / camera.height)), joined(camera.up * height));
}

std::string lamp_text(const PlainLamp& lamp) {
    std::string text;
    if (lamp.shape == LampShape::disc) {
        text = fmt::format("disc {{ 0, z, 1 matrix <{}, {}, {}, {}>", joined(lamp.half_u),
                           joined(lamp.half_v), joined(lamp.normal), joined(lamp.centre));
    } else {
        text = "polygon { 5";
        const std::array<Vec3, 4> c = corners(lamp);
        for (const int i : {0, 1, 2, 3, 0}) text += fmt::format(", <{}>", joined(c[i]));
    }
    text += fmt::format(" texture {{ pigment {{ rgb <{}> }} {} }}", joined(lamp.colour),
                        "finish { ambient 0 diffuse 0 emission 1 }");
    if (!lamp.two_sided)
        text += " interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } }";
    return text + " }\n";
}

std::string surface_text(const PlainBody& body) {
    if (body.sphere)
        return fmt::format("sphere {{ <{}>, {}\n", joined(body.sphere->centre),
                           body.sphere->radius);
    std::string text = "mesh {\n";
    for (const auto& triangle : body.triangles) {
        text += "  triangle {";
        for (int k = 0; k < 3; ++k)
            text += fmt::format("{} <{}>", k == 0 ? "" : ",", joined(body.vertices[triangle[k]]));
        text += " }\n";
    }
    return text;
}

std::string body_text(const SceneOrder& order, const PlainBody& body) {
    std::string text = surface_text(body);
    const auto n = [&](Wavelength lambda) { return relative_index(order.scene, body, lambda); };
    text +=
        "  texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel on }"
        " conserve_energy } }\n";
    text += fmt::format("  interior {{ ior {}", n(kNominal));
    if (order.knobs.spectral_samples > 1)
        text += fmt::format(" dispersion {} dispersion_samples {}", n(kFirst) / n(kLast),
                            order.knobs.spectral_samples);
    text += " }\n";
    if (order.scene.has_caustics()) text += "  photons { target reflection on refraction on }\n";
    return text + "}\n";
}

/// What fills a hollow of another body, told as if it lay within that body, and the hollow began at
/// its upper side, under a film of glass: POV-Ray knows what lies within what, and nothing of
/// surfaces that two bodies share. Light through the film goes on as without it; of what water
/// reflects it makes some more.
std::string bodies_text(const SceneOrder& order) {
    const PlainScene& scene = order.scene;
    if (scene.bodies.size() == 1) return body_text(order, scene.bodies[0]);
    constexpr double kFilm = 0.01;  // of a unit: it misses what is nearer than 1e-4
    std::vector<PlainBody> told = scene.bodies;
    for (PlainBody& body : told) body.vertices.clear(), body.triangles.clear();
    const auto add = [](PlainBody& body, const PlainBody& surface, Vec3 shift) {
        const auto first = std::uint32_t(body.vertices.size());
        for (const Vec3 vertex : surface.vertices) body.vertices.push_back(vertex + shift);
        for (const auto& t : surface.triangles)
            body.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    };
    for (const Interface& interface : interfaces_of(scene)) {
        PlainBody& inside = told[std::size_t(interface.inside)];
        const bool is_vessel = interface.inside == 0;
        if (interface.outside >= 0) {
            add(told[std::size_t(interface.outside)], interface.surface, {});
        } else {
            add(told[0], interface.surface, {});
            if (!is_vessel) add(inside, interface.surface, {0.0, -kFilm, 0.0});
        }
    }
    std::string text;
    for (const PlainBody& body : told) text += body_text(order, body);
    return text;
}

int side(int samples) { return std::max(1, int(std::lround(std::sqrt(double(samples))))); }

/// The same scene in centimetres: some of POV-Ray's least distances are in units.
PlainScene in_centimetres(PlainScene scene) {
    constexpr double kPerMetre = 100.0;
    scene.camera.eye *= kPerMetre;
    for (PlainBody& body : scene.bodies) {
        for (Vec3& vertex : body.vertices) vertex *= kPerMetre;
        if (body.sphere)
            body.sphere = {body.sphere->centre * kPerMetre, body.sphere->radius * kPerMetre};
    }
    for (PlainLamp& lamp : scene.lamps)
        for (Vec3* v : {&lamp.centre, &lamp.half_u, &lamp.half_v}) *v *= kPerMetre;
    for (PlainReceiver& receiver : scene.receivers)
        for (Vec3* v : {&receiver.centre, &receiver.half_u, &receiver.half_v}) *v *= kPerMetre;
    for (PlainSpot& spot : scene.spots) {
        spot.position *= kPerMetre;
        spot.colour = spot.colour * (kPerMetre * kPerMetre);
    }
    return scene;
}

std::string receiver_text(const PlainReceiver& r) {
    std::string text = "polygon { 5";
    const Vec3 corners[] = {r.centre - r.half_u - r.half_v, r.centre + r.half_u - r.half_v,
                            r.centre + r.half_u + r.half_v, r.centre - r.half_u + r.half_v};
    for (const int i : {0, 1, 2, 3, 0}) text += fmt::format(", <{}>", joined(corners[i]));
    return text + fmt::format(
                      " texture {{ pigment {{ rgb {} }} finish {{ ambient 0 diffuse 1 }} }} "
                      "photons {{ collect {} }} }}\n",
                      r.reflectance, r.reflectance > 0.0 ? "on" : "off");
}

/// Light falls off as 2 / (1 + (d / d₀)²), which is that of a distance squared far beyond d₀.
constexpr double kFade = 0.01;
/// @param intensity  irradiance at a distance of one unit, over π: what a white wall then is.
std::string light_text(Vec3 position, const Colour<LinearSrgb>& intensity,
                       const std::string& kind) {
    const double scale = 1.0 / (2.0 * kFade * kFade);
    return fmt::format(
        "light_source {{ <{}> rgb <{}> {}\n  fade_distance {} fade_power 2\n"
        "  photons {{ reflection on refraction on area_light }} }}\n",
        joined(position), joined(intensity * (scale / std::numbers::pi)), kind, kFade);
}

std::string light_text(const PlainLamp& lamp) {
    /// Points along each side of a lamp.
    constexpr int kPoints = 9;
    double area = 4.0 * length(cross(lamp.half_u, lamp.half_v));
    if (lamp.shape == LampShape::disc) area *= std::numbers::pi / 4.0;
    // As bright as the cosine of the angle from its axis.
    const std::string kind = fmt::format(
        "spotlight point_at <{}> radius 89 falloff 90 tightness 1\n"
        "  area_light <{}>, <{}>, {}, {} {} adaptive 2",
        joined(lamp.centre + lamp.normal), joined(lamp.half_u * 2.0), joined(lamp.half_v * 2.0),
        kPoints, kPoints, lamp.shape == LampShape::disc ? "circular" : "");
    return light_text(lamp.centre, lamp.colour * area, kind);
}

std::string light_text(const PlainSpot& spot) {
    const double degrees = spot.half_angle_rad * 180.0 / std::numbers::pi;
    return light_text(spot.position, spot.colour,
                      fmt::format("spotlight point_at <{0}> radius {1} falloff {1} tightness 0",
                                  joined(spot.position + spot.direction), degrees));
}

class PovRay : public Contestant {
public:
    PovRay(bool photons, std::filesystem::path program)
        : photons_(photons),
          program_(std::move(program)),
          version_(version_line(program_, "--version", "POV-Ray ")) {}
    std::string name() const override { return photons_ ? "pov-ray-photons" : "pov-ray"; }
    bool shows(const PlainScene& scene) const override { return scene.has_caustics() == photons_; }
    std::string version() const override { return version_; }
    bool splits_spectrum() const override { return true; }
    bool converges_to_truth() const override { return false; }
    bool uses_seed() const override { return false; }
    int possible_samples_per_pixel(int wanted) const override {
        if (photons_) return wanted;
        return side(wanted) * side(wanted);
    }

    std::vector<std::string> write(const Order& order) const override {
        write_file_atomically(order.folder / "scene.pov", photons_
                                                              ? pov_photon_scene(scene_order(order))
                                                              : pov_scene(scene_order(order)));
        const PlainCamera& camera = order.scene.plain.camera;
        std::vector<std::string> words = {program_.string(),
                                          "+Iscene.pov",
                                          std::string("+O") + kPictureFile,
                                          "+FE",
                                          fmt::format("+W{}", camera.width),
                                          fmt::format("+H{}", camera.height),
                                          fmt::format("+WT{}", order.threads),
                                          "-D",
                                          "-V",
                                          "-GA",
                                          "File_Gamma=1.0"};
        // Threshold 0: every pixel is taken apart, whatever its neighbours are; n² rays after a
        // first one.
        const int n = photons_ ? kPhotonSide : side(order.knobs.samples_per_pixel);
        if (n == 1) {
            words.emplace_back("-A");
        } else {
            for (const char* word : {"+A0.0", "+AM1", "-J"}) words.emplace_back(word);
            words.push_back(fmt::format("+R{}", n));
        }
        return words;
    }
    Picture read(const Order& order) const override { return read_left_picture(order); }

private:
    bool photons_;
    std::filesystem::path program_;
    std::string version_;
};

}  // namespace

std::string pov_photon_scene(const SceneOrder& metres) {
    const PlainScene scene = in_centimetres(metres.scene);
    const SceneOrder order{scene, metres.knobs, metres.threads, metres.max_depth};
    const int depth = std::clamp(order.max_depth, 1, kMostDepth);
    const auto photons =
        std::int64_t{order.knobs.samples_per_pixel} * scene.camera.width * scene.camera.height;
    std::string text = fmt::format(
        "#version 3.7;\n"
        "global_settings {{ assumed_gamma 1.0 max_trace_level {0} adc_bailout {1}\n"
        "  photons {{ count {2} autostop 0 max_trace_level {0} adc_bailout {1} }} }}\n",
        depth, kBailout, photons);
    text += camera_text(scene.camera);
    for (const PlainLamp& lamp : scene.lamps) text += light_text(lamp);
    for (const PlainSpot& spot : scene.spots) text += light_text(spot);
    for (const PlainSun& sun : metres.scene.suns) {
        PlainScene far;
        far.lamps = {lamp_for(sun)};
        text += light_text(in_centimetres(far).lamps[0]);
    }
    for (const PlainReceiver& receiver : scene.receivers) text += receiver_text(receiver);
    return text + bodies_text(order);
}

std::string pov_scene(const SceneOrder& order) {
    std::string text = fmt::format(
        "#version 3.7;\n"
        "global_settings {{ assumed_gamma 1.0 max_trace_level {} adc_bailout {} }}\n"
        "background {{ rgb <{}> }}\n",
        std::clamp(order.max_depth, 1, kMostDepth), kBailout,
        joined(order.scene.surroundings_colour));
    text += camera_text(order.scene.camera);
    for (const PlainLamp& lamp : order.scene.lamps) text += lamp_text(lamp);
    return text + bodies_text(order);
}

std::unique_ptr<Contestant> find_pov_ray(const Programs& programs) {
    const auto program = programs.find("povray");
    if (!program) return nullptr;
    return std::make_unique<PovRay>(false, *program);
}

std::unique_ptr<Contestant> find_pov_ray_photons(const Programs& programs) {
    const auto program = programs.find("povray");
    if (!program) return nullptr;
    return std::make_unique<PovRay>(true, *program);
}

}  // namespace dewbow::bench
