// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/picture_settings.h"

#include <gtest/gtest.h>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

TEST(PictureSettings, ComeBackAsTheyWere) {
    PictureSettings settings{"my scene.toml", 4, 1.0 / 3.0, ExposureMode::automatic_if_far, -0.1};
    for (const std::string& name : gamut_mapping_names()) {
        settings.gamut = gamut_mapping_from_name(name);
        EXPECT_EQ(picture_settings_from_text(text_of(settings)), settings);
    }
    for (const ExposureMode mode : {ExposureMode::fixed, ExposureMode::automatic}) {
        settings.exposure = mode;
        EXPECT_EQ(picture_settings_from_text(text_of(settings)), settings);
    }
}

TEST(PictureSettings, RefuseWhatIsNoneOfThem) {
    const std::string good = text_of({"s.toml"});
    EXPECT_NO_THROW(picture_settings_from_text(good));
    for (const auto& [from, to] : {std::pair<std::string, std::string>{"packet 8", "packet x"},
                                   {"white_luminance 1", "white_luminance 0"},
                                   {"white_luminance 1", "white_luminance nan"},
                                   {"exposure_stops 0", "exposure_stops inf"},
                                   {"exposure_mode fixed", "exposure_mode slow"},
                                   {"gamut ", "gamut un"},
                                   {"scene_file", "scene"}}) {
        std::string bad = good;
        bad.replace(bad.find(from), from.size(), to);
        EXPECT_THROW(picture_settings_from_text(bad), InputError) << bad;
    }
    EXPECT_THROW(picture_settings_from_text(""), InputError);
}

}  // namespace
}  // namespace dewbow
