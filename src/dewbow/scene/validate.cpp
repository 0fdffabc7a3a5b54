// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "dewbow/base/error.h"
#include "dewbow/scene/scene.h"

namespace dewbow {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Rounding that a reflectance may exceed 1 by, and a unit vector miss its length by.
constexpr double kRounding = 1e-6;
constexpr int kMaxPictureSide = 65536;
constexpr int kMaxSpectralBins = 940;  // half a nanometre
constexpr double kMaxFilterRadius = 16.0;

[[noreturn]] void fail(const std::string& who, const std::string& what) {
    throw InputError(who + ": " + what);
}

/// `who` is 'material "gold"', `what` "roughness".
void check_range(const std::string& who, const char* what, double value, double low, double high) {
    if (value >= low && value <= high && std::isfinite(value)) return;
    if (high == kInfinity) {
        fail(who, fmt::format("{} is {}; it must be at least {} and finite", what, value, low));
    }
    fail(who, fmt::format("{} is {}; it must be between {} and {}", what, value, low, high));
}

void check_positive(const std::string& who, const char* what, double value) {
    if (value > 0.0 && std::isfinite(value)) return;
    fail(who, fmt::format("{} is {}; it must be greater than 0 and finite", what, value));
}

void check_index(const std::string& who, const char* what, int index, std::size_t size) {
    if (index >= 0 && std::size_t(index) < size) return;
    fail(who, fmt::format("{} has the index {}, but there are {} materials", what, index, size));
}

/// Looks at `spectrum` at every nanometre of the visible range.
void check_spectrum(const std::string& who, const char* what, const SpectrumPtr& spectrum,
                    double high = kInfinity) {
    if (!spectrum) fail(who, fmt::format("{} is missing", what));
    constexpr std::size_t kCount = std::size_t(kLambdaMax_nm - kLambdaMin_nm) + 1;
    std::array<double, kCount> lambda_nm, values;
    for (std::size_t i = 0; i < kCount; ++i) lambda_nm[i] = kLambdaMin_nm + double(i);
    spectrum->eval_lanes(lambda_nm, values);
    for (std::size_t i = 0; i < kCount; ++i) {
        if (values[i] >= 0.0 && values[i] <= high && std::isfinite(values[i])) continue;
        const std::string range = high == kInfinity
                                      ? "at least 0 and finite"
                                      : fmt::format("between 0 and {}", std::floor(high));
        fail(who,
             fmt::format("{} is {} at {} nm; it must be {}", what, values[i], lambda_nm[i], range));
    }
    // A line between two samples must be finite too.
    if (!std::isfinite(spectrum->max_value())) fail(who, fmt::format("{} is not finite", what));
}

void check_share(const std::string& who, const char* what, const SpectrumPtr& spectrum) {
    check_spectrum(who, what, spectrum, 1.0 + kRounding);
}

void check_medium(const std::string& who, const MediumPtr& medium) {
    if (!medium) fail(who, "its medium is missing");
    if (!medium->index) fail(who, "its medium has no index of refraction");
    if (medium->absorption) check_spectrum(who, "absorption", medium->absorption);
}

void check_finite(const std::string& who, const char* what, Vec3 v) {
    if (!is_finite(v)) fail(who, fmt::format("{} is not finite", what));
}

void check_unit(const std::string& who, const char* what, Vec3 v) {
    check_finite(who, what, v);
    if (std::abs(length(v) - 1.0) > kRounding) {
        fail(who, fmt::format("{} has the length {}; it must be 1", what, length(v)));
    }
}

void check_affine(const std::string& who, const Affine& affine) {
    for (const auto& row : affine.m) {
        for (const double value : row) {
            if (!std::isfinite(value)) fail(who, "its transform is not finite");
        }
    }
}

// ---- materials ---------------------------------------------------------------------------------

struct CheckSurface {
    const std::string& who;
    const Scene& scene;

