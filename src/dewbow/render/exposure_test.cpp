// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/exposure.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dewbow {
namespace {

constexpr int kSide = 10;

/// A picture of `radiance` with `lamps` pixels a thousand times as bright, whose white is radiance
/// 1.
FilmSums picture(double radiance, int lamps) {
    FilmSums film(kSide, kSide, {0, 0, kSide, kSide}, 0, 1.0);
    for (int i = 0; i < kSide * kSide; ++i) {
        PixelSample sample;
        sample.wavelengths = sample_wavelengths(WavelengthSampling::visual, 8, 0.5);
        sample.radiance.fill(i < lamps ? 1000.0 * radiance : radiance);
        film.add(i % kSide, i / kSide, sample, 0);
    }
    return film;
}

/// Eight wavelengths give a constant spectrum a Y that is off by less than a tenth of a stop.
constexpr double kHalfAStep = 0.125 + 0.1;

TEST(AutomaticExposure, BringsAnEvenPictureToSevenTenths) {
    const Film settings;
    for (const double radiance : {1e-6, 0.02, 0.7, 300.0, 1e5})
        EXPECT_NEAR(automatic_exposure(picture(radiance, 0), settings), std::log2(0.7 / radiance),
                    kHalfAStep)
            << radiance;
}

TEST(AutomaticExposure, LetsLampsBeBright) {
    const Film settings;
    EXPECT_EQ(automatic_exposure(picture(0.1, 5), settings),
              automatic_exposure(picture(0.1, 0), settings));
    // A fifth of the picture is no lamp.
    EXPECT_NEAR(automatic_exposure(picture(0.1, 20), settings), std::log2(0.7 / 100.0), kHalfAStep);
}

TEST(AutomaticExposure, GoesByTheFilmsWhite) {
    Film settings;
    const double at_one = automatic_exposure(picture(0.3, 0), settings);
    settings.white_luminance *= 16.0;
    EXPECT_EQ(automatic_exposure(picture(0.3, 0), settings), at_one + 4.0);
}

TEST(AutomaticExposure, OfBlackIsNone) {
    EXPECT_EQ(automatic_exposure(picture(0.0, 0), Film{}), 0.0);
}

TEST(Exposure, IsTheStatedOneUnlessTheSceneLeavesItOpen) {
    const FilmSums bright = picture(300.0, 0), nearly_right = picture(1.2, 0);
    Film settings;
    settings.exposure_stops = 1.5;
    EXPECT_EQ(exposure_of(bright, settings), 1.5);
    settings.exposure = ExposureMode::automatic;
    EXPECT_EQ(exposure_of(nearly_right, settings), automatic_exposure(nearly_right, settings));
    settings.exposure = ExposureMode::automatic_if_far;
    EXPECT_EQ(exposure_of(nearly_right, settings), 0.0);
    EXPECT_EQ(exposure_of(bright, settings), automatic_exposure(bright, settings));
    const FilmSums night = picture(0.03, 0), black_room = picture(1e-4, 0);
    EXPECT_EQ(exposure_of(night, settings), 0.0);
    EXPECT_EQ(exposure_of(black_room, settings), automatic_exposure(black_room, settings));
}

}  // namespace
}  // namespace dewbow
