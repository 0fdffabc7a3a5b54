// SPDX-License-Identifier: Apache-2.0
#pragma once

// One curve of an animation.  [glTF 2.0, appendix C]

#include <string>
#include <vector>

#include "dewbow/import/gltf/accessor.h"

namespace dewbow::gltf {

class AnimationSampler {
public:
    /// @param sampler  a member of an animation's `samplers`.
    /// @param path  what the curve is of: "translation", "rotation", "scale" or "weights".
    /// Throws InputError.
    AnimationSampler(Document& document, const Json& sampler, const std::string& path);

    /// The value at `time_s` seconds, the first or the last one outside the curve's times. Throws
    /// InputError where it is not finite.
    std::vector<double> at(double time_s) const;

private:
    using Value = std::vector<double>;
    enum class Interpolation { linear, step, cubic_spline };
    enum Part { kInTangent = 0, kValue = 1, kOutTangent = 2 };

    void check_times() const;
    double time(std::uint64_t key) const { return times_[key][0]; }
    Value key(std::uint64_t key, Part part = kValue) const;
    Value between(std::uint64_t key, double time_s) const;

    Json json_;
    bool rotates_;
    Interpolation interpolation_ = Interpolation::linear;
    Accessor times_, values_;
    std::uint64_t elements_ = 1;  ///< of the output, a value
};

}  // namespace dewbow::gltf
