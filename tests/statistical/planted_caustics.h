// SPDX-License-Identifier: Apache-2.0
#pragma once

// Light paths with a fault, made of the parts of the product: tests that are to turn red use them.

#include "dewbow/render/caustics/lamp_media.h"
#include "dewbow/render/caustics/light_walk.h"
#include "dewbow/render/path/path.h"

namespace dewbow::kit {

/// As it should be: a plant overrides what it spoils.
class SoundWalk : public caustics::LightWalk {
public:
    using LightWalk::LightWalk;
};

/// One lane of a packet never arrives on its own.
class LosesALane : public caustics::LightWalk {
public:
    using LightWalk::LightWalk;

private:
    bool on_scatterer(const walk::SharedPath& path, const walk::Scatterer& at) override {
        constexpr int kLost = 2;
        const bool lost = path.lanes.count == 1 && path.lanes.id[0] == kLost;
        return lost || LightWalk::on_scatterer(path, at);
    }
};

/// A lane that goes on for all stands for itself alone, and the others for it.
class WeighsOpenLanesTwice : public caustics::LightWalk {
public:
    using LightWalk::LightWalk;

private:
    bool on_scatterer(const walk::SharedPath& path, const walk::Scatterer& at) override {
        if (path.lanes.count > 1) return LightWalk::on_scatterer(path, at);
        walk::SharedPath twice = path;
        twice.beta[0] *= 2.0;
        return LightWalk::on_scatterer(twice, at);
    }
};

/// Where a lane leaves glass it is mostly reflected, as often as it should be refracted.
class SwapsReflectionAndRefraction : public caustics::LightWalk {
public:
    using LightWalk::LightWalk;

private:
    /// Below the reflectance it reflects: numbers near 0 nearly always do.
    double choice_of_lanes(const walk::OpenPath& path) const override {
        constexpr double kReflectance = 0.05;  // about, of flint
        const double u = LightWalk::choice_of_lanes(path);
        return u < kReflectance ? 1.0 - u : (u - kReflectance) * kReflectance;
    }
};

/// Light paths leave what they find by way of rough glass to next event, which does not know it.
class LeavesRoughGlassToNextEvent : public caustics::LightWalk {
public:
    using LightWalk::LightWalk;

private:
    void on_rough_turn(walk::SharedPath& lane, const walk::RoughGlass&) override {
        constexpr double kFarTooDense = 1e6;
        if (lane.sees_start()) lane.note = kFarTooDense;
    }
};

/// Camera paths as they are, and light paths of one kind; nothing is learnt.
template <class Walk>
class CausticsBy : public Estimator {
public:
    explicit CausticsBy(const Scene& scene)
        : prepared_(scene),
          emission_(prepared_),
          lamp_media_(prepared_),
          light_paths_{emission_,
                       scene.render.caustics.light_paths * scene.film.width * scene.film.height} {}

    void render(const Unit& unit, FilmSums& film) const override {
        for_each_sample(unit, prepared_.scene.render.seed, [&](int x, int y, std::int64_t i) {
            film.add(x, y, trace_pixel_sample(prepared_, x, y, std::uint32_t(i), &light_paths_), i);
        });
    }
    double light_paths() const override { return prepared_.scene.render.caustics.light_paths; }
    void trace_light(const LightUnit& unit, SplatList& splats) const override {
        const RenderSettings& settings = prepared_.scene.render;
        for (std::uint64_t i = unit.first_path; i < unit.end_path; ++i) {
            const SampleKey key = light_path_key(settings.seed, unit.pass, i);
            const auto ray = emission_.sample(key);
            if (!ray) continue;
            const WavelengthPacket packet =
                sample_wavelengths(settings.wavelengths, settings.packet,
                                   key.one(0, Purpose::wavelength) / settings.packet);
            const bool afar = ray->source == LightSample::Source::infinite;
            Walk(prepared_, light_paths_, packet, key, splats)
                .run(*ray, afar ? MediaStack{} : lamp_media_.along(ray->ray));
        }
    }

private:
    PreparedScene prepared_;
    caustics::AimedEmission emission_;
    caustics::LampMedia lamp_media_;
    caustics::LightPaths light_paths_;
};

}  // namespace dewbow::kit
