// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/animation_sampler.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dewbow::gltf {
namespace {

constexpr AccessorUse kTimeUse{"times", 1, 1};
constexpr AccessorUse kWeightUse{"weights", 1, 1, true};

AccessorUse use_of(const std::string& path) {
    if (path == "rotation") return kRotationUse;
    return path == "weights" ? kWeightUse : kVectorUse;
}

using Value = std::vector<double>;

Value mixed(const Value& a, double weight_a, const Value& b, double weight_b) {
    Value result(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) result[i] = weight_a * a[i] + weight_b * b[i];
    return result;
}

double dot(const Value& a, const Value& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

/// Along the shorter arc from `a` to `b`, unit quaternions.
Value slerp(const Value& a, const Value& b, double s) {
    /// Below this angle sines are their arguments to 1e-13.
    constexpr double kSmallAngle = 1e-6;
    const double cosine = std::clamp(dot(a, b), -1.0, 1.0);
    const double sign = cosine < 0.0 ? -1.0 : 1.0, angle = std::acos(std::abs(cosine));
    if (angle < kSmallAngle) return mixed(a, 1.0 - s, b, sign * s);
    return mixed(a, std::sin((1.0 - s) * angle) / std::sin(angle), b,
                 sign * std::sin(s * angle) / std::sin(angle));
}

}  // namespace

AnimationSampler::AnimationSampler(Document& document, const Json& sampler, const std::string& path)
    : json_(sampler),
      rotates_(path == "rotation"),
      times_(document, sampler.require("input"), kTimeUse),
      values_(document, sampler.require("output"), use_of(path)) {
    const std::string name = sampler.text("interpolation", "LINEAR");
    if (name == "STEP")
        interpolation_ = Interpolation::step;
    else if (name == "CUBICSPLINE")
        interpolation_ = Interpolation::cubic_spline;
    else if (name != "LINEAR")
        sampler.require("interpolation")
            .fail(fmt::format("\"{}\" is no way of interpolating", name),
                  "expected LINEAR, STEP or CUBICSPLINE");
    check_times();
    const std::uint64_t parts = interpolation_ == Interpolation::cubic_spline ? 3 : 1;
    const std::uint64_t one_each = times_.count() * parts;
    if (path == "weights") elements_ = values_.count() / one_each;
    if (elements_ == 0 || values_.count() != one_each * elements_) {
        sampler.require("output").fail(fmt::format("there are {} values for {} times, {} each",
                                                   values_.count(), times_.count(), parts));
    }
}

void AnimationSampler::check_times() const {
    const Json input = json_.require("input");
    if (times_.count() == 0) input.fail("there are no times");
    for (std::uint64_t i = 0; i < times_.count(); ++i) {
        const double before = i > 0 ? time(i - 1) : -1.0;
        if (!(time(i) >= 0.0) || !std::isfinite(time(i)) || time(i) <= before)
            input.fail(fmt::format("time {} is {} s; times grow from 0 on", i, time(i)));
    }
}

Value AnimationSampler::key(std::uint64_t key, Part part) const {
    const bool spline = interpolation_ == Interpolation::cubic_spline;
    const std::uint64_t first = (spline ? 3 * key + part : key) * elements_;
    Value value;
    for (std::uint64_t i = 0; i < elements_; ++i) {
        const auto element = values_[first + i];
        value.insert(value.end(), element.begin(), element.begin() + values_.components());
    }
    return value;
}

Value AnimationSampler::between(std::uint64_t k, double time_s) const {
    const double span = time(k + 1) - time(k), s = (time_s - time(k)) / span;
    if (interpolation_ == Interpolation::step) return key(k);
    if (interpolation_ == Interpolation::linear)
        return rotates_ ? slerp(key(k), key(k + 1), s) : mixed(key(k), 1.0 - s, key(k + 1), s);
    const double s2 = s * s, s3 = s2 * s;
    const Value values = mixed(key(k), 2.0 * s3 - 3.0 * s2 + 1.0, key(k + 1), 3.0 * s2 - 2.0 * s3);
    const Value tangents = mixed(key(k, kOutTangent), span * (s3 - 2.0 * s2 + s),
                                 key(k + 1, kInTangent), span * (s3 - s2));
    return mixed(values, 1.0, tangents, 1.0);
}

Value AnimationSampler::at(double time_s) const {
    const std::uint64_t last = times_.count() - 1;
    std::uint64_t low = 0, high = last;  // the last key at or before the time
    while (low < high) {
        const std::uint64_t middle = low + (high - low + 1) / 2;
        if (time(middle) <= time_s)
            low = middle;
        else
            high = middle - 1;
    }
    const bool outside = time_s <= time(0) || low == last;
    const Value value = outside ? key(low) : between(low, time_s);
    for (const double number : value)
        if (!kCoordinateRange.contains(number))
            json_.require("output").fail(fmt::format("its value at {} s is {}", time_s, number));
    return value;
}

}  // namespace dewbow::gltf
