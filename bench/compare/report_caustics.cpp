// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "error_curve.h"
#include "report.h"

namespace dewbow::bench {
namespace {

constexpr const char* kOurs = "caustics";

/// One of the measured errors over one mask, and how it is called.
struct Measure {
    std::string mask, name;
    double PictureErrors::*value;
};
const std::vector<Measure>& measures() {
    static const std::vector<Measure> all = {
        {"whole", "MSE", &PictureErrors::mse},
        {"whole", "clipped", &PictureErrors::clipped},
        {"caustic", "relative MSE, caustic", &PictureErrors::relative_mse},
    };
    return all;
}

double value_of(const Result& result, const Measure& measure) {
    return result.over(measure.mask).truth.*measure.value;
}

ErrorCurve our_curve(const Measurements& all, const std::string& scene, const Measure& measure) {
    std::vector<CurvePoint> points;
    for (const Result& result : all.results)
        if (result.scene == scene && result.contestant == kOurs)
            points.push_back({result.cpu_s, value_of(result, measure)});
    return ErrorCurve(std::move(points));
}

/// The longest run of a contestant, if our curve reaches so far.
const Result* longest_within(const Measurements& all, const std::string& scene,
                             const std::string& contestant, const ErrorCurve& curve) {
    const Result* longest = nullptr;
    for (const Result& result : all.results)
        if (result.scene == scene && result.contestant == contestant &&
            curve.error_at(result.cpu_s) && (!longest || longest->cpu_s < result.cpu_s))
            longest = &result;
    return longest;
}

std::string rows_of(const Measurements& all, const SceneFacts& scene) {
    std::string rows;
    const ErrorCurve curve = our_curve(all, scene.name, measures().front());
    for (const auto& [contestant, version] : all.versions) {
        const Result* other = longest_within(all, scene.name, contestant, curve);
        if (!other || contestant == kOurs) continue;
        rows += fmt::format("| {} | {} | {:.3g} |", scene.name, label_of(contestant, other->knobs),
                            other->cpu_s);
        for (const Measure& measure : measures()) {
            const double theirs = value_of(*other, measure);
            const auto ours = our_curve(all, scene.name, measure).error_at(other->cpu_s);
            rows += fmt::format(
                " {:.3g} | {} |", theirs,
                ours && theirs > 0.0 ? fmt::format("{:.3g}", *ours / theirs) : std::string("—"));
        }
        rows += fmt::format(" {:.3f} {:.3f} {:.3f} |\n", other->card[0], other->card[1],
                            other->card[2]);
    }
    return rows;
}

}  // namespace

std::string caustics_of(const Measurements& all) {
    std::string rows;
    for (const SceneFacts& scene : all.scenes)
        if (scene.has_caustics()) rows += rows_of(all, scene);
    if (rows.empty()) return {};
    std::string head = fmt::format(
        "\nWhat `{}` has of the mean squared error of others at their CPU time (with "
        "start-up, and what training costs): of their longest runs that its measured curve "
        "reaches. The last "
        "column is the mean colour of the other's caustic over the true one.\n\n"
        "| scene | other | CPU s |",
        kOurs);
    std::string rule = "\n|---|---|---|";
    for (const Measure& measure : measures()) {
        head += fmt::format(" {} | `{}` at that time over it |", measure.name, kOurs);
        rule += "---|---|";
    }
    return head + " mean colour |" + rule + "---|\n" + rows;
}

}  // namespace dewbow::bench
