// SPDX-License-Identifier: Apache-2.0

// Every scene that there is loads, and shows something.

#include <algorithm>
#include <string>

#include "small_render.h"

namespace dewbow {
namespace {

using corpus::render_small;

const std::filesystem::path kExamples = std::filesystem::path(DEWBOW_SOURCE_DIR) / "examples";
const std::filesystem::path kShared = DEWBOW_SHARED_DATA;

std::vector<std::filesystem::path> scenes_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const auto& known = scene_extensions();
        const std::string extension = entry.path().extension().string();
        if (std::find(known.begin(), known.end(), extension) != known.end())
            files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// A picture with light in it, and not the same everywhere.
void expect_a_picture(const std::filesystem::path& file) {
    SCOPED_TRACE(file.string());
    const auto picture = render_small(file, 32, 24, 4);
    const double lit = picture.share([&](int x, int y) { return picture.rgb(x, y)[1] > 1e-4; });
    EXPECT_GT(lit, 0.02);
    const double like_first = picture.share(
        [&](int x, int y) { return std::abs(picture.rgb(x, y)[1] - picture.rgb(0, 0)[1]) < 1e-9; });
    EXPECT_LT(like_first, 0.99);
}

TEST(Files, ExamplesShowSomething) {
    const auto files = scenes_in(kExamples);
    EXPECT_GE(files.size(), 4u);
    for (const auto& file : files) expect_a_picture(file);
}

TEST(Files, BowsShowSomething) {
    const auto files = scenes_in(kExamples / "bows");
    EXPECT_GE(files.size(), 10u);
    for (const auto& file : files) expect_a_picture(file);
}

TEST(Files, SharedScenesAndMeshesShowSomething) {
    if (!std::filesystem::exists(kShared)) GTEST_SKIP() << kShared << " is not there";
    for (const char* folder : {"gltf", "mesh"}) {
        const auto files = scenes_in(kShared / folder);
        EXPECT_GE(files.size(), 5u) << folder;
        for (const auto& file : files) expect_a_picture(file);
    }
}

}  // namespace
}  // namespace dewbow
