// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/emission_map.h"

#include <type_traits>

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

EmissionMaps::EmissionMaps(const PreparedScene& prepared, const Casters& casters) {
    using Source = LightSample::Source;
    const LightSet& lights = prepared.lights;
    aims_ = std::make_unique<const Aims>(prepared.scene, casters,
                                         lights.shapes().size() + lights.punctual().size() +
                                             lights.beams().size() + lights.infinite().size());
    const auto add = [&]<class Map>(Source source, const auto& lamps, std::type_identity<Map>) {
        first_[std::size_t(source)] = size();
        for (std::size_t i = 0; i < lamps.size(); ++i)
            maps_.push_back(std::make_unique<Map>(lamps[i], int(i), *aims_));
    };
    add(Source::shape, lights.shapes(), std::type_identity<SurfaceEmission>{});
    add(Source::punctual, lights.punctual(), std::type_identity<PointEmission>{});
    add(Source::beam, lights.beams(), std::type_identity<BeamEmission>{});
    add(Source::infinite, lights.infinite(), std::type_identity<DistantEmission>{});
}

EmissionMaps::~EmissionMaps() = default;

}  // namespace dewbow::caustics
