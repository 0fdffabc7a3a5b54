// SPDX-License-Identifier: Apache-2.0
#pragma once

// A choice among many lights, by what each may give to the point that asks: a binary tree whose
// nodes bound position, direction and intensity of all below. The choice goes down from the root
// and turns at each node by the bounds of its two children alone, and so takes O(log n).
//
// [Conty Estevez & Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting", 2018]
// Two things differ. Nodes are seen as balls, whose cross-section is also their size when the tree
// is built, so that lights in a row or in a plane have a size. And nodes carry intensity in place
// of power, because that and distance are what arrives: importance is a bound on irradiance, within
// what the cones leave open, and compares with that of lights which are not in the tree.

#include <cstdint>
#include <optional>
#include <vector>

#include "dewbow/render/light_bounds.h"
#include "dewbow/render/receiver.h"

namespace dewbow {

/// Immutable. 64 bytes a node, two nodes a light, and 8 bytes a light for its way through the tree:
/// 136 bytes a light. Built in O(n log n).
class LightTree {
public:
    /// `lights` in any order; those of intensity 0 are never chosen. Throws InputError
    /// if there are more than 2²⁴.
    explicit LightTree(const std::vector<LightBounds>& lights);

    bool empty() const { return nodes_.empty(); }
    /// About the irradiance at `receiver` by all lights, were nothing in between; 0 only if there
    /// is none for certain.
    double irradiance(const Receiver& receiver) const;

    struct Choice {
        int light;           ///< index into `lights`
        double probability;  ///< > 0
    };
    /// Nothing if no light can reach the receiver.   @param u  in [0, 1).
    std::optional<Choice> sample(const Receiver& receiver, double u) const;
    /// With which sample() chooses `light` for `receiver`: the same to the last bit.
    double probability(const Receiver& receiver, int light) const;

private:
    /// Single precision, rounded so that it bounds still: one cache line.
    struct alignas(64) Node {
        float centre[3], radius;  ///< a ball around the lights
        float axis[3], cos_normals, sin_normals;
        float cos_emission;
        float intensity;           ///< as a share of the root's
        std::uint32_t second = 0;  ///< of the children; the first follows its parent. 0: a leaf
        std::uint32_t light = 0;   ///< of a leaf
        std::uint32_t two_sided = 0;
    };
    struct Item;
    class Builder;

    double importance(const Node& node, const Receiver& receiver) const;
    double first_share(std::uint32_t parent, const Receiver& receiver) const;

    std::vector<Node> nodes_;
    /// One a light: bit k tells which child to take at depth k; kNowhere if it is not in the tree.
    std::vector<std::uint64_t> ways_;
    double intensity_ = 0.0;  ///< of the root
};

}  // namespace dewbow
