// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/emission_map.h"

#include "dewbow/render/caustics/beam_emission.h"
#include "dewbow/render/caustics/distant_emission.h"
#include "dewbow/render/caustics/point_emission.h"
#include "dewbow/render/caustics/surface_emission.h"

namespace dewbow::caustics {

void radiance(const EmittedRay& ray, const LightSet& lights, const LaneSet& lanes,
              RgbLightLanes& rgb, LaneValues& out) {
    LightSample sample;
    sample.source = ray.source;
    sample.index = ray.index;
    sample.direction = -ray.ray.direction;
    sample.factor = ray.factor;
    sample.colour = ray.colour;
    lights.radiance(sample, lanes, rgb, out);
}

EmissionMaps::EmissionMaps(const PreparedScene& prepared, const Casters& casters)
    : outside_(std::make_unique<const Outside>(prepared.scene)) {
    using Source = LightSample::Source;
    const LightSet& lights = prepared.lights;
    const auto begin = [&](Source source) { first_[std::size_t(source)] = size(); };
    begin(Source::shape);
    for (const GlowingShape& shape : lights.shapes())
        maps_.push_back(std::make_unique<SurfaceEmission>(
            shape, size() - first_[std::size_t(Source::shape)], casters.groups()));
    begin(Source::punctual);
    for (const PunctualLight& light : lights.punctual())
        maps_.push_back(std::make_unique<PointEmission>(
            light, size() - first_[std::size_t(Source::punctual)], casters.groups()));
    begin(Source::beam);
    for (const Beam& beam : lights.beams())
        maps_.push_back(std::make_unique<BeamEmission>(
            beam, size() - first_[std::size_t(Source::beam)], casters.groups()));
    begin(Source::infinite);
    for (const InfiniteLight& light : lights.infinite())
        maps_.push_back(std::make_unique<DistantEmission>(
            light, size() - first_[std::size_t(Source::infinite)], casters.groups(), *outside_));
}

EmissionMaps::~EmissionMaps() = default;

}  // namespace dewbow::caustics
