// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common.h"
#include "dewbow/base/file.h"

// POV-Ray 3.7. Its dispersion: n(λ) = n₀ D^(−(λ − 555 nm)/350 nm), a ray split at the first
// refraction into N rays at the middles of N equal bands over 380–730 nm, coloured by a table of
// hues and never jittered; Fresnel reflection at n₀.

namespace dewbow::bench {
namespace {

constexpr Wavelength kNominal = 555.0 * unit::nm;
constexpr Wavelength kFirst = 380.0 * unit::nm, kLast = 730.0 * unit::nm;

/// POV-Ray's own greatest max_trace_level.
constexpr int kMostDepth = 256;

/// Rays that would add less than this share are not followed. Seen on the diamond: 1e-4 adds 5e-4
/// of the light, POV-Ray's default of 1/255 loses 2e-3 and saves a seventh of the time.
constexpr double kBailout = 1e-3;

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

std::string body_text(const SceneOrder& order) {
    std::string text = "mesh {\n";
    for (const auto& triangle : order.scene.body.triangles) {
        text += "  triangle {";
        for (int k = 0; k < 3; ++k)
            text += fmt::format("{} <{}>", k == 0 ? "" : ",",
                                joined(order.scene.body.vertices[triangle[k]]));
        text += " }\n";
    }
    const auto n = [&](Wavelength lambda) { return relative_index(order.scene, lambda); };
    text +=
        "  texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel on }"
        " conserve_energy } }\n";
    text += fmt::format("  interior {{ ior {}", n(kNominal));
    if (order.knobs.spectral_samples > 1)
        text += fmt::format(" dispersion {} dispersion_samples {}", n(kFirst) / n(kLast),
                            order.knobs.spectral_samples);
    return text + " }\n}\n";
}

int side(int samples) { return std::max(1, int(std::lround(std::sqrt(double(samples))))); }

class PovRay : public Contestant {
public:
    explicit PovRay(std::filesystem::path program)
        : program_(std::move(program)), version_(version_line(program_, "--version", "POV-Ray ")) {}
    std::string name() const override { return "pov-ray"; }
    std::string version() const override { return version_; }
    bool splits_spectrum() const override { return true; }
    bool converges_to_truth() const override { return false; }
    bool uses_seed() const override { return false; }
    int possible_samples_per_pixel(int wanted) const override {
        return side(wanted) * side(wanted);
    }

    std::vector<std::string> write(const Order& order) const override {
        write_file_atomically(order.folder / "scene.pov", pov_scene(scene_order(order)));
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
        const int n = side(order.knobs.samples_per_pixel);
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
    std::filesystem::path program_;
    std::string version_;
};

}  // namespace

std::string pov_scene(const SceneOrder& order) {
    std::string text = fmt::format(
        "#version 3.7;\n"
        "global_settings {{ assumed_gamma 1.0 max_trace_level {} adc_bailout {} }}\n"
        "background {{ rgb <{}> }}\n",
        std::clamp(order.max_depth, 1, kMostDepth), kBailout,
        joined(order.scene.surroundings_colour));
    text += camera_text(order.scene.camera);
    for (const PlainLamp& lamp : order.scene.lamps) text += lamp_text(lamp);
    return text + body_text(order);
}

std::unique_ptr<Contestant> find_pov_ray(const Programs& programs) {
    const auto program = programs.find("povray");
    if (!program) return nullptr;
    return std::make_unique<PovRay>(*program);
}

}  // namespace dewbow::bench