    void operator()(const Black&) const {}
    void operator()(const Diffuse& s) const { check_share(who, "reflectance", s.reflectance); }
    void operator()(const Mirror& s) const { check_share(who, "reflectance", s.reflectance); }
    void operator()(const Dielectric& s) const {
        check_medium(who, s.interior);
        check_range(who, "roughness", s.roughness, 0.0, 1.0);
        if (s.tint) check_share(who, "tint", s.tint);
    }
    void operator()(const ThinDielectric& s) const {
        if (!s.index) fail(who, "its index of refraction is missing");
        if (s.tint) check_share(who, "tint", s.tint);
    }
    void operator()(const MetallicRoughness& s) const {
        check_share(who, "base colour", s.base_colour);
        check_range(who, "metalness", s.metalness, 0.0, 1.0);
        check_range(who, "roughness", s.roughness, 0.0, 1.0);
        check_range(who, "index of refraction", s.ior, 1.0, 10.0);
    }
    void operator()(const Mix& s) const {
        check_index(who, "the first material of the mix", s.first, scene.materials.size());
        check_index(who, "the second material of the mix", s.second, scene.materials.size());
        check_range(who, "the share of the second material", s.second_share, 0.0, 1.0);
    }
};

std::string name_of(const Material& material) {
    return fmt::format("material \"{}\"", material.name);
}

enum class Visit : char { not_yet, under_way, done };

/// Mixes may hold mixes, but none itself. The indices are known to be in range.
void check_no_cycle(const Scene& scene, int index, std::vector<Visit>& visits, int depth) {
    constexpr int kMaxMixDepth = 64;
    Visit& visit = visits[std::size_t(index)];
    const Material& material = scene.materials[std::size_t(index)];
    if (visit == Visit::under_way) fail(name_of(material), "this mix contains itself");
    if (depth > kMaxMixDepth) fail(name_of(material), "mixes are nested more than 64 deep");
    if (visit == Visit::done) return;
    visit = Visit::under_way;
    if (const auto* mix = std::get_if<Mix>(&material.surface)) {
        check_no_cycle(scene, mix->first, visits, depth + 1);
        check_no_cycle(scene, mix->second, visits, depth + 1);
    }
    visit = Visit::done;
}

void check_materials(const Scene& scene) {
    for (const Material& material : scene.materials) {
        const std::string who = name_of(material);
        std::visit(CheckSurface{who, scene}, material.surface);
        if (material.emission) check_spectrum(who, "emission", material.emission);
    }
    std::vector<Visit> visits(scene.materials.size(), Visit::not_yet);
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        check_no_cycle(scene, int(i), visits, 0);
}

// ---- shapes ------------------------------------------------------------------------------------

struct CheckGeometry {
    const std::string& who;

    void operator()(const std::shared_ptr<const Mesh>& mesh) const {
        if (!mesh) fail(who, "its mesh is missing");
        if (mesh->triangles.empty()) fail(who, "its mesh has no triangle");
        if (!mesh->normals.empty() && mesh->normals.size() != mesh->vertices.size()) {
            fail(who, fmt::format("its mesh has {} normals for {} vertices", mesh->normals.size(),
                                  mesh->vertices.size()));
        }
        for (const Point<Object>& vertex : mesh->vertices) check_finite(who, "a vertex", vertex.v);
        for (const Normal<Object>& normal : mesh->normals) {
            check_finite(who, "a normal", normal.v);
            if (normal.v == Vec3{}) fail(who, "a normal has no direction");
        }
        for (const auto& triangle : mesh->triangles) {
            const std::uint32_t largest = std::max({triangle[0], triangle[1], triangle[2]});
            if (largest < mesh->vertices.size()) continue;
            fail(who,
                 fmt::format("a triangle uses vertex {} of {}", largest, mesh->vertices.size()));
        }
    }
    void operator()(const Sphere& s) const { check_positive(who, "radius", s.radius.to(unit::m)); }
    void operator()(const Disc& s) const { check_positive(who, "radius", s.radius.to(unit::m)); }
    void operator()(const Rectangle& s) const {
        check_positive(who, "width", s.width.to(unit::m));
        check_positive(who, "height", s.height.to(unit::m));
    }
    void operator()(const Box& s) const {
        check_positive(who, "width", s.width.to(unit::m));
        check_positive(who, "height", s.height.to(unit::m));
        check_positive(who, "depth", s.depth.to(unit::m));
    }
    void operator()(const Prism& s) const {
        const double apex_deg = s.apex.to(unit::deg);
        if (!(apex_deg > 0.0 && apex_deg < 180.0)) {
            fail(who, fmt::format("apex is {} deg; it must be between 0 and 180 deg", apex_deg));
        }
        check_positive(who, "side", s.side.to(unit::m));
        check_positive(who, "length", s.length.to(unit::m));
    }
    void operator()(const Plane&) const {}
};

void check_shapes(const Scene& scene) {
    for (const Shape& shape : scene.shapes) {
        const std::string who = fmt::format("shape \"{}\"", shape.name);
        check_index(who, "its material", shape.material, scene.materials.size());
        check_affine(who, shape.world_from_object.affine());
        std::visit(CheckGeometry{who}, shape.geometry);
    }
}

// ---- lights ------------------------------------------------------------------------------------

struct CheckLight {
    const std::string& who;

