// SPDX-License-Identifier: Apache-2.0
#pragma once

// A density over the unit cube that light paths start in, as a binary tree of boxes. Its first
// coordinate chooses the light, the other four one of that light's rays.

#include <array>
#include <cstdint>
#include <vector>

namespace dewbow::caustics {

inline constexpr int kAimDimensions = 5;
/// Each coordinate in [0, 1).
using AimPoint = std::array<double, kAimDimensions>;

/// What of the density is uniform whatever was learnt: no ray is sampled less than a tenth as often
/// as without learning, so that its estimate is at most ten times as large.
inline constexpr double kUniformShare = 0.1;

/// Constant in each leaf. Immutable. 32 bytes a node.
class LearntDensity {
public:
    /// A box of the tree, in the order in which a walk meets them that goes to the first child
    /// first.
    struct Box {
        int axis = -1;  ///< along which it is cut; −1: a leaf
        double cut = 0.0;
        std::uint32_t second = 0;  ///< index of the child above the cut; that below is the next box
        std::uint64_t mass = 0;    ///< of a leaf, in any unit
    };
    struct Sample {
        AimPoint at;
        double density;  ///< there; ≥ kUniformShare
    };

    /// Uniform.
    LearntDensity() : LearntDensity(std::vector<Box>(1)) {}
    /// In each leaf kUniformShare + (1 − kUniformShare) · its mass / (all masses · its volume);
    /// 1 everywhere if all masses are 0. The sum of the masses is below 2⁶⁴.
    explicit LearntDensity(const std::vector<Box>& boxes);

    /// A map of the cube onto itself, one to one, that has this density where `u` is uniform. Each
    /// coordinate stays in order within a leaf: stratified numbers give stratified points.
    /// [Clarberg et al., "Wavelet Importance Sampling", 2005, section 4.2]
    Sample sample(const AimPoint& u) const;
    /// Per unit of volume.   Cost: one comparison a level.
    double density(const AimPoint& at) const;

    std::size_t leaves() const { return (nodes_.size() + 1) / 2; }

private:
    struct Node {
        double cut;
        double value;              ///< share of the first child; of a leaf its density
        std::uint32_t second = 0;  ///< 0: a leaf
        std::int32_t axis = 0;
    };
    struct Part;
    Part add(const std::vector<Box>& boxes, std::size_t at, const Part& whole,
             std::uint64_t all_masses);

    std::vector<Node> nodes_;
};

}  // namespace dewbow::caustics
