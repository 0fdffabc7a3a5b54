// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/caustics.h"

#include <gtest/gtest.h>

#include "dewbow/import/toml/scene_toml.h"

namespace dewbow {
namespace {

CausticsSettings settings_of(const std::string& keys) {
    return parse_scene_toml("scene.toml", "[render.caustics]\n" + keys).scene.render.caustics;
}

// Each key is read, and each is part of what a render is known by.
TEST(CausticsToml, EachKeyChangesWhatARenderIs) {
    EXPECT_EQ(text_of(settings_of("")), "light paths 1, aimed true");
    EXPECT_EQ(text_of(settings_of("light_paths = 2.5")), "light paths 2.5, aimed true");
    EXPECT_EQ(text_of(settings_of("aimed = false")), "light paths 1, aimed false");
}

TEST(CausticsToml, WrongValuesAreNamed) {
    struct Wrong {
        const char *keys, *phrase;
    };
    for (const auto& [keys, phrase] :
         {Wrong{"light_pahts = 1", "unknown key \"light_pahts\" in [render.caustics]"},
          Wrong{"light_paths = -1", "light_paths is -1"},
          Wrong{"light_paths = 1001", "light_paths is 1001"},
          Wrong{"aimed = 1", "aimed is the number 1"}}) {
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
