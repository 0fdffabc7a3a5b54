// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/distributed_1989.h"

#include <gtest/gtest.h>

#include <set>

#include "dewbow/import/toml/scene_toml.h"

namespace dewbow {
namespace {

Distributed1989Settings settings_of(const std::string& keys) {
    return parse_scene_toml("scene.toml", "[render.distributed_1989]\n" + keys)
        .scene.render.distributed_1989;
}

TEST(Distributed1989Toml, DefaultsAreThePapers) {
    EXPECT_EQ(text_of(settings_of("")), text_of(Distributed1989Settings{}));
    EXPECT_EQ(text_of(Distributed1989Settings{}),
              "samples 13, jitter none, correlated false, tailored false, colours linear, spacing "
              "frequency, negative clamp, monitor rogers, sum clamp, transport rgb, index linear, "
              "reflectance nominal, least weight 0.00392156862745098");
}

// Each key is read, and each is part of what a render is known by.
TEST(Distributed1989Toml, EachKeyChangesWhatARenderIs) {
    std::set<std::string> seen{text_of(Distributed1989Settings{})};
    const std::vector<std::string> all{"samples = 31",
                                       "samples = 1000",
                                       "jitter = \"both\"",
                                       "jitter = \"index\"",
                                       "jitter = \"colour\"",
                                       "correlated = true",
                                       "tailored = true",
                                       "colours = \"cie\"",
                                       "colours = \"empirical\"",
                                       "spacing = \"wavelength\"",
                                       "negative = \"keep\"",
                                       "negative = \"limit\"",
                                       "monitor = \"srgb\"",
                                       "sum = \"wrap\"",
                                       "sum = \"free\"",
                                       "transport = \"spectral\"",
                                       "index = \"scene\"",
                                       "reflectance = \"spectral\"",
                                       "least_weight = 0"};
    for (const std::string& keys : all)
        EXPECT_TRUE(seen.insert(text_of(settings_of(keys))).second) << keys;
}

TEST(Distributed1989Toml, WrongValuesAreNamed) {
    struct Wrong {
        const char *keys, *phrase;
    };
    for (const auto& [keys, phrase] :
         {Wrong{"sampels = 13", "unknown key \"sampels\" in [render.distributed_1989]"},
          Wrong{"samples = 0", "samples is 0"}, Wrong{"samples = 1001", "samples is 1001"},
          Wrong{"jitter = \"bot\"", "jitter"}, Wrong{"sum = \"clmp\"", "sum"},
          Wrong{"monitor = \"sgrb\"", "srgb"}, Wrong{"least_weight = 2", "least_weight is 2"},
          Wrong{"correlated = 1", "correlated is the number 1"}}) {
        try {
            settings_of(keys);
            ADD_FAILURE() << keys;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(phrase), std::string::npos) << error.what();
        }
    }
}

}  // namespace
}  // namespace dewbow
