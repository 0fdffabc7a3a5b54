// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/output.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "dewbow/base/error.h"
#include "dewbow/base/file.h"
#include "dewbow/image/exr.h"
#include "dewbow/image/png.h"
#include "dewbow/image/spectral_exr.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {
namespace {

constexpr PixelRect kCrop{2, 1, 6, 4};

/// A folder that goes when the test ends.
class Output : public testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::path(testing::TempDir()) /
                  ("dewbow_output_" +
                   std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path folder_;
};

Scene scene_of(int bins) {
    Scene scene = make_empty_scene();
    scene.film.width = 8;
    scene.film.height = 5;
    scene.film.spectral_bins = bins;
    scene.render.seed = 18446744073709551615u;
    return scene;
}

/// Each pixel has a level of its own, the same at all wavelengths: 0.1 (x + 8 y).
double level_at(int x, int y) { return 0.1 * (x + 8 * y); }

FilmSums grey_film(const Scene& scene, const SessionOptions& options) {
    FilmSums film = make_film(scene, options);
    const PixelRect& crop = film.crop();
    constexpr int kSamples = 256;
    for (int y = crop.y0; y < crop.y1; ++y)
        for (int x = crop.x0; x < crop.x1; ++x)
            for (int i = 0; i < kSamples; ++i) {
                PixelSample sample;
                sample.wavelengths =
                    sample_wavelengths(WavelengthSampling::visual, 8, (i + 0.5) / kSamples);
                for (int k = 0; k < 8; ++k) sample.radiance[k] = level_at(x, y);
                sample.hit = i % 4 == 0;
                sample.depth = sample.hit ? 7.0 : 0.0;
                sample.normal = sample.hit ? Vec3{0.0, 1.0, 0.0} : Vec3{};
                sample.albedo = sample.hit ? Colour<Xyz>{{0.475235, 0.5, 0.544416}} : Colour<Xyz>{};
                film.add(x, y, sample, i);
            }
    return film;
}

const Attribute* find_fact(const Attributes& facts, std::string_view name) {
    for (const Attribute& fact : facts)
        if (fact.name == name) return &fact;
    return nullptr;
}

TEST_F(Output, WhatLightPathsBroughtIsALayerAndAPartOfThePicture) {
    const Scene scene = scene_of(2);
    FilmSums film = grey_film(scene, {});
    const Image before = image_from_film(film, scene.film);
    EXPECT_EQ(before.find("caustics.R"), nullptr);
    // Of 5 paths one brings the spectrum 2 to pixel (3, 1): 0.4.
    SplatList splats(film.layout());
    for (int i = 0; i < 256; ++i) {
        const WavelengthPacket packet =
            sample_wavelengths(WavelengthSampling::visual, 8, (i + 0.5) / 256);
        LaneValues values;
        for (int k = 0; k < 8; ++k) values[k] = 2.0;
        splats.add(3, 1, 1.0 / 256, SplatLight(packet, LaneSet::all(packet), values));
    }
    film.add_splats(splats, 5);
    const Image image = image_from_film(film, scene.film);
    constexpr double kWavelengths = 2e-3;  // 2048 of them stand for the spectrum
    // Equal energy is no grey under D65: its luminance is what is 0.4.
    const auto luminance = [&](const std::string& layer, std::size_t pixel) {
        const auto value = [&](const char* channel) {
            return double(image.find(layer + channel)->values[pixel]);
        };
        return 0.2126 * value("R") + 0.7152 * value("G") + 0.0722 * value("B");
    };
    EXPECT_NEAR(luminance("caustics.", 8 + 3), 0.4, kWavelengths);
    EXPECT_NEAR(luminance("", 8 + 3), level_at(3, 1) + 0.4, kWavelengths);
    EXPECT_EQ(luminance("caustics.", 8 + 4), 0.0);
    for (const char* channel : {"R", "A", "Z", "albedo.G"})
        EXPECT_EQ(image.find(channel)->values[8 + 4], before.find(channel)->values[8 + 4]);
    EXPECT_NEAR(film.bin(3, 1, 0), level_at(3, 1) + 0.4, 0.02);
}

TEST_F(Output, TheImageHasEveryLayer) {
    const Scene scene = scene_of(2);
    SessionOptions options;
    options.crop = kCrop;
    const FilmSums film = grey_film(scene, options);
    const Image image = image_from_film(film, scene.film);
    EXPECT_EQ(image.width, 4);
    EXPECT_EQ(image.height, 3);
    const std::size_t place = 1 * 4 + 2;  // pixel (4, 2) of the whole
    const auto at = [&](std::string_view name) { return image.find(name)->values.at(place); };
    const double level = level_at(4, 2);
    // Equal energy under D65 primaries: a little red; its luminance is the level.
    EXPECT_NEAR(0.2126 * at("R") + 0.7152 * at("G") + 0.0722 * at("B"), level, 1e-3 * level);
    EXPECT_GT(at("R"), at("B"));
    EXPECT_NEAR(at("A"), 0.25, 1e-6);
    EXPECT_NEAR(at("Z"), 7.0, 1e-6);
    EXPECT_NEAR(at("normal.Y"), 0.25, 1e-6);
    EXPECT_EQ(at("normal.X"), 0.0f);
    // Grey of D65's colour, a quarter of the samples.
    for (const char* name : {"albedo.R", "albedo.G", "albedo.B"})
        EXPECT_NEAR(at(name), 0.125, 1e-4) << name;
    const double centre_nm = 360.0 + 470.0 / 4.0;
    EXPECT_NEAR(at(emissive_channel_name(centre_nm * unit::nm)), level, 0.01 * level);
}

TEST_F(Output, WhiteLuminanceIsOne) {
    Scene scene = scene_of(0);
    scene.film.white_luminance *= 4.0;
    const FilmSums film = grey_film(scene, {});
    const Image image = image_from_film(film, scene.film);
    const double y = 0.2126 * image.find("R")->values[9] + 0.7152 * image.find("G")->values[9] +
                     0.0722 * image.find("B")->values[9];
    EXPECT_NEAR(y, level_at(1, 1) / 4.0, 1e-3);
}

TEST_F(Output, AnExrOfACropSaysWhereItLies) {
    const Scene scene = scene_of(3);
    SessionOptions options;
    options.crop = kCrop;
    const FilmSums film = grey_film(scene, options);
    SessionResult result;
    result.crop = kCrop;
    result.samples_per_pixel = 256.0;
    result.invalid_samples = 3;
    result.film_hash = 0x0123456789abcdefu;
    const RenderIdentity identity = render_identity(scene, options, estimators().front(), 0);
    const Attributes facts = render_facts(scene, identity, result, "a scene.toml");
    write_picture(folder_ / "out.exr", film, scene, {}, facts);

    const DecodedExr decoded = decode_exr(read_file(folder_ / "out.exr"), "out.exr");
    EXPECT_EQ(decoded.image.width, 4);
    EXPECT_EQ(decoded.image.height, 3);
    EXPECT_EQ(decoded.image.channels.size(), 14u);
    const auto text = [&](std::string_view name) {
        const Attribute* fact = find_fact(decoded.attributes, name);
        return fact ? std::get<std::string>(fact->value) : "missing";
    };
    EXPECT_EQ(text("dewbow:crop"), "2,1,4x3");
    EXPECT_EQ(text("dewbow:size"), "8x5");
    EXPECT_EQ(text("dewbow:scene"), "a scene.toml");
    EXPECT_EQ(text("dewbow:estimator"), "path");
    EXPECT_EQ(text("dewbow:settings"), identity.settings);
    EXPECT_EQ(text("dewbow:seed"), "18446744073709551615");
    EXPECT_EQ(text("dewbow:complete"), "true");
    EXPECT_EQ(text("dewbow:filmHash"), "0123456789abcdef");
    EXPECT_EQ(text("spectralLayoutVersion"), "1.0");
    EXPECT_EQ(std::get<std::int64_t>(find_fact(decoded.attributes, "dewbow:invalidSamples")->value),
              3);

    const Image expected = image_from_film(film, scene.film);
    for (const char* name : {"R", "G", "B", "A", "Z"})
        EXPECT_EQ(decoded.image.find(name)->values, expected.find(name)->values) << name;
}

TEST_F(Output, APngOfACropIsAPartOfTheWhole) {
    const Scene scene = scene_of(0);
    DisplaySettings display;
    display.exposure_stops = -1.0;
    SessionOptions options;
    options.crop = kCrop;
    const FilmSums whole = grey_film(scene, {}), part = grey_film(scene, options);
    write_picture(folder_ / "whole.png", whole, scene, display, {});
    write_picture(folder_ / "part.PNG", part, scene, display, {});
    const Image8 a = decode_png(read_file(folder_ / "whole.png"), "whole.png");
    const Image8 b = decode_png(read_file(folder_ / "part.PNG"), "part.PNG");
    ASSERT_EQ(b.width, kCrop.width());
    ASSERT_EQ(b.height, kCrop.height());
    for (int y = 0; y < b.height; ++y)
        for (int x = 0; x < b.width; ++x)
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(b.rgb[std::size_t(3 * (y * b.width + x) + c)],
                          a.rgb[std::size_t(3 * ((y + kCrop.y0) * a.width + x + kCrop.x0) + c)]);
}

TEST_F(Output, ExposureDoublesByTheStop) {
    const Scene scene = scene_of(0);
    const FilmSums film = grey_film(scene, {});
    DisplaySettings dark, bright;
    dark.exposure_stops = -2.0;
    bright.exposure_stops = -1.0;
    const Image8 a = display_from_film(film, scene.film, dark);
    const Image8 b = display_from_film(film, scene.film, bright);
    // Green of pixels (4, 0) and (2, 0), whose levels are 2 : 1; dither is one code value.
    EXPECT_NEAR(a.rgb[3 * 4 + 1], b.rgb[3 * 2 + 1], 2);
}

TEST_F(Output, UnknownExtensionsAreNamedWithTheNearest) {
    const Scene scene = scene_of(0);
    const FilmSums film = make_film(scene, {});
    try {
        write_picture(folder_ / "out.pmg", film, scene, {}, {});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("out.pmg"), std::string::npos) << error.what();
        EXPECT_NE(error.hint().find(".png"), std::string::npos) << error.hint();
    }
    EXPECT_THROW(check_picture_path(folder_ / "out"), InputError);
    EXPECT_THROW(check_picture_path(folder_ / "out.jpeg"), InputError);
    EXPECT_THROW(check_picture_path(folder_ / "no" / "out.exr"), InputError);
    EXPECT_NO_THROW(check_picture_path(folder_ / "out.exr"));
    EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

}  // namespace
}  // namespace dewbow
