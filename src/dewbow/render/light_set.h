// SPDX-License-Identifier: Apache-2.0
#pragma once

// All lights of a scene, chosen and sampled for direct light. Glowing shapes, points, spots and
// profiles are chosen by a tree; beside it stand the beams that a point lies in, and what is
// infinitely far.

#include <optional>

#include "dewbow/math/distribution.h"
#include "dewbow/render/glowing_shape.h"
#include "dewbow/render/infinite_light.h"
#include "dewbow/render/light_tree.h"
#include "dewbow/render/punctual_light.h"

namespace dewbow {

/// A direction towards a light.
struct LightSample {
    enum class Source { shape, punctual, beam, infinite };
    Source source = Source::shape;
    int index = 0;  ///< among those of its source, in the scene's order
    Vec3 direction;
    double distance = 0.0;  ///< infinite for what is infinitely far
    /// Density per steradian, choice of the light included. A light without extent has the density
    /// of its choice alone, and `factor` holds what distance and cone make of its intensity.
    double pdf = 0.0;
    /// Of a surface it holds how much of that is there.
    double factor = 1.0;
    bool without_extent = false;
    Colour<LinearSrgb> colour{};  ///< of a surface that glows in colours
    int primitive = -1;           ///< of a surface, as of a hit there
};

class LightSet {
public:
    explicit LightSet(const Scene& scene);

    /// Which lights are asked: distant ones, which are found in rain by its law, may be left out.
    enum class Asked { all, all_but_distant };
    /// Whether there are any.
    bool any(Asked asked) const { return !tree_->empty() || !beams_.empty() || far(asked).choose; }
    bool any_infinite(Asked asked) const { return far(asked).choose.has_value(); }
    /// A direction from `receiver` to some light: nothing if the one chosen is not visible from
    /// there.
    std::optional<LightSample> sample(const Receiver& receiver, double u_choice,
                                      std::array<double, 2> u, Asked asked = Asked::all) const;
    /// Radiance (for lights without extent: irradiance on a surface that faces it, per pdf) that
    /// arrives by `sample`.
    void radiance(const LightSample& sample, const LaneSet& lanes, RgbLightLanes& rgb,
                  LaneValues& out) const;

    /// Whether the surface of `hit` gives off light to where the ray along `direction` comes from.
    bool emits(const Hit& hit, Vec3 direction) const {
        const int glowing = glowing_of_shape_[std::size_t(hit.shape)];
        return glowing >= 0 && shapes_[std::size_t(glowing)].shines(direction, hit.normal);
    }
    /// Whether its radiance differs from place to place.
    bool emission_varies(const Hit& hit) const { return glow_at(hit).varies(); }
    /// Radiance of the emitting surface at `hit`, which is `at` if it varies.
    void emission(const Hit& hit, const SurfaceCoordinates& at, const LaneSet& lanes,
                  RgbLightLanes& rgb, LaneValues& out) const;
    /// Density with which sample() would have taken this direction to the emitting surface at
    /// `hit`, which is hit.t from the receiver.
    double pdf_of_hit(const Receiver& receiver, Vec3 direction, const Hit& hit) const;

    // The lights themselves, each source in the scene's order.
    const std::vector<GlowingShape>& shapes() const { return shapes_; }
    const std::vector<PunctualLight>& punctual() const { return punctual_; }
    const std::vector<Beam>& beams() const { return beams_; }
    const std::vector<InfiniteLight>& infinite() const { return infinite_; }
    /// Index into shapes() of a shape of the scene, or −1.
    int glowing_of(int shape) const { return glowing_of_shape_[std::size_t(shape)]; }

    /// LightSample::pdf of a light without extent, wherever it shines on the receiver.
    double pdf_of_choice(const Receiver& receiver, LightSample::Source source, int index) const;

    /// The lights that are infinitely far.
    int infinite_count() const { return int(infinite_.size()); }
    /// Radiance of the `i`-th of them along `direction`; false if it is not there.
    bool infinite_radiance(int i, Vec3 direction, const LaneSet& lanes, RgbLightLanes& rgb,
                           LaneValues& out) const;
    double pdf_of_infinite(const Receiver& receiver, int i, Vec3 direction,
                           Asked asked = Asked::all) const;

    /// What is known of each light of the tree, of a glowing shape as a whole.
    std::vector<LightBounds> near_bounds() const;
    /// Brightness of the irradiance by all lights that are infinitely far, about.
    double far_irradiance() const { return far_.irradiance; }

private:
    /// Of the choices at one receiver, what falls on each group of lights; they sum to 1, or are
    /// all 0.
    struct Shares {
        double near = 0.0;  ///< the tree
        double beams = 0.0;
        double far = 0.0;
    };
    /// Lights that are infinitely far, of those that are asked.
    struct Far {
        double irradiance = 0.0;
        std::optional<Distribution1D> choose;  ///< nothing: there are none
    };
    const Far& far(Asked asked) const { return asked == Asked::all ? far_ : far_but_distant_; }
    /// What the tree chooses.
    struct Leaf {
        LightSample::Source source;
        int index, part;
    };
    void add_shape(const Scene& scene, int shape);
    const Glow& glow_at(const Hit& hit) const;
    void build_tree();
    Far far_of(const std::vector<bool>& asked) const;
    Shares shares(const Receiver& receiver, Asked asked = Asked::all) const;
    double beam_irradiance(const Receiver& receiver) const;
    std::optional<LightSample> sample_near(const Receiver& receiver, double u_choice,
                                           std::array<double, 2> u) const;
    std::optional<LightSample> sample_beam(const Receiver& receiver, double u_choice) const;
    std::optional<LightSample> sample_far(double u_choice, std::array<double, 2> u,
                                          Asked asked) const;

    std::vector<GlowingShape> shapes_;
    std::vector<int> glowing_of_shape_;  ///< one a shape of the scene: index into shapes_, or −1
    std::vector<int> first_leaf_;        ///< of each glowing shape
    std::vector<PunctualLight> punctual_;
    std::vector<Beam> beams_;
    std::vector<InfiniteLight> infinite_;
    std::vector<Leaf> leaves_;
    std::optional<LightTree> tree_;
    Far far_, far_but_distant_;
};

}  // namespace dewbow
