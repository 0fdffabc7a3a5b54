// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/splat_sums.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "dewbow/base/error.h"
#include "dewbow/base/random.h"
#include "dewbow/render/film.h"

namespace dewbow {
namespace {

constexpr FilmLayout kLayout{60, 40, {3, 2, 53, 40}, 3, 2};

WavelengthPacket four_wavelengths(double u) {
    return sample_wavelengths(WavelengthSampling::visual, 4, u);
}

SplatLight light_of(const WavelengthPacket& packet, double value) {
    LaneValues values;
    for (int k = 0; k < packet.count; ++k) values[k] = value * (1 + k);
    return {packet, LaneSet::all(packet), values};
}

/// Sparks all over the picture and around it, over many orders of magnitude.
SplatList random_splats(std::mt19937& engine, int count) {
    SplatList list(kLayout);
    std::uniform_real_distribution<double> one(0.0, 1.0);
    for (int i = 0; i < count; ++i) {
        const WavelengthPacket packet = four_wavelengths(one(engine));
        list.add(int(one(engine) * 60), int(one(engine) * 40), one(engine),
                 light_of(packet, std::exp(20.0 * one(engine) - 6.0)));
    }
    return list;
}

std::uint64_t hash_of(const SplatSums& sums) {
    std::uint64_t hash = 0;
    sums.for_each_word([&](std::uint64_t word) { hash = hash_combine(hash, word); });
    return hash;
}

void add(SplatSums& sums, const SplatList& list) { sums.add(list.splats(), list.bins()); }

SplatSums prepared() {
    SplatSums sums(kLayout);
    sums.prepare();
    return sums;
}

// ---- lists -------------------------------------------------------------------------------------

TEST(SplatList, ASplatIsTheMeanOverAllLanesOfThePacket) {
    // Two of four lanes are carried: the others count as nothing, not as absent.
    const WavelengthPacket packet = four_wavelengths(0.3);
    LaneSet lanes = LaneSet::one(packet, 1);
    lanes.count = 2, lanes.id[1] = 3;
    LaneValues values;
    values[0] = 5.0, values[1] = 7.0;
    const SplatLight light(packet, lanes, values);
    const std::array<double, 4> by_lane{0.0, 5.0, 0.0, 7.0};
    EXPECT_EQ(light.xyz(), film_xyz(packet, by_lane));

    SplatList list(kLayout);
    list.add(3, 2, 0.25, light);   // the first pixel of the crop
    list.add(52, 39, 1.0, light);  // and the last
    ASSERT_EQ(list.splats().size(), 2u);
    EXPECT_EQ(list.splats()[0].pixel, 0u);
    EXPECT_EQ(list.splats()[1].pixel, 50u * 38 - 1);
    EXPECT_EQ(list.splats()[0].xyz[1], float(0.25 * light.xyz()[1]));
    EXPECT_EQ(list.bins().size(), 4u);
}

TEST(SplatList, DropsWhatLiesOutsideTheCrop) {
    const WavelengthPacket packet = four_wavelengths(0.3);
    const SplatLight light = light_of(packet, 1.0);
    SplatList list(kLayout);
    for (const auto& [x, y] :
         {std::pair{2, 10}, {53, 10}, {10, 1}, {10, 40}, {-1, -1}, {1 << 30, 5}})
        list.add(x, y, 1.0, light);
    EXPECT_TRUE(list.splats().empty());
    EXPECT_TRUE(list.bins().empty());
    EXPECT_EQ(list.invalid(), 0);
}

TEST(SplatList, CountsWhatIsNoLight) {
    const WavelengthPacket packet = four_wavelengths(0.3);
    SplatList list(kLayout);
    list.add(10, 10, 1.0, light_of(packet, std::nan("")));
    list.add(10, 10, 1.0, light_of(packet, -1.0));
    list.add(10, 10, 1.0, light_of(packet, HUGE_VAL));
    list.add(10, 10, std::nan(""), light_of(packet, 1.0));
    EXPECT_TRUE(list.splats().empty());
    EXPECT_EQ(list.invalid(), 4);
    // Too bright: kept at the largest value, and counted.
    list.add(10, 10, 1.0, light_of(packet, 1e60));
    ASSERT_EQ(list.splats().size(), 1u);
    EXPECT_EQ(list.splats()[0].xyz[1], 0x1p64f);
    EXPECT_EQ(list.invalid(), 5);
}

TEST(SplatList, ComesBackFromItsBytesAndRefusesOthers) {
    std::mt19937 engine(1);
    const SplatList list = random_splats(engine, 50);
    std::string bytes;
    list.append_bytes(bytes);
    SplatSums a = prepared(), b = prepared();
    add(a, list);
    add(b, SplatList::from_bytes(kLayout, bytes));
    EXPECT_EQ(hash_of(a), hash_of(b));

    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_THROW(SplatList::from_bytes(kLayout, bytes.substr(0, size)), InputError);
    EXPECT_THROW(SplatList::from_bytes(kLayout, bytes + "x"), InputError);
    FilmLayout smaller = kLayout;  // its pixels would lie outside
    smaller.crop = {3, 2, 4, 3};
    EXPECT_THROW(SplatList::from_bytes(smaller, bytes), InputError);
    FilmLayout fewer_bins = kLayout;
    fewer_bins.spectral_bins = 1;
    EXPECT_THROW(SplatList::from_bytes(fewer_bins, bytes), InputError);
    std::string negative = bytes;
    negative[8 + 7] = char(negative[8 + 7] ^ 0x80);  // the sign of the first splat's X
    EXPECT_THROW(SplatList::from_bytes(kLayout, negative), InputError);
}

TEST(SplatList, TheLargestPictureHasANumberForEachPixel) {
    constexpr int kSide = 65536;  // validate() allows no more
    SplatList list({kSide, kSide, {0, 0, kSide, kSide}});
    const WavelengthPacket packet = four_wavelengths(0.3);
    list.add(kSide - 1, kSide - 1, 1.0, light_of(packet, 1.0));
    ASSERT_EQ(list.splats().size(), 1u);
    EXPECT_EQ(list.splats()[0].pixel, 0xFFFF'FFFFu);
}

// ---- sums --------------------------------------------------------------------------------------

TEST(SplatSums, DoNotDependOnTheOrderNorOnHowManyAddUpFirst) {
    std::mt19937 engine(2);
    const SplatList list = random_splats(engine, 3000);
    SplatSums whole = prepared();
    add(whole, list);
    std::vector<Splat> splats = list.splats();
    std::vector<BinSplat> bins = list.bins();
    for (int repeat = 0; repeat < 5; ++repeat) {
        std::shuffle(splats.begin(), splats.end(), engine);
        std::shuffle(bins.begin(), bins.end(), engine);
        SplatSums front = prepared(), back = prepared();
        const std::size_t cut = engine() % splats.size();
        front.add(std::span(splats).first(cut), {});
        back.add(std::span(splats).subspan(cut), bins);
        front.add(back);
        EXPECT_EQ(hash_of(front), hash_of(whole));
    }
}

TEST(SplatSums, AreTheSums) {
    std::mt19937 engine(3);
    const SplatList list = random_splats(engine, 3000);
    SplatSums sums = prepared();
    add(sums, list);
    struct Expected {
        std::array<double, 3> xyz{};
        double y_squared = 0.0;
        std::array<double, 3> bins{};
    };
    std::vector<Expected> expected(50 * 38);
    for (const Splat& splat : list.splats()) {
        for (std::size_t c = 0; c < 3; ++c) expected[splat.pixel].xyz[c] += splat.xyz[c];
        expected[splat.pixel].y_squared += double{splat.xyz[1]} * splat.xyz[1];
    }
    for (const BinSplat& splat : list.bins())
        expected[splat.pixel].bins[splat.bin] += splat.radiance;
    // Half a quantum a term: of XYZ 2⁻³⁹, of Y² (2¹⁴)² 2⁻⁶¹, of bins 2¹⁴ 2⁻³¹; a few terms a pixel.
    constexpr double kXyz = 1e-10, kSquare = 1e-8, kBin = 1e-3, kRelative = 1e-12;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const SplatSums::Arrived arrived = sums.at(i);
        const Expected& e = expected[i];
        for (std::size_t c = 0; c < 3; ++c)
            ASSERT_NEAR(arrived.xyz[c], e.xyz[c], kXyz + kRelative * e.xyz[c]);
        ASSERT_NEAR(arrived.y_squared, e.y_squared, kSquare + kRelative * e.y_squared);
        for (int bin = 0; bin < 3; ++bin)
            ASSERT_NEAR(sums.bin(i, bin), e.bins[std::size_t(bin)], kBin);
    }
}

TEST(SplatSums, StopAtTheirLargestValue) {
    const WavelengthPacket packet = four_wavelengths(0.3);
    SplatList list(kLayout);
    list.add(10, 10, 1.0, light_of(packet, 1e60));
    SplatSums sums = prepared();
    double before = 0.0;
    for (int i = 0; i < 1000; ++i) {
        add(sums, list);
        const SplatSums::Arrived arrived = sums.at(list.splats()[0].pixel);
        ASSERT_GE(arrived.xyz[1], before);
        ASSERT_GT(arrived.y_squared, 0.0);
        before = arrived.xyz[1];
    }
}

TEST(SplatSums, TakeMemoryWhereLightArrives) {
    SplatSums sums = prepared();
    EXPECT_EQ(sums.blocks(), 8u);  // 1900 pixels
    EXPECT_EQ(sums.touched_blocks(), 0u);
    SplatList list(kLayout);
    const WavelengthPacket packet = four_wavelengths(0.3);
    list.add(52, 39, 1.0, light_of(packet, 1.0));
    add(sums, list);
    EXPECT_EQ(sums.touched_blocks(), 1u);
    EXPECT_TRUE(sums.touched(7));
    EXPECT_EQ(sums.at(0).xyz, Colour<Xyz>{});
}

TEST(SplatSums, ComeBackFromTheirBytes) {
    std::mt19937 engine(4);
    SplatSums sums = prepared(), back = prepared();
    add(sums, random_splats(engine, 100));
    for (std::size_t block = 0; block < sums.blocks(); ++block) {
        std::string bytes;
        sums.append_block(block, bytes);
        ASSERT_EQ(bytes.size(), sums.block_bytes(block));
        back.add_block(block, bytes);
    }
    EXPECT_EQ(hash_of(back), hash_of(sums));
    std::string bytes;
    sums.append_block(0, bytes);
    bytes[15] = char(bytes[15] | 0x80);  // the first X becomes negative
    EXPECT_THROW(back.add_block(0, bytes), InputError);
}

/// What is kept are the sums of the moment of freezing, whatever arrives meanwhile; what is read
/// holds everything at any time.
TEST(SplatSums, FrozenTheyKeepTheMomentAndMissNothing) {
    std::mt19937 engine(5);
    for (int repeat = 0; repeat < 20; ++repeat) {
        SplatSums live = prepared(), moment = prepared(), all = prepared();
        const auto arrive = [&](SplatSums* also) {
            const SplatList list = random_splats(engine, int(engine() % 8));
            add(live, list);
            add(all, list);
            if (also) add(*also, list);
        };
        for (int i = 0; i < 3; ++i) arrive(&moment);
        live.freeze();
        SplatSums kept = prepared();
        for (std::size_t block = 0; block < live.blocks(); ++block) {
            arrive(nullptr);
            std::string bytes;
            live.keep(block, &bytes);
            EXPECT_EQ(bytes.empty(), !moment.touched(block));
            if (!bytes.empty()) kept.add_block(block, bytes);
            for (const std::size_t pixel : {0u, 700u, 1899u}) {
                EXPECT_DOUBLE_EQ(live.at(pixel).xyz[0], all.at(pixel).xyz[0]);
                EXPECT_DOUBLE_EQ(live.bin(pixel, 1), all.bin(pixel, 1));
            }
        }
        live.thaw();
        arrive(nullptr);
        EXPECT_EQ(hash_of(kept), hash_of(moment));
        EXPECT_EQ(hash_of(live), hash_of(all));
    }
}

}  // namespace
}  // namespace dewbow
