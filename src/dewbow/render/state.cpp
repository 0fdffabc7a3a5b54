// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/state.h"

#include <fmt/format.h>

#include "dewbow/base/error.h"

namespace dewbow {

namespace {

std::string text_of(const FilmLayout& film) {
    const PixelRect& crop = film.crop;
    std::string text = fmt::format("{}x{} pixels", film.width, film.height);
    if (crop != PixelRect{0, 0, film.width, film.height})
        text +=
            fmt::format(" cropped to {},{},{}x{}", crop.x0, crop.y0, crop.width(), crop.height());
    return text;
}

/// "19 of 128 units"
std::string units_text(std::size_t units, const UnitPlan& of) {
    return fmt::format("{} of {} units", units, of.units());
}

}  // namespace

std::optional<std::string> mismatch(const RenderIdentity& a, const std::string& a_name,
                                    const RenderIdentity& b, const std::string& b_name) {
    struct Fact {
        const char* name;
        std::string in_a, in_b;
    };
    const auto number = [](auto value) { return std::to_string(value); };
    const auto hash = [](std::uint64_t value) { return fmt::format("{:016x}", value); };
    const Fact facts[] = {
        {"picture", text_of(a.film), text_of(b.film)},
        {"number of spectral bins", number(a.film.spectral_bins), number(b.film.spectral_bins)},
        {"estimator", a.estimator, b.estimator},
        {"seed", number(a.seed), number(b.seed)},
        {"number of samples a pixel", number(a.samples_per_pixel), number(b.samples_per_pixel)},
        {"way of sampling", a.settings, b.settings},
        {"number of light paths a sample", fmt::format("{}", a.light_paths),
         fmt::format("{}", b.light_paths)},
        {"hash of the scene", hash(a.scene_hash), hash(b.scene_hash)},
        {"exponent of the film's quanta", number(a.film.reference_exponent),
         number(b.film.reference_exponent)},
        {"tile's side", number(a.tile_side), number(b.tile_side)},
        {"number of samples in a pass", number(a.samples_per_pass), number(b.samples_per_pass)},
        {"fingerprint of program and machine", a.fingerprint, b.fingerprint},
    };
    for (const Fact& fact : facts)
        if (fact.in_a != fact.in_b)
            return fmt::format("the {} is {} in {} and {} in {}", fact.name, fact.in_a, a_name,
                               fact.in_b, b_name);
    return std::nullopt;
}

UnitPlan plan_of(const RenderIdentity& identity) {
    const double pixels = static_cast<double>(identity.film.width) * identity.film.height;
    return UnitPlan(identity.film.crop, identity.samples_per_pixel, identity.tile_side,
                    identity.light_paths * pixels);
}

RenderState::RenderState(RenderIdentity of) : RenderState(of, FilmSums(of.film)) {}

RenderState::RenderState(RenderIdentity of, FilmSums empty)
    : identity(std::move(of)), plan(plan_of(identity)), film(std::move(empty)) {}

Added add_state(RenderState& into, const std::string& into_name, const RenderState& from,
                const std::string& from_name) {
    if (const auto difference = mismatch(into.identity, into_name, from.identity, from_name))
        throw InputError(SourcePlace{from_name, 0, 0, {}},
                         "a state of another render: " + *difference);
    const std::size_t common = into.plan.common_units(from.plan);
    if (common > 0 && common == from.plan.finished_units()) return Added::already_there;
    if (common > 0)
        throw InputError(
            SourcePlace{from_name, 0, 0, {}},
            fmt::format("it holds {}, and {} of these are in {} already",
                        units_text(from.plan.finished_units(), from.plan), common, into_name),
            {}, "units cannot be taken out of a sum again: leave one of the two away");
    into.film.add(from.film);
    into.plan.add(from.plan);
    into.seconds += from.seconds;
    return Added::added;
}

}  // namespace dewbow
