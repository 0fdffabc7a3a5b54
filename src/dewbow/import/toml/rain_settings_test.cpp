// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/rain_settings.h"

#include <gtest/gtest.h>

#include "dewbow/import/toml/scene_toml.h"

namespace dewbow {
namespace {

RainSettings settings_of(const std::string& keys) {
    return parse_scene_toml("scene.toml", "[render.rain]\n" + keys).scene.render.rain;
}

// Each value is read, and is part of what a render is known by.
TEST(RainSettingsToml, OrdersChangeWhatARenderIs) {
    EXPECT_EQ(text_of(settings_of("")), "rain orders 1");
    EXPECT_EQ(text_of(settings_of("orders = 3")), "rain orders 3");
    EXPECT_EQ(text_of(settings_of("orders = \"all\"")), "rain orders all");
}

TEST(RainSettingsToml, WrongValuesAreNamed) {
    struct Wrong {
        const char *keys, *phrase;
    };
    for (const auto& [keys, phrase] :
         {Wrong{"order = 1", "unknown key \"order\" in [render.rain]"},
          Wrong{"orders = 0", "orders is 0"}, Wrong{"orders = 1001", "orders is 1001"},
          Wrong{"orders = 1.5", "orders is"}, Wrong{"orders = \"al\"", "\"al\""}}) {
        try {
            settings_of(keys);
            ADD_FAILURE() << keys;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(phrase), std::string::npos) << error.what();
        }
    }
}

// How often light may be scattered is one more than how often a path may.
TEST(RainSettings, PathsLeaveTheLastScatteringToTheLight) {
    for (const int orders : {1, 2, 5}) {
        int times = 0;
        while (RainSettings{orders}.may_scatter_again(times)) ++times;
        EXPECT_EQ(times, orders - 1);
    }
    EXPECT_TRUE(RainSettings{RainSettings::kAllOrders}.may_scatter_again(1'000'000));
}

}  // namespace
}  // namespace dewbow
