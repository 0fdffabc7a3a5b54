// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/overrides.h"

#include <algorithm>

#include "dewbow/import/environment_picture.h"
#include "dewbow/import/named_glass.h"
#include "dewbow/import/nested_error.h"
#include "dewbow/import/one_line.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {
namespace {

/// "--glass Stone=diamond"
std::string option_of(const GlassOverride& wish) {
    return one_line("--glass " + wish.material + "=" + wish.glass);
}

DispersionPtr index_of(const GlassOverride& wish, Diagnostics& diagnostics) {
    try {
        return named_glass(wish.glass, {option_of(wish), 0, 0, {}}, &diagnostics);
    } catch (const InputError& error) {
        throw UsageError(option_of(wish) + ": " + error.sentence(), error.hint());
    }
}

/// The body of index `index` that comes of `surface`.
struct GlassOf {
    const std::string& name;
    const DispersionPtr& index;

    Dielectric operator()(const Dielectric& before) const {
        Dielectric body = before;
        auto medium = std::make_shared<Medium>(*before.interior);
        medium->index = index;
        body.interior = medium;
        return body;
    }
    Dielectric operator()(const ThinDielectric& before) const {
        Dielectric body = clear();
        body.roughness = before.roughness;
        body.tint = before.tint;
        return body;
    }
    template <class Other>
    Dielectric operator()(const Other&) const {
        return clear();
    }
    Dielectric clear() const {
        Dielectric body;
        auto medium = std::make_shared<Medium>();
        medium->name = name;
        medium->index = index;
        body.interior = medium;
        return body;
    }
};

bool is_glass(const Material& material) {
    return std::holds_alternative<Dielectric>(material.surface) ||
           std::holds_alternative<ThinDielectric>(material.surface);
}

void override_glass(Scene& scene, const GlassOverride& wish, Diagnostics& diagnostics) {
    const DispersionPtr index = index_of(wish, diagnostics);
    bool found = false;
    std::vector<std::string> names;
    for (Material& material : scene.materials) {
        names.push_back(material.name);
        if (material.name != wish.material) continue;
        found = true;
        if (!is_glass(material)) material.coverage.reset();
        material.surface = std::visit(GlassOf{material.name, index}, material.surface);
    }
    if (found) return;
    throw UsageError(
        option_of(wish) + one_line(": there is no material \"" + wish.material + "\""),
        names.empty() ? "the scene has no material" : one_line(hint_for(wish.material, names)));
}

bool is_environment(const Light& light) {
    return std::holds_alternative<UniformEnvironment>(light) ||
           std::holds_alternative<std::shared_ptr<const ImageEnvironment>>(light) ||
           std::holds_alternative<SkyDomePtr>(light);
}

}  // namespace

double environment_scale_of_white(const Film& film) {
    return film.white_luminance / (kLuminousEfficacy * cie_y_integral());
}

void override_glasses(Scene& scene, const std::vector<GlassOverride>& overrides,
                      Diagnostics& diagnostics) {
    for (const GlassOverride& wish : overrides) override_glass(scene, wish, diagnostics);
}

void override_environment(Scene& scene, const std::string& file, Diagnostics& diagnostics) {
    std::erase_if(scene.lights, is_environment);
    try {
        auto environment = load_environment(file, diagnostics);
        environment->scale = environment_scale_of_white(scene.film);
        scene.lights.push_back(std::shared_ptr<const ImageEnvironment>(environment));
    } catch (const InputError& error) {
        throw UsageError("--env " + sentence_with_place(error), error.hint());
    }
}

}  // namespace dewbow
