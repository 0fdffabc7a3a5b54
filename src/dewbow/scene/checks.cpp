// SPDX-License-Identifier: Apache-2.0
#include "dewbow/scene/checks.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "dewbow/base/error.h"

namespace dewbow::checks {

[[noreturn]] void fail(const std::string& who, const std::string& what) {
    throw InputError(who + ": " + what);
}

void check_range(const std::string& who, const char* what, double value, double low, double high) {
    if (value >= low && value <= high && std::isfinite(value)) return;
    if (high == kInfinity) {
        fail(who, fmt::format("{} is {}; it must be at least {} and finite", what, value, low));
    }
    fail(who, fmt::format("{} is {}; it must be between {} and {}", what, value, low, high));
}

void check_positive(const std::string& who, const char* what, double value) {
    if (value > 0.0 && std::isfinite(value)) return;
    fail(who, fmt::format("{} is {}; it must be greater than 0 and finite", what, value));
}

void check_index(const std::string& who, const char* what, int index, std::size_t size) {
    if (index >= 0 && std::size_t(index) < size) return;
    fail(who, fmt::format("{} has the index {}, but there are {} materials", what, index, size));
}

void check_spectrum(const std::string& who, const char* what, const SpectrumPtr& spectrum,
                    double high) {
    if (!spectrum) fail(who, fmt::format("{} is missing", what));
    constexpr std::size_t kCount = std::size_t(kLambdaMax_nm - kLambdaMin_nm) + 1;
    std::array<double, kCount> lambda_nm, values;
    for (std::size_t i = 0; i < kCount; ++i) lambda_nm[i] = kLambdaMin_nm + double(i);
    spectrum->eval_lanes(lambda_nm, values);
    for (std::size_t i = 0; i < kCount; ++i) {
        if (values[i] >= 0.0 && values[i] <= high && std::isfinite(values[i])) continue;
        const std::string range = high == kInfinity
                                      ? "at least 0 and finite"
                                      : fmt::format("between 0 and {}", std::floor(high));
        fail(who,
             fmt::format("{} is {} at {} nm; it must be {}", what, values[i], lambda_nm[i], range));
    }
    // A line between two samples must be finite too.
    if (!std::isfinite(spectrum->max_value())) fail(who, fmt::format("{} is not finite", what));
}

void check_share(const std::string& who, const char* what, const SpectrumPtr& spectrum) {
    check_spectrum(who, what, spectrum, 1.0 + kRounding);
}

void check_share(const std::string& who, const char* what, const ColourInput& input) {
    if (input.texture) check_texture(who, what, input.texture);
    if (!input.varies() && input.spectrum) check_share(who, what, input.spectrum);
    for (const double channel : input.factor.v) check_range(who, what, channel, 0.0, 1.0);
}

void check_share(const std::string& who, const char* what, const NumberInput& input) {
    check_range(who, what, input.value, 0.0, 1.0);
    if (!input.texture) return;
    check_texture(who, what, input.texture);
    check_range(who, "the channel of its texture", input.channel, 0, 3);
}

void check_texture(const std::string& who, const char* what, const TexturePtr& texture) {
    if (!texture || !texture->image) fail(who, fmt::format("the texture of {} is missing", what));
    const TextureImage& image = *texture->image;
    const std::size_t values = image.bits == 8 ? image.texels8.size() : image.texels16.size();
    if (image.width < 1 || image.height < 1 ||
        values != 4 * std::size_t(image.width) * std::size_t(image.height))
        fail(who, fmt::format("the texture of {} has {} values for {} x {} texels", what, values,
                              image.width, image.height));
    check_range(who, "the set of its texture coordinates", texture->texcoord_set, 0, 1);
    for (const auto& row : texture->transform)
        for (const double value : row)
            if (!std::isfinite(value))
                fail(who, fmt::format("the transform of the texture of {} is not finite", what));
}

void check_medium(const std::string& who, const MediumPtr& medium) {
    if (!medium) fail(who, "its medium is missing");
    if (!medium->index) fail(who, "its medium has no index of refraction");
    if (medium->absorption) check_spectrum(who, "absorption", medium->absorption);
    if (!medium->scattering) return;
    check_spectrum(who, "scattering", medium->scattering);
    if (!medium->phase) fail(who, "its medium scatters, but has no phase function");
}

void check_finite(const std::string& who, const char* what, Vec3 v) {
    if (!is_finite(v)) fail(who, fmt::format("{} is not finite", what));
}

void check_unit(const std::string& who, const char* what, Vec3 v) {
    check_finite(who, what, v);
    if (std::abs(length(v) - 1.0) > kRounding) {
        fail(who, fmt::format("{} has the length {}; it must be 1", what, length(v)));
    }
}

void check_affine(const std::string& who, const Affine& affine) {
    for (const auto& row : affine.m) {
        for (const double value : row) {
            if (!std::isfinite(value)) fail(who, "its transform is not finite");
        }
    }
}

}  // namespace dewbow::checks
