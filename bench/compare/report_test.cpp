// SPDX-License-Identifier: Apache-2.0
#include "report.h"

#include <gtest/gtest.h>

namespace dewbow::bench {
namespace {

PictureErrors of_mse(double mse) {
    PictureErrors errors;
    errors.mse = mse;
    return errors;
}

Result result_of(const std::string& contestant, Knobs knobs, double cpu_s, double mse) {
    Result result{"disc", contestant, knobs};
    result.cpu_s = cpu_s;
    result.errors = {{"whole", of_mse(mse), std::nullopt}, {"coloured", of_mse(mse), std::nullopt}};
    return result;
}

/// `path` errs by 0.1 / √t (root mean square), from 1 to 16 s.
Measurements measurements() {
    Measurements all;
    SceneFacts scene;
    scene.name = "disc";
    scene.mask_share = {{"whole", 1.0}, {"coloured", 0.1}};
    all.scenes.push_back(scene);
    all.results.push_back(result_of("path", {0, 1, 0}, 1.0, 0.01));
    all.results.push_back(result_of("path", {0, 16, 0}, 16.0, 0.01 / 16.0));
    return all;
}

TEST(Report, AimIsReadOffTheCurve) {
    Measurements all = measurements();
    // At 1 s path errs by 0.1, at 16 s by 0.025; this one by 0.4, and 0.2 against its own limit.
    all.results.push_back(result_of("pov-ray", {31, 4, 0}, 1.0, 0.16));
    all.results.back().errors[0].limit = of_mse(0.04);
    const std::string summary = summary_of(all);
    EXPECT_NE(summary.find("at the 1 s of CPU that pov-ray takes for 31 samples (4 spp) path has "
                           "this part of its error: "
                           "0.250, and at 16 times that time 0.062; and of its error against its "
                           "own limit: 0.500, and at "
                           "16 times that time 0.125."),
              std::string::npos)
        << summary;
}

TEST(Report, NothingIsClaimedBeyondTheCurve) {
    Measurements all = measurements();
    all.results.push_back(result_of("pov-ray", {31, 4, 0}, 2.0, 0.16));
    const std::string summary = summary_of(all);
    EXPECT_NE(summary.find("and at 16 times that time not measured"), std::string::npos) << summary;
}

TEST(Report, JitterIsComparedAtEqualSamples) {
    Measurements all = measurements();
    all.results.push_back(result_of("1989-fixed", {7, 4, 0}, 2.0, 0.04));
    all.results.push_back(result_of("1989-jittered", {7, 4, 0}, 3.0, 0.01));
    all.results.push_back(result_of("1989-correlated", {7, 4, 0}, 2.0, 0.0025));
    all.results.push_back(result_of("1989-correlated", {7, 1, 0}, 1.0, 0.3));
    const std::string summary = summary_of(all);
    EXPECT_NE(summary.find("| disc | 1989 | 7 | 4 | 0.2 | 0.500 | 1.50 | 0.250 | 1.00 |"),
              std::string::npos)
        << summary;
}

}  // namespace
}  // namespace dewbow::bench
