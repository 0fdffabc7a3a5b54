// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>

#include "dewbow/base/error.h"
#include "dewbow/base/random.h"
#include "dewbow/render/spark_estimator.h"

namespace dewbow {
namespace {

RenderIdentity small_identity() {
    RenderIdentity identity;
    identity.scene_hash = 0x0123456789abcdef;
    identity.estimator = "test";
    identity.settings = "packet 4";
    identity.seed = 7;
    identity.samples_per_pixel = 10;  // 3 passes
    identity.film = {40, 30, {3, 5, 37, 28}, 2, -3};
    identity.light_paths = 3.0;  // two light units a pass, beside six tiles
    identity.fingerprint = "this one";
    return identity;
}

/// A function of pixel and index. One in about fifty is invalid.
PixelSample sample_at(int x, int y, std::int64_t index) {
    const SampleKey key(stream_key(7, std::uint32_t(x), std::uint32_t(y)), std::uint32_t(index));
    PixelSample sample;
    sample.wavelengths =
        sample_wavelengths(WavelengthSampling::visual, 4, key.one(0, Purpose::test));
    for (std::uint32_t k = 0; k < 4; ++k)
        sample.radiance[k] = std::exp(20.0 * key.one(k, Purpose::lens) - 10.0);
    if (key.one(9, Purpose::test) < 0.02) sample.radiance[1] = std::nan("");
    sample.hit = index % 3 != 0;
    sample.depth = sample.hit ? 1.0 + x : 0.0;
    sample.normal = {key.one(5, Purpose::test) - 0.5, 0.3, -0.7};
    sample.albedo = {{0.2, 0.3, 0.5}};
    return sample;
}

void trace_light(RenderState& state, std::size_t pass, std::size_t number) {
    const LightUnit unit = state.plan.light_unit(pass, number);
    SplatList splats(state.film.layout());
    SparkEstimator(40, 30, state.identity.light_paths).trace_light(unit, splats);
    splats.add_invalid(std::int64_t(number));
    state.film.add_splats(splats, unit.paths());
    state.plan.set_finished(pass, number);
}

void render(RenderState& state, std::size_t pass, std::size_t tile) {
    if (state.plan.is_light(tile)) return trace_light(state, pass, tile);
    const Unit unit = state.plan.unit(pass, tile);
    for (int y = unit.tile.y0; y < unit.tile.y1; ++y)
        for (int x = unit.tile.x0; x < unit.tile.x1; ++x)
            for (std::int64_t i = unit.first_sample; i < unit.end_sample; ++i)
                state.film.add(x, y, sample_at(x, y, i), i);
    state.plan.set_finished(pass, tile);
}

using UnitNumber = std::pair<std::size_t, std::size_t>;

std::vector<UnitNumber> all_units(const UnitPlan& plan) {
    std::vector<UnitNumber> units;
    for (std::size_t pass = 0; pass < plan.passes(); ++pass)
        for (std::size_t unit = 0; unit < plan.units_per_pass(); ++unit)
            units.emplace_back(pass, unit);
    return units;
}

RenderState whole_render() {
    RenderState state(small_identity());
    for (const auto& [pass, tile] : all_units(state.plan)) render(state, pass, tile);
    return state;
}

/// Units first, first + step, … of a render, as a slice has them.
RenderState every(std::size_t step, std::size_t first) {
    RenderState state(small_identity());
    const std::vector<UnitNumber> units = all_units(state.plan);
    for (std::size_t i = first; i < units.size(); i += step)
        render(state, units[i].first, units[i].second);
    return state;
}

std::string message_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(State, SlicesAddUpToTheWholeInAnyOrder) {
    const RenderState whole = whole_render();
    ASSERT_GT(whole.film.invalid_samples(), 100);
    std::mt19937 engine(5);
    for (int repeat = 0; repeat < 5; ++repeat) {
        const std::size_t slices = 1 + engine() % 7;
        std::vector<RenderState> parts;
        for (std::size_t k = 0; k < slices; ++k) parts.push_back(every(slices, k));
        std::shuffle(parts.begin(), parts.end(), engine);
        RenderState sum(small_identity());
        for (const RenderState& part : parts)
            EXPECT_EQ(add_state(sum, "the sum", part, "a part"), Added::added);
        EXPECT_EQ(sum.plan, whole.plan);
        EXPECT_EQ(sum.plan.finished_units(), sum.plan.units());
        EXPECT_EQ(sum.film.fingerprint(), whole.film.fingerprint());
        EXPECT_EQ(sum.film.first_invalid(), whole.film.first_invalid());
        EXPECT_EQ(sum.film.light_paths(), 3u * 40 * 30 * 10);
        EXPECT_EQ(sum.plan.finished_samples(), sum.film.crop().area() * 10);
    }
}

TEST(State, WhatIsThereAlreadyIsNotAddedAgain) {
    RenderState sum = every(3, 0);
    const std::uint64_t hash = sum.film.fingerprint();
    EXPECT_EQ(add_state(sum, "a", every(3, 0), "b"), Added::already_there);
    EXPECT_EQ(sum.film.fingerprint(), hash);
    add_state(sum, "a", every(3, 1), "b");
    EXPECT_EQ(add_state(sum, "a", every(3, 0), "b"), Added::already_there);
    EXPECT_EQ(add_state(sum, "a", RenderState(small_identity()), "nothing"), Added::added);
}

TEST(State, PartlyOverlappingUnitsAreRefused) {
    RenderState sum = every(2, 0);
    const std::uint64_t hash = sum.film.fingerprint();
    const std::string message =
        message_of([&] { add_state(sum, "a.dewbow", every(3, 0), "b.dewbow"); });
    // Of 24 units, 12 are even, 8 are divisible by 3 and 4 by 6.
    EXPECT_EQ(message.substr(0, message.find('\n')),
              "b.dewbow: it holds 8 of 24 units, and 4 of these are in a.dewbow already");
    EXPECT_EQ(sum.film.fingerprint(), hash);
    EXPECT_EQ(sum.plan, every(2, 0).plan);
}

TEST(State, EveryDifferenceIsNamedWithBothValues) {
    const RenderIdentity a = small_identity();
    EXPECT_EQ(mismatch(a, "a", a, "b"), std::nullopt);
    const auto told = [&](auto change, const std::vector<std::string>& parts) {
        RenderIdentity b = a;
        change(b);
        const auto text = mismatch(a, "ONE", b, "TWO");
        ASSERT_TRUE(text.has_value());
        for (const std::string& part : parts)
            EXPECT_NE(text->find(part), std::string::npos) << *text;
    };
    told([](auto& b) { b.scene_hash = 1; }, {"scene", "0123456789abcdef in ONE", "1 in TWO"});
    told([](auto& b) { b.estimator = "other"; }, {"estimator", "test in ONE", "other in TWO"});
    told([](auto& b) { b.settings = "packet 8"; }, {"packet 4 in ONE", "packet 8 in TWO"});
    told([](auto& b) { b.seed = 8; }, {"seed", "7 in ONE", "8 in TWO"});
    told([](auto& b) { b.samples_per_pixel = 12; }, {"samples", "10 in ONE", "12 in TWO"});
    told([](auto& b) { b.film.width = 41; }, {"40x30", "41x30"});
    told([](auto& b) { b.film.height = 31; }, {"40x30", "40x31"});
    told([](auto& b) { b.film.crop.x0 = 4; }, {"3,5,34x23", "4,5,33x23"});
    told([](auto& b) { b.film.crop.y1 = 29; }, {"3,5,34x23", "3,5,34x24"});
    told([](auto& b) { b.film.spectral_bins = 3; }, {"bins", "2 in ONE", "3 in TWO"});
    told([](auto& b) { b.film.reference_exponent = 2; }, {"exponent", "-3 in ONE", "2 in TWO"});
    told([](auto& b) { b.tile_side = 8; }, {"tile", "16 in ONE", "8 in TWO"});
    told([](auto& b) { b.light_paths = 1.5; }, {"light paths", "3 in ONE", "1.5 in TWO"});
    told([](auto& b) { b.samples_per_pass = 8; }, {"pass", "4 in ONE", "8 in TWO"});
    told([](auto& b) { b.fingerprint = "that"; }, {"this one in ONE", "that in TWO"});
}

TEST(State, OfAnotherRenderIsRefused) {
    RenderState sum = every(2, 0);
    RenderIdentity other = small_identity();
    other.seed = 8;
    EXPECT_EQ(message_of([&] { add_state(sum, "a", RenderState(other), "b"); }),
              "b: a state of another render: the seed is 7 in a and 8 in b");
}

void expect_equal(const RenderState& a, const RenderState& b) {
    EXPECT_EQ(mismatch(a.identity, "a", b.identity, "b"), std::nullopt);
    EXPECT_EQ(a.plan, b.plan);
    EXPECT_EQ(a.film.fingerprint(), b.film.fingerprint());
    EXPECT_EQ(a.film.light_paths(), b.film.light_paths());
    EXPECT_EQ(a.film.invalid_samples(), b.film.invalid_samples());
    EXPECT_EQ(a.seconds, b.seconds);
}

TEST(State, ComesBackFromItsBytes) {
    for (RenderState state : {RenderState(small_identity()), every(5, 2), whole_render()}) {
        state.seconds = 12.5;
        expect_equal(state_from_bytes(state_bytes(state), "memory"), state);
    }
}

TEST(State, AWholePassCanBeOneUnit) {
    RenderIdentity identity = small_identity();
    identity.tile_side = 64;
    RenderState state(identity);
    EXPECT_EQ(state.plan.tiles(), 1u);
    render(state, 1, 0);
    expect_equal(state_from_bytes(state_bytes(state), "memory"), state);
}

/// It takes nothing but the word that says how many blocks there are: none.
TEST(State, WithoutLightPathsThereAreNoSplatsInIt) {
    RenderIdentity without = small_identity();
    without.light_paths = 0.0;
    RenderState state(without);
    render(state, 0, 0);
    EXPECT_EQ(state.plan.units(), 18u);
    EXPECT_EQ(state.film.light_paths(), 0u);
    expect_equal(state_from_bytes(state_bytes(state), "memory"), state);
    const RenderState with = every(5, 2);  // a pixel takes 64 bytes, and 8 for each of two bins
    EXPECT_GT(with.film.splats().touched_blocks(), 0u);
    EXPECT_GT(state_bytes(with).size(), state_bytes(state).size() + 34 * 23 * (64 + 2 * 8));
}

// ---- damage ------------------------------------------------------------------------------------

TEST(State, EveryFlippedBitIsFound) {
    const std::string good = state_bytes(every(5, 2));
    const std::size_t head = 400;  // all of the description, and a part of the pixels
    ASSERT_GT(good.size(), 2 * head);
    std::mt19937 engine(6);
    std::vector<std::size_t> bits(8 * head);
    for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = i;
    for (std::size_t i = 8 * (good.size() - head); i < 8 * good.size(); ++i) bits.push_back(i);
    for (int i = 0; i < 400; ++i) bits.push_back(engine() % (8 * good.size()));
    for (const std::size_t bit : bits) {
        std::string bytes = good;
        bytes[bit / 8] = char(bytes[bit / 8] ^ (1 << (bit % 8)));
        const std::string message = message_of([&] { state_from_bytes(bytes, "x.dewbow"); });
        ASSERT_TRUE(message.starts_with("x.dewbow: ")) << bit << " " << message;
    }
}

TEST(State, EveryTruncationAndEveryTailIsFound) {
    const std::string good = state_bytes(every(5, 2));
    std::vector<std::size_t> sizes;
    for (std::size_t size = 0; size < 400; ++size) sizes.push_back(size);
    for (std::size_t size = 400; size < good.size(); size += 997) sizes.push_back(size);
    for (std::size_t size = good.size() - 200; size < good.size(); ++size) sizes.push_back(size);
    for (const std::size_t size : sizes) {
        const std::string message =
            message_of([&] { state_from_bytes(std::string_view(good).substr(0, size), "x"); });
        ASSERT_TRUE(message.starts_with("x: ")) << size << " " << message;
    }
    EXPECT_EQ(message_of([&] { state_from_bytes(good + '\0', "x"); }),
              "x: damaged: something follows after its end");
    EXPECT_EQ(message_of([&] { state_from_bytes("", "x"); }), "x: not the state of a render");
}

TEST(State, ExchangedPartsAreFound) {
    const std::string good = state_bytes(every(5, 2));
    std::mt19937 engine(8);
    for (int repeat = 0; repeat < 200; ++repeat) {
        // Two words that differ change places: a plain sum of words would not notice.
        std::string bytes = good;
        const std::size_t a = 8 * (engine() % (good.size() / 8)),
                          b = 8 * (engine() % (good.size() / 8));
        std::swap_ranges(bytes.begin() + long(a), bytes.begin() + long(a) + 8,
                         bytes.begin() + long(b));
        if (bytes == good) continue;
        EXPECT_NE(message_of([&] { state_from_bytes(bytes, "x"); }), "");
    }
}

TEST(State, IsReadFromAFileInPieces) {
    const std::string path = testing::TempDir() + "/state_test.dewbow";
    const RenderState state = every(2, 1);
    std::ofstream(path, std::ios::binary) << state_bytes(state);
    expect_equal(load_state(path), state);
    // Ten gigabytes of nothing behind it, which are not read.
    std::filesystem::resize_file(path, std::uintmax_t{10} << 30);
    EXPECT_EQ(message_of([&] { load_state(path); }),
              path + ": damaged: something follows after its end");
    std::filesystem::remove(path);
    EXPECT_EQ(message_of([&] { load_state(path); }),
              path + ": cannot read: No such file or directory");
}

}  // namespace
}  // namespace dewbow
