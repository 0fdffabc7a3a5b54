// SPDX-License-Identifier: Apache-2.0
#include "report.h"

#include <fmt/format.h>

namespace dewbow::bench {
namespace {

std::string circumstances(const Measurements& all, const Plan& plan, const Circumstances& where) {
    const Machine& machine = where.machine;
    std::string text = fmt::format(
        "{}, {} hardware threads, {:.0f} GiB, {}; {}. Load average {:.2f} before, {:.2f} after. "
        "Each program used {} "
        "thread{}.\n\n    {}\n\n",
        machine.processor, machine.threads, machine.memory_GiB, machine.system, machine.time,
        where.load_before, where.load_after, plan.threads, plan.threads == 1 ? "" : "s",
        where.command);
    text += "| contestant | version |\n|---|---|\n";
    for (const auto& [contestant, version] : all.versions)
        text += fmt::format("| {} | {} |\n", contestant, version);
    for (const std::string& absent : where.absent)
        text += fmt::format("| {} | not here |\n", absent);
    return text;
}

std::string numbers(const PictureErrors& errors) {
    std::string text;
    for (const ErrorKind& kind : error_kinds())
        text += fmt::format(" {:.3g} |", errors.*kind.value);
    return text;
}

std::string table(const Measurements& all, const SceneFacts& scene) {
    std::string text = "| contestant | N | spp | CPU s | less start-up | wall s | MiB |";
    for (const ErrorKind& kind : error_kinds()) text += ' ' + kind.name + " |";
    text +=
        " MSE, coloured | FLIP, coloured | MSE, own limit | card |\n|---|---|---|---|---|---|---|";
    for (std::size_t i = 0; i < error_kinds().size() + 4; ++i) text += "---|";
    text += '\n';
    for (const Result& result : all.results) {
        if (result.scene != scene.name) continue;
        const MaskErrors& whole = result.over("whole");
        const MaskErrors& coloured = result.over("coloured");
        const int n = result.knobs.spectral_samples;
        text +=
            fmt::format("| {} | {} | {} | {:.3g} | {:.3g} | {:.3g} | {:.0f} |", result.contestant,
                        n == 0 ? "" : std::to_string(n), result.knobs.samples_per_pixel,
                        result.cpu_s, result.work_cpu_s(), result.wall_s, result.memory_MiB);
        text += numbers(whole.truth);
        text += fmt::format(" {:.3g} | {:.3g} | {} | {:.3f} {:.3f} {:.3f} |\n", coloured.truth.mse,
                            coloured.truth.flip,
                            whole.limit ? fmt::format("{:.3g}", whole.limit->mse) : "",
                            result.card[0], result.card[1], result.card[2]);
    }
    return text;
}

std::string scene_section(const Measurements& all, const SceneFacts& scene) {
    std::string text = fmt::format(
        "\n## {}\n\nError of the true picture itself: MSE {:.2g}, relative MSE {:.2g}; it is taken "
        "away. Coloured: {:.1f} % "
        "of the pixels.\n",
        scene.name, scene.truth_own.mse, scene.truth_own.relative_mse,
        100.0 * scene.mask_share.at("coloured"));
    for (const auto& [limit, errors] : scene.limit_error)
        text += fmt::format("The limit of {} lies {:.3g} (MSE; FLIP {:.3g}) from the truth.\n",
                            limit, errors.mse, errors.flip);
    text += fmt::format("\n![error over time](error-{}.svg)\n\n", scene.name) + table(all, scene);
    for (const std::string& what : scene.left_out) text += fmt::format("\nLeft out: {}\n", what);
    return text;
}

}  // namespace

std::string report_of(const Measurements& all, const Plan& plan, const Circumstances& where) {
    std::string text = "# Error at equal time\n\n" + circumstances(all, plan, where);
    text += "\n## Summary\n\n" + summary_of(all);
    for (const SceneFacts& scene : all.scenes) text += scene_section(all, scene);
    text += fmt::format(
        "\nErrors are medians over {} repeat{}. MSE is of linear sRGB with white = 1; relative MSE "
        "divides by b² + {}²; "
        "trimmed is relative MSE without the worst {} % of the pixels; FLIP is the mean. *Card* is "
        "what a white card is "
        "measured as; nothing is fitted. ![all pictures](contact-sheet.png)\n",
        plan.repeats, plan.repeats == 1 ? "" : "s", kFloor, 100.0 * kTrimmedShare);
    return text;
}

}  // namespace dewbow::bench
