// SPDX-License-Identifier: Apache-2.0

// Slices and `dewbow merge` (row F12): in any order the very pixels of the undivided render; what
// is missing, overlaps or is of another render is refused, and leaves no file.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "dewbow/image/exr.h"
#include "tiny_render.h"

namespace dewbow::faults {
namespace {

/// 6 tiles in 5 passes, the last of 2 samples: 30 units, which neither 4 nor 5 slices share evenly
/// in both tiles and passes.
const Words kPicture{"--size", "48x32", "--spp", "18"};
constexpr const char* kEndings[] = {".exr", ".png"};

class Merge : public testing::Test {
protected:
    std::string slice(int number, int count, const Words& more = {}) const {
        const std::string name = fmt::format("{}-of-{}.dewbow", number, count);
        return render_slice(name, fmt::format("{}/{}", number, count), more);
    }
    std::string render_slice(const std::string& name, const std::string& slice,
                             const Words& more) const {
        const Outcome outcome =
            run(tiny_render(kPicture + more + Words{"--slice", slice, "-o", name}));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
        return name;
    }
    Outcome run(const Words& words) const {
        return run_program(DEWBOW_BINARY, words, folder_.path());
    }
    Outcome merge(const Words& states, const Words& more = {}) const {
        return run(Words{"merge"} + states + Words{"-o", "new.exr", "-o", "new.png"} + more);
    }
    std::string pixels(const std::string& name) const { return pixels_of(folder_.path() / name); }

    void expect_whole() const {
        for (const std::string ending : kEndings)
            EXPECT_EQ(pixels("new" + ending), true_pixels("whole" + ending, kPicture)) << ending;
    }
    void expect_refused(const Words& states, const Words& phrases) const {
        folder_.put("new.exr", "an older picture");
        const auto before = folder_.snapshot();
        const Outcome outcome = merge(states);
        EXPECT_EQ(faults_of_answer(outcome, 1, phrases), "");
        EXPECT_EQ(folder_.snapshot(), before);
    }

    RenderFolder folder_;
};

TEST_F(Merge, SlicesInAnyOrderAreTheWhole) {
    Words states;
    for (int k = 1; k <= 4; ++k) states.push_back(slice(k, 4));
    for (const auto& order :
         {std::vector<std::size_t>{0, 1, 2, 3}, {3, 1, 0, 2}, {2, 0, 3, 1, 0, 3}}) {
        Words ordered;
        for (const std::size_t i : order) ordered.push_back(states[i]);
        const Outcome outcome = merge(ordered, {"--json"});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
        expect_whole();
        EXPECT_EQ(nlohmann::json::parse(outcome.standard_output).at("complete"), true);
        const bool duplicate = order.size() > states.size();
        EXPECT_EQ(
            outcome.standard_error.find("was there already; it is left out") != std::string::npos,
            duplicate);
    }
}

TEST_F(Merge, TheFactsAreThoseOfTheWhole) {
    const Words states{slice(1, 2), slice(2, 2)};
    ASSERT_EQ(merge(states).exit_code, 0);
    ASSERT_EQ(run(tiny_render(kPicture + Words{"-o", "whole.exr"})).exit_code, 0);
    const auto facts = [&](const std::string& name) {
        std::map<std::string, decltype(Attribute::value)> values;
        for (const Attribute& fact :
             decode_exr(folder_.snapshot()[(folder_.path() / name).string()], name).attributes)
            if (fact.name != "dewbow:seconds") values[fact.name] = fact.value;
        return values;
    };
    EXPECT_GE(facts("new.exr").size(), 10u);
    EXPECT_EQ(facts("new.exr"), facts("whole.exr"));
}

TEST_F(Merge, ExposureAndGamutTravelWithTheSlices) {
    const Words look{"--exposure", "2", "--gamut", "clip"};
    const Words states{slice(1, 2, look), slice(2, 2, look)};
    ASSERT_EQ(merge(states).exit_code, 0);
    EXPECT_EQ(pixels("new.png"), true_pixels("whole.png", kPicture + look));
    EXPECT_NE(pixels("new.png"), true_pixels("whole.png", kPicture)) << "the look changes nothing";
}

TEST_F(Merge, StatesMergeToStates) {
    const Words first{slice(1, 3), slice(2, 3)};
    ASSERT_EQ(run(Words{"merge"} + first + Words{"-o", "both.dewbow"}).exit_code, 0);
    EXPECT_EQ(merge({slice(3, 3), "both.dewbow"}).exit_code, 0);
    expect_whole();
}

TEST_F(Merge, AMissingSliceIsRefused) {
    expect_refused({slice(1, 3), slice(3, 3)}, {"10 of 30 units are missing", "--allow-missing"});
}

TEST_F(Merge, APictureWithMissingUnitsSaysSo) {
    const Outcome outcome = merge({slice(1, 3), slice(3, 3)}, {"--allow-missing", "--json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    EXPECT_EQ(nlohmann::json::parse(outcome.standard_output).at("complete"), false);
    std::string complete;
    for (const Attribute& fact :
         decode_exr(folder_.snapshot()[(folder_.path() / "new.exr").string()], "new.exr")
             .attributes)
        if (fact.name == "dewbow:complete") complete = std::get<std::string>(fact.value);
    EXPECT_EQ(complete, "false");
}

TEST_F(Merge, OverlappingSlicesAreRefused) {
    expect_refused({slice(1, 2), slice(1, 3)},
                   {"it holds 10 of 30 units, and 5 of these are in 1-of-2.dewbow already"});
}

TEST_F(Merge, SlicesOfOtherRendersAreRefused) {
    const std::string ours = slice(1, 2);
    const auto other = [&](const Words& more) { return render_slice("other.dewbow", "2/2", more); };
    expect_refused({ours, other({"--seed", "7"})},
                   {"the seed is 0 in 1-of-2.dewbow and 7 in other.dewbow"});
    expect_refused({ours, other({"--spp", "20"})}, {"is 18 in", "and 20 in"});
    expect_refused({ours, other({"--set", "shapes.1.radius_m=2"})}, {"the hash of the scene is"});
    expect_refused({ours, other({"--size", "48x33"})}, {"48x32 pixels", "48x33 pixels"});
}

TEST_F(Merge, ADamagedSliceIsRefused) {
    const std::string ours = slice(1, 2), other = slice(2, 2);
    std::string bytes = folder_.snapshot()[(folder_.path() / other).string()];
    bytes[bytes.size() / 2] ^= 1;
    folder_.put(other, bytes);
    expect_refused({ours, other}, {"2-of-2.dewbow", "damaged"});
    expect_refused({ours, "none.dewbow"}, {"none.dewbow"});
}

TEST_F(Merge, ASliceIsNoPicture) {
    const Outcome outcome = run(tiny_render({"--slice", "1/2", "-o", "slice.png"}));
    EXPECT_EQ(faults_of_answer(outcome, 2, {".dewbow"}), "");
    EXPECT_EQ(run(tiny_render({"--slice", "2/3"})).exit_code, 0);
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "tiny.slice-2-of-3.dewbow"));
    EXPECT_EQ(faults_of_answer(run({"merge", "a.dewbow"}), 2, {"-o is missing"}), "");
    EXPECT_EQ(faults_of_answer(run({"merge", "-o", "a.png"}), 2, {"the states to merge"}), "");
}

}  // namespace
}  // namespace dewbow::faults
