// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/estimator_choice.h"

#include <fmt/format.h>

#include <algorithm>

#include "dewbow/render/caustics/casters.h"
#include "dewbow/render/light_share.h"
#include "dewbow/render/media.h"
#include "dewbow/render/surface/scattering_surface.h"

namespace dewbow {

namespace {

const EstimatorRow& row_of(const std::string& name) {
    const auto& rows = estimators();
    const auto found = std::find_if(rows.begin(), rows.end(),
                                    [&](const EstimatorRow& row) { return row.name == name; });
    DEWBOW_CHECK(found != rows.end(), "the estimators that auto takes are there");
    return *found;
}

/// Whether the surface, or any part of a mix, scatters.
bool scatters(const Scene& scene, const Material& material) {
    const auto* mix = std::get_if<Mix>(&material.surface);
    if (!mix) return ScatteringSurface::holds(material);
    return scatters(scene, scene.materials[std::size_t(mix->first)]) ||
           scatters(scene, scene.materials[std::size_t(mix->second)]);
}

/// Why no light path could bring anything, as the description alone tells; empty if it does not.
std::string reason_in_description(const Scene& scene) {
    const auto any = [&](auto&& is) {
        return std::any_of(scene.shapes.begin(), scene.shapes.end(), [&](const Shape& shape) {
            return is(scene.materials[std::size_t(shape.material)]);
        });
    };
    if (!(scene.render.caustics.light_paths > 0.0)) return "render.caustics.light_paths is 0";
    if (!any([&](const Material& m) { return caustics::is_caster(scene, m); }))
        return "nothing here bends or mirrors light";
    if (scene.lights.empty() && !any([](const Material& m) { return m.gives_light(); }))
        return "nothing here gives light";
    if (!any([&](const Material& m) { return scatters(scene, m); }) &&
        !MediaTable(scene).scatters())
        return "nothing here scatters light";
    return {};
}

}  // namespace

EstimatorChoice choose_estimator(const Scene& scene) {
    const EstimatorRow& path = row_of("path");
    if (std::string reason = reason_in_description(scene); !reason.empty())
        return {path, path.make(scene), std::move(reason)};
    auto estimator = std::make_unique<CausticsEstimator>(scene);
    const auto as_path = [&] {
        return std::make_unique<CausticsEstimator>(estimator->with_share_of_light_paths(0.0));
    };
    if (!(estimator->light_paths() > 0.0))
        return {path, as_path(), "no lamp shines on anything that bends or mirrors light"};
    const double share = light_share(*estimator, scene);
    if (share < kLeastLightShare)
        return {path, as_path(),
                "what glass and mirrors throw is little, or found from the camera"};
    estimator->aim();
    return {
        row_of("caustics"), std::move(estimator),
        fmt::format("glass and mirrors throw {:.2g} % of the light, which paths from the camera "
                    "would miss",
                    100.0 * share)};
}

}  // namespace dewbow
