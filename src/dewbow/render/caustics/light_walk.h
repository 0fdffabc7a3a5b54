// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dewbow/render/caustics/weights.h"
#include "dewbow/render/splat_list.h"
#include "dewbow/render/walk/packet_walk.h"

namespace dewbow::caustics {

/// A path from a lamp. Where it meets something that scatters it is splatted to the camera, lanes
/// on one ray together, opened lanes each at its own place; then it goes on as any walk does. One
/// whose first surface scatters ends there: direct light is the camera's.
///
/// It carries the share of the lamp's light that is left at each lane; what the lamp gives, over
/// the density of the ray, is put to it at the splat.
///
/// A path's note is the density of next event over that of chance at the lamp's end (q of
/// weights.h).
class LightWalk : public walk::PacketWalk {
public:
    /// Adds to `splats`. All must outlive this.
    LightWalk(const PreparedScene& prepared, const LightPaths& light_paths,
              const WavelengthPacket& packet, const SampleKey& key, SplatList& splats);

    /// @param media  what the ray starts in.
    void run(const EmittedRay& emitted, MediaStack media);

protected:
    bool on_scatterer(const walk::SharedPath& path, const walk::Scatterer& at) override;

private:
    void on_flight(const walk::SharedPath& path, const Hit& hit) override;
    void splat(const walk::SharedPath& path, const walk::Scatterer& at);
    void splat(const walk::SharedPath& path, const walk::Scatterer& at, const Seen& seen);
    void on_rough_turn(walk::SharedPath& lane, const walk::RoughGlass& at) override;
    void splat(const walk::SharedPath& path, const LaneSet& lanes, Vec3 point,
               const LaneValues& scattered);
    void look_through_fog(Vec3 direction, double distance, const walk::SharedPath& path,
                          const LaneSet& lanes, LaneValues& value);
    double weight(double note, double ratio) const;
    double density_of_direct(Vec3 receiver);

    const LightPaths& light_paths_;
    SplatList& splats_;
    const EmittedRay* emitted_ = nullptr;
    double density_ = 0.0;  ///< of the lamp's ray, as weights take it
    LaneValues source_;     ///< what the lamp gives over the ray's density, by lane of the packet
};

}  // namespace dewbow::caustics
