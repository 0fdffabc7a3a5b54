// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "dewbow/scene/checks.h"

namespace dewbow::checks {
namespace {

bool transmits(const Material& material) {
    return std::holds_alternative<Dielectric>(material.surface) ||
           std::holds_alternative<ThinDielectric>(material.surface);
}
MediumPtr interior_of(const Material& material) {
    const auto* body = std::get_if<Dielectric>(&material.surface);
    return body ? body->interior : nullptr;
}

struct CheckSurface {
    const std::string& who;
    const Scene& scene;

    void operator()(const Black&) const {}
    void operator()(const Diffuse& s) const { needed("reflectance", s.reflectance); }
    void operator()(const Mirror& s) const { needed("reflectance", s.reflectance); }
    void operator()(const Dielectric& s) const {
        check_medium(who, s.interior);
        check_share(who, "roughness", s.roughness);
        check_share(who, "tint", s.tint);
    }
    void operator()(const ThinDielectric& s) const {
        if (!s.index) fail(who, "its index of refraction is missing");
        check_share(who, "roughness", s.roughness);
        check_share(who, "tint", s.tint);
    }
    void operator()(const Conductor& s) const {
        check_spectrum(who, "n", s.n);
        check_spectrum(who, "k", s.k);
        check_share(who, "roughness", s.roughness);
    }
    void operator()(const MetallicRoughness& s) const {
        needed("base colour", s.base_colour);
        check_share(who, "metalness", s.metalness);
        check_share(who, "roughness", s.roughness);
        check_range(who, "index of refraction", s.ior, 1.0, 10.0);
        check_share(who, "specular", s.specular);
        check_share(who, "specular colour", s.specular_colour);
        check_share(who, "clearcoat", s.clearcoat);
        check_share(who, "clearcoat roughness", s.clearcoat_roughness);
        check_share(who, "sheen colour", s.sheen_colour);
        check_share(who, "sheen roughness", s.sheen_roughness);
    }
    void operator()(const Mix& s) const {
        check_index(who, "the first material of the mix", s.first, scene.materials.size());
        check_index(who, "the second material of the mix", s.second, scene.materials.size());
        check_share(who, "the share of the second material", s.second_share);
        const Material &first = scene.materials[std::size_t(s.first)],
                       &second = scene.materials[std::size_t(s.second)];
        for (const Material* part : {&first, &second})
            if (part->coverage)
                fail(who, fmt::format("its part \"{}\" is covered in part; let the mix be so",
                                      part->name));
        for (const Material* part : {&first, &second})
            if (part->gives_light())
                fail(who,
                     fmt::format("its part \"{}\" gives off light; let the mix do so", part->name));
        if (transmits(first) && transmits(second) && interior_of(first) != interior_of(second))
            fail(who, "both of its parts let light through, into different media");
    }

private:
    void needed(const char* what, const ColourInput& input) const {
        if (!input.varies() && !input.spectrum) fail(who, fmt::format("{} is missing", what));
        check_share(who, what, input);
    }
};

void check_pictures(const std::string& who, const Material& material) {
    if (const auto& emission = material.emission_texture) {
        check_texture(who, "emission texture", emission->texture);
        for (const double channel : emission->factor.v)
            check_range(who, "factor of the emission texture", channel, 0.0, kInfinity);
    }
    if (const auto& coverage = material.coverage) {
        check_share(who, "alpha", coverage->alpha);
        if (coverage->cutoff) check_range(who, "alpha cutoff", *coverage->cutoff, 0.0, kInfinity);
    }
    if (const auto& normal_map = material.normal_map) {
        check_texture(who, "normal map", normal_map->texture);
        check_range(who, "scale of the normal map", normal_map->scale, -kInfinity, kInfinity);
    }
}

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

}  // namespace

void check_materials(const Scene& scene) {
    for (const Material& material : scene.materials) {
        const std::string who = name_of(material);
        std::visit(CheckSurface{who, scene}, material.surface);
        if (material.emission) check_spectrum(who, "emission", material.emission);
        check_pictures(who, material);
    }
    std::vector<Visit> visits(scene.materials.size(), Visit::not_yet);
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        check_no_cycle(scene, int(i), visits, 0);
}

}  // namespace dewbow::checks
