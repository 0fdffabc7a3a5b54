// SPDX-License-Identifier: Apache-2.0
#pragma once

// A second sun below the horizon: what a level surface, still water or a mirror on the ground,
// shows of light from infinitely far. It makes the reflected-light bow, which stands around the
// point opposite to that image and meets the ordinary bow on the horizon.

#include <optional>

#include "dewbow/base/random.h"
#include "dewbow/rainbow/scattering.h"
#include "dewbow/render/weather/level_mirrors.h"
#include "dewbow/scene/rain_inside.h"

namespace dewbow {

struct PreparedScene;

class MirroredSun {
public:
    /// @param to_sun  above the horizon.   @param height_m  of the mirror: y.
    MirroredSun(Dir<World> to_sun, double height_m) : to_sun_(to_sun), height_m_(height_m) {}

    /// Towards the image: downwards.
    Dir<World> direction() const { return image_of(to_sun_); }
    /// Where the mirror shows what lies in a direction.
    static Dir<World> image_of(Dir<World> d) { return {{d.v.x, -d.v.y, d.v.z}}; }
    /// The place of the mirror that a point sees in a direction.
    Point<World> place(Point<World> point, Dir<World> downwards) const {
        return along(point, downwards, (point.v.y - height_m_) / -downwards.v.y);
    }

    /// The part of `on` of a line that lies above the mirror.
    std::optional<LineInterval> above(Point<World> origin, Dir<World> direction,
                                      LineInterval on) const;
    /// How far light has come in a rain on its way from the sun to the mirror and from there to the
    /// points of `on`, which lies above the mirror: by pieces, as ConvexRegion::lengths_towards. A
    /// way down to the mirror that has no end in the rain counts as none.
    void lengths(const RainInside& rain, Point<World> origin, Dir<World> direction, LineInterval on,
                 std::vector<LengthPiece>& pieces) const;

    /// What the mirror leaves of light to `point`, or nothing: something else is there than a
    /// mirror at that height, or something stands before it, or between it and the sun.
    /// @param to_sun  towards a point of the sun's disc.
    /// `key` and `vertex` choose the part of a mix.
    std::optional<ReflectanceLanes> reflect(const PreparedScene& prepared, Point<World> point,
                                            Dir<World> to_sun, const SampleKey& key,
                                            std::uint32_t vertex, const LaneSet& lanes,
                                            PacketMedia& media) const;

    /// What the mirror leaves, taken apart along the plane in which drops scatter it to the eye:
    /// with ψ the angle between that plane and the one of incidence, R⊥' = R⊥ cos² ψ + R∥ sin² ψ,
    /// and the other way round. Drops then send R⊥' p⊥ + R∥' p∥ of light that had half its
    /// intensity in each.            [Bohren & Huffman 1983, §2.11; derived here]
    Reflectance<double> turned(Reflectance<double> mirror, Dir<World> towards_eye) const;

private:
    Dir<World> to_sun_;
    double height_m_;
};

}  // namespace dewbow
