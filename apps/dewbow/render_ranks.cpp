// SPDX-License-Identifier: Apache-2.0
#include "render_ranks.h"

#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "console.h"
#include "dewbow/base/error.h"
#include "dewbow/base/parallel.h"
#include "dewbow/render/farm/worker.h"
#include "render_setup.h"

namespace dewbow {

int render_as_rank_0(Ranks& ranks, const std::function<int(Team&)>& render) {
    TeamOptions options;
    options.threads = thread_count();
    options.warn = [](const std::string& text) { print_message(presentable("warning: " + text)); };
    Team team(ranks.transport(), options);
    int code = kFailed;
    try {
        code = render(team);
    } catch (const InputError& error) {
        print_error(error.what());
        if (dynamic_cast<const UsageError*>(&error)) code = kUsedWrongly;
        if (team.all_have_left()) return code;
        Team sent_home(ranks.transport(), {});
        sent_home.part();
        if (sent_home.all_have_left()) return ranks.close(), code;
    }
    if (!team.all_have_left()) ranks.end_all(code);
    return code;
}

int work_as_other_rank(const RenderCommand& command, Ranks& ranks) {
    Parting parting = Parting::rank_0_lost;
    try {
        const LoadedScene loaded = load(command, true);
        const SessionOptions options = session_options(command);
        if (command.crop) check_crop(*command.crop, loaded.scene.film);
        const EstimatorChoice chosen = estimator_of(command, loaded.scene, true);
        parting = work_for_rank_0(ranks.transport(), *chosen.estimator,
                                  identity_of(command, loaded, options, chosen), thread_count());
    } catch (const InputError& error) {
        parting = say_bye(ranks.transport(), error.sentence());
    }
    if (parting == Parting::rank_0_lost) {
        print_error(fmt::format("rank {}: rank 0 has been silent for {} s, and is lost",
                                ranks.transport().rank(), kLongestSilence));
        ranks.end_all(kFailed);
    }
    if (parting == Parting::together) return ranks.close(), kDone;
    // Rank 0 ends this program when its pictures are written.
    std::this_thread::sleep_for(std::chrono::duration<double>(kLongestSilence));
    ranks.end_all(kFailed);
    return kFailed;
}

}  // namespace dewbow
