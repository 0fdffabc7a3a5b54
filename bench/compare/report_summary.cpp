// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <set>

#include "error_curve.h"
#include "report.h"

namespace dewbow::bench {
namespace {

constexpr const char* kPath = "path";
constexpr const char* kRival = "pov-ray";
/// The number of spectral samples that a careful user of a splitting renderer takes.
constexpr int kCarefulSplit = 31;
/// How much longer one waits for a final picture.
constexpr double kPatience = 16.0;

/// Which of two times.
using TimeOf = double (*)(const Result&);
double all_cpu(const Result& result) { return result.cpu_s; }
double work_cpu(const Result& result) { return result.work_cpu_s(); }

ErrorCurve curve_of(const Measurements& all, const std::string& scene,
                    const std::string& contestant, TimeOf time) {
    std::vector<CurvePoint> points;
    for (const Result& result : all.results)
        if (result.scene == scene && result.contestant == contestant)
            points.push_back({time(result), result.over("whole").truth.mse});
    return ErrorCurve(std::move(points));
}

/// Root of a ratio of mean squares: how much of another's error one has.
std::string share_of(const std::optional<double>& mse, double other_mse) {
    if (!mse || other_mse <= 0.0) return "not measured";
    return fmt::format("{:.3f}", std::sqrt(*mse / other_mse));
}

/// What the aim is about, a sentence for each scene and number of samples of `kRival`.
std::string aim_sentences(const Measurements& all, const SceneFacts& scene) {
    const ErrorCurve path = curve_of(all, scene.name, kPath, all_cpu);
    std::string text;
    for (const Result& rival : all.results) {
        if (rival.scene != scene.name || rival.contestant != kRival ||
            rival.knobs.spectral_samples != kCarefulSplit)
            continue;
        const MaskErrors& errors = rival.over("whole");
        const auto shares = [&](double mse) {
            return fmt::format("{}, and at {:.0f} times that time {}",
                               share_of(path.error_at(rival.cpu_s), mse), kPatience,
                               share_of(path.error_at(kPatience * rival.cpu_s), mse));
        };
        text += fmt::format(
            "* **{}**: at the {:.3g} s of CPU that {} takes for {} samples ({} spp) {} has this "
            "part of its error: {}",
            scene.name, rival.cpu_s, kRival, kCarefulSplit, rival.knobs.samples_per_pixel, kPath,
            shares(errors.truth.mse));
        if (errors.limit)
            text += fmt::format("; and of its error against its own limit: {}",
                                shares(errors.limit->mse));
        text += ".\n";
    }
    return text;
}

std::string equal_time_rows(const Measurements& all, const SceneFacts& scene) {
    const ErrorCurve with_start = curve_of(all, scene.name, kPath, all_cpu);
    const ErrorCurve without_start = curve_of(all, scene.name, kPath, work_cpu);
    std::string text;
    for (const Result& other : all.results) {
        if (other.scene != scene.name || other.contestant == kPath) continue;
        const bool splits = other.knobs.spectral_samples != 0;
        if (splits && other.knobs.spectral_samples != kCarefulSplit) continue;
        const MaskErrors& errors = other.over("whole");
        const auto row = [&](const std::string& against, double mse) {
            text += fmt::format("| {} | {} | {} | {:.3g} |", scene.name,
                                label_of(other.contestant, other.knobs), against, std::sqrt(mse));
            for (const double times : {1.0, kPatience})
                text += fmt::format(
                    " {} | {} |", share_of(with_start.error_at(times * other.cpu_s), mse),
                    share_of(without_start.error_at(times * other.work_cpu_s()), mse));
            text += '\n';
        };
        row("truth", errors.truth.mse);
        if (errors.limit) row("own limit", errors.limit->mse);
    }
    return text;
}

std::string equal_time(const Measurements& all) {
    std::string rows;
    for (const SceneFacts& scene : all.scenes)
        if (!scene.has_caustics()) rows += equal_time_rows(all, scene);
    if (rows.empty()) return {};
    return fmt::format(
               "What `{}` has of the error of others: root mean square error, over theirs, at "
               "their CPU time and at {:.0f} times "
               "that, on the measured curve (nothing beyond its ends). A contestant with N takes "
               "{}. *Own limit*: the "
               "other's error without that of its model, against `{}`'s whole error.\n\n"
               "| scene | other | its error against | RMSE | at equal time | less start-up | at "
               "{:.0f} × | less start-up "
               "|\n|---|---|---|---|---|---|---|---|\n",
               kPath, kPatience, kCarefulSplit, kPath, kPatience) +
           rows;
}

/// The three ways of one estimator, by the endings of their names.
constexpr const char* kFixed = "-fixed";
constexpr const char* kWays[] = {"-jittered", "-correlated"};

const Result* find_result(const Measurements& all, const Result& like, const std::string& name) {
    for (const Result& result : all.results)
        if (result.scene == like.scene && result.contestant == name &&
            result.knobs.spectral_samples == like.knobs.spectral_samples &&
            result.knobs.samples_per_pixel == like.knobs.samples_per_pixel)
            return &result;
    return nullptr;
}

/// Where light has come apart: elsewhere nothing is jittered.
double own_mse(const Result& result) {
    const MaskErrors& errors = result.over("coloured");
    return errors.limit ? errors.limit->mse : errors.truth.mse;
}

std::string jitter(const Measurements& all) {
    std::string rows;
    for (const Result& fixed : all.results) {
        const std::size_t stem = fixed.contestant.rfind(kFixed);
        if (stem == std::string::npos) continue;
        const std::string name = fixed.contestant.substr(0, stem);
        std::string row = fmt::format("| {} | {} | {} | {} | {:.3g} |", fixed.scene, name,
                                      fixed.knobs.spectral_samples, fixed.knobs.samples_per_pixel,
                                      std::sqrt(own_mse(fixed)));
        bool alone = true;
        for (const char* way : kWays) {
            const Result* other = find_result(all, fixed, name + way);
            alone = alone && !other;
            row += other ? fmt::format(" {} | {:.2f} |", share_of(own_mse(*other), own_mse(fixed)),
                                       other->work_cpu_s() / fixed.work_cpu_s())
                         : " | |";
        }
        if (!alone) rows += row + '\n';
    }
    if (rows.empty()) return {};
    return "\nWhat jitter and correlation buy: root mean square error of the coloured pixels over "
           "that of fixed samples, at equal N and samples; "
           "against the method's own limit where its model is not the true one. *Time*: CPU, less "
           "start-up, over "
           "that of fixed samples.\n\n"
           "| scene | method | N | spp | RMSE, fixed | jittered | time | correlated | time "
           "|\n|---|---|---|---|---|---|---|---|---|\n" +
           rows;
}

}  // namespace

std::string summary_of(const Measurements& all) {
    std::string aim;
    for (const SceneFacts& scene : all.scenes) aim += aim_sentences(all, scene);
    if (!aim.empty()) aim += '\n';
    return aim + equal_time(all) + caustics_of(all) + jitter(all);
}

}  // namespace dewbow::bench
