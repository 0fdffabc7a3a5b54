// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/paper_fog.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "dewbow/base/error.h"
#include "dewbow/rainbow/paper/fog.h"

namespace dewbow {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Colour<LinearSrgb> kWhite{{1.0, 1.0, 1.0}};
/// As printed, fog grows as e^{hd}: a number that pictures can still hold.
constexpr double kMostPrinted = 20.0;

/// For vectors of unit length; exact where they are all but parallel.
Angle angle_between(Vec3 a, Vec3 b) {
    return std::atan2(length(cross(a, b)), dot(a, b)) * unit::rad;
}

void check_range(const char* what, double value, double low, double high) {
    if (value >= low && value <= high) return;
    throw InputError(
        fmt::format("paper rainbow: {} is {}; it must be {} to {}", what, value, low, high));
}

/// The least that a number may be which must be more than 0.
constexpr double kTiny = std::numeric_limits<double>::min();

void check_rings(const PaperRings& rings) {
    const double inner = rings.bow.inner.to(unit::deg), outer = rings.bow.outer.to(unit::deg);
    check_range("the outer radius of its rings in degrees", outer, 0.0, 180.0);
    check_range("the inner radius of its rings in degrees", inner, 0.0, outer);
    if (!(inner < outer)) throw InputError("paper rainbow: its rings are of no width");
    check_range("the jitter in rings", rings.bow.jitter.delta, 0.0, kPaperSamples);
    for (const double t : rings.transmittance.v) check_range("transmittance", t, kTiny, kInfinity);
}

}  // namespace

void check_chaos(const Chaos& chaos) {
    check_range("octaves of chaos", chaos.octaves, 1, kMostChaosOctaves);
    check_range("the base frequency of chaos", chaos.base_frequency, kTiny, 1e12);
    check_range("the lacunarity of chaos", chaos.lacunarity, 1.1, 10.0);
    check_range("the exponent of chaos", chaos.exponent, 1.0, 4.0);
    check_range("the stretch of chaos", chaos.stretch, kTiny, 1e12);
}

void check_paper_rainbow(const PaperRainbow& rainbow) {
    if (const auto* rings = std::get_if<PaperRings>(&rainbow.bow)) check_rings(*rings);
    const double constant = rainbow.constant.to(1.0 / unit::m), depth = rainbow.depth.to(unit::m);
    check_range("the fog's constant per metre", constant, kTiny, 1e12);
    check_range("the depth of its rain in metres", depth, 0.0, kInfinity);
    if (rainbow.equation == FogEquation::printed)
        check_range("its fog as printed at the far end of its rain, in e-folds,", constant * depth,
                    0.0, kMostPrinted);
    check_range("luminance", rainbow.luminance.value_or(0.0), 0.0, 1e12);
    if (rainbow.chaos) check_chaos(*rainbow.chaos);
}

PaperFog::PaperFog(const PaperRainbow& rainbow, Dir<World> antisolar)
    : rainbow_(rainbow), antisolar_(antisolar) {
    check_paper_rainbow(rainbow);
    if (const auto* method = std::get_if<PaperMethod>(&rainbow.bow))
        table_ = make_fog_table(*method);
}

double PaperFog::replaced(Length distance, double transmittance, double density) const {
    const InverseLength h = rainbow_.constant * density;
    if (rainbow_.equation == FogEquation::printed)
        return fog_replacement_as_printed(h, distance, transmittance);
    return density > 0.0 ? fog_replacement(h, distance, transmittance) : 0.0;
}

std::optional<PaperFog::Share> PaperFog::on_ray(Dir<World> direction, Length distance,
                                                std::array<double, 2> u) const {
    const Angle r = angle_between(direction.v, antisolar_.v);
    const auto* rings = std::get_if<PaperRings>(&rainbow_.bow);
    Share share{{}, kWhite};
    const Colour<LinearSrgb>* transmittance = nullptr;
    if (rings) {
        const auto fog = ring_fog(ring_index(rings->bow, r), rings->bow.jitter, u);
        if (!fog) return std::nullopt;
        share.colour = *fog;
        transmittance = &rings->transmittance;
    } else {
        const auto bucket = std::size_t(r / kPaperBucket);
        transmittance = &table_.transmittance[std::min(bucket, table_.transmittance.size() - 1)];
    }
    const double density = rainbow_.chaos ? chaos_density(direction.v, *rainbow_.chaos) : 1.0;
    const Length inside = std::min(distance, rainbow_.depth);
    for (std::size_t c = 0; c < 3; ++c)
        share.replaced[c] = replaced(inside, (*transmittance)[c], density);
    return share;
}

}  // namespace dewbow
