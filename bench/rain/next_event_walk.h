// SPDX-License-Identifier: Apache-2.0
#pragma once

// What rain is measured against: its light found as any renderer of volumes finds it.

#include "dewbow/render/path/camera_walk.h"
#include "dewbow/render/weather/drop_collisions.h"

namespace dewbow::bench {

/// Single scattering by one point of each flight and one light from there. The point is taken in
/// proportion to what is left of light on its way to the eye, exactly, in any number of rains; the
/// light as for surfaces, so that the sun is met somewhere in its disc. (Equiangular densities have
/// nothing to turn about where light comes from infinitely far.) The phase function is that of a
/// point source. Whatever else there is, surfaces, shadow rays, dimming, random numbers, is the
/// renderer's own.
class NextEventWalk : public walk::CameraWalk {
public:
    NextEventWalk(const PreparedScene& prepared, const WavelengthPacket& packet,
                  const SampleKey& key, MediaStack start)
        : CameraWalk(prepared, nullptr, packet, key, start) {}

private:
    void on_flight(const walk::SharedPath& path, const Hit& hit) override;

    DropCollisions drops_;
};

}  // namespace dewbow::bench