    void operator()(const PointLight& light) const {
        check_finite(who, "position", light.position.v);
        check_spectrum(who, "intensity", light.intensity);
    }
    void operator()(const SpotLight& light) const {
        check_finite(who, "position", light.position.v);
        check_unit(who, "direction", light.direction.v);
        check_range(who, "the outer angle in degrees", light.outer.to(unit::deg), 0.0,
                    90.0 + kRounding);
        check_range(who, "the inner angle in degrees", light.inner.to(unit::deg), 0.0,
                    light.outer.to(unit::deg));
        if (!(light.inner < light.outer)) fail(who, "the inner angle must be less than the outer");
        check_spectrum(who, "intensity", light.intensity);
    }
    void operator()(const DistantLight& light) const {
        check_unit(who, "direction", light.direction.v);
        check_range(who, "the angular radius in degrees", light.angular_radius.to(unit::deg), 0.0,
                    90.0);
        check_spectrum(who, "irradiance", light.irradiance);
    }
    void operator()(const UniformEnvironment& light) const {
        check_spectrum(who, "radiance", light.radiance);
    }
    void operator()(const std::shared_ptr<const ImageEnvironment>& light) const {
        if (!light) fail(who, "its picture is missing");
        if (light->width < 1 || light->height < 1 ||
            light->pixels.size() != std::size_t(light->width) * std::size_t(light->height)) {
            fail(who, fmt::format("its picture has {} pixels for {} x {}", light->pixels.size(),
                                  light->width, light->height));
        }
        check_range(who, "scale", light->scale, 0.0, kInfinity);
        check_affine(who, light->world_from_object.affine());
        for (const auto& pixel : light->pixels) {
            for (const double value : pixel.v) {
                if (!std::isfinite(value)) fail(who, "a pixel of its picture is not finite");
            }
        }
    }
};

void check_lights(const Scene& scene) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const std::string who = fmt::format("light {}", i + 1);
        std::visit(CheckLight{who}, scene.lights[i]);
    }
}

// ---- the picture -------------------------------------------------------------------------------

void check_camera(const PerspectiveCamera& camera) {
    const std::string who = fmt::format("camera \"{}\"", camera.name);
    check_affine(who, camera.world_from_camera.affine());
    const double degrees = camera.vertical_field_of_view.to(unit::deg);
    if (degrees > 0.0 && degrees < 180.0) return;
    fail(who,
         fmt::format("the vertical field of view is {} deg; it must be between 0 and 180 deg, both "
                     "excluded",
                     degrees));
}

void check_film(const Film& film) {
    const std::string who = "film";
    check_range(who, "width", film.width, 1, kMaxPictureSide);
    check_range(who, "height", film.height, 1, kMaxPictureSide);
    check_positive(who, "filter radius", film.filter.radius);
    check_range(who, "filter radius", film.filter.radius, 0.0, kMaxFilterRadius);
    check_positive(who, "white luminance", film.white_luminance);
    check_range(who, "exposure", film.exposure_stops, -100.0, 100.0);
    check_range(who, "the number of spectral bins", film.spectral_bins, 0, kMaxSpectralBins);
}

void check_render(const RenderSettings& render) {
    const std::string who = "render";
    check_range(who, "samples per pixel", render.samples_per_pixel, 1,
                std::numeric_limits<int>::max());
    if (render.packet != 1 && render.packet != 4 && render.packet != 8 && render.packet != 16) {
        fail(who, fmt::format("packet is {}; it must be 1, 4, 8 or 16", render.packet));
    }
    check_range(who, "the greatest depth", render.max_depth, 0, std::numeric_limits<int>::max());
    check_range(who, "the roulette's depth", render.roulette_depth, 0,
                std::numeric_limits<int>::max());
}

}  // namespace

void validate(const Scene& scene) {
    check_camera(scene.camera);
    check_film(scene.film);
    check_render(scene.render);
    check_medium("surroundings", scene.surroundings);
    check_materials(scene);
    check_shapes(scene);
    check_lights(scene);
}

}  // namespace dewbow
