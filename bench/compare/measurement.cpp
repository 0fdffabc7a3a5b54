// SPDX-License-Identifier: Apache-2.0
#include "measurement.h"

#include <fmt/format.h>

#include <algorithm>

#include "dewbow/base/error.h"
#include "dewbow/import/import.h"
#include "exact_picture.h"
#include "forward_picture.h"
#include "machine.h"
#include "scratch_folder.h"

namespace dewbow::bench {
namespace {

/// The lamp of each scene that is seen straight, and is white.
constexpr const char* kCard = "card";
/// What shows how long a program takes before it renders: a picture of so few pixels.
constexpr int kStartUpSize = 4;
constexpr double kLeastWork_s = 1e-3;
/// Of the picture that tells caustics from direct light.
constexpr int kDirectSamples = 256;
constexpr std::uint64_t kDirectSeed = 3'000'017;

/// A contestant with one setting.
struct Arm {
    const Contestant* contestant;
    Knobs knobs;
    double samples() const {
        return double(std::max(1, knobs.spectral_samples)) * knobs.samples_per_pixel;
    }
};

std::vector<Arm> arms_of(const Contestant& contestant, const Plan& plan) {
    std::vector<Arm> arms;
    const auto add = [&](int spectral, int wanted) {
        const Knobs knobs{spectral, contestant.possible_samples_per_pixel(wanted), 0};
        const bool known = std::any_of(arms.begin(), arms.end(), [&](const Arm& arm) {
            return arm.knobs.spectral_samples == spectral &&
                   arm.knobs.samples_per_pixel == knobs.samples_per_pixel;
        });
        if (!known) arms.push_back({&contestant, knobs});
    };
    if (contestant.splits_spectrum()) {
        for (const int spp : plan.split_samples_per_pixel)
            for (const int spectral : plan.spectral_samples) add(spectral, spp);
    } else {
        for (const int spp : plan.samples_per_pixel) add(0, spp);
    }
    return arms;
}

/// The first of each, then the second of each…
std::vector<Arm> in_turn(const std::vector<std::vector<Arm>>& arms) {
    std::vector<Arm> turns;
    std::size_t most = 0;
    for (const auto& of_one : arms) most = std::max(most, of_one.size());
    for (std::size_t i = 0; i < most; ++i)
        for (const auto& of_one : arms)
            if (i < of_one.size()) turns.push_back(of_one[i]);
    return turns;
}

/// Median of a number over runs.
template <class Value>
double median_of(const std::vector<const Run*>& runs, const Value& value) {
    std::vector<double> values;
    for (const Run* run : runs) values.push_back(value(*run));
    return median(values);
}

PictureErrors median_errors(const std::vector<const Run*>& runs,
                            const std::function<const PictureErrors&(const Run&)>& of) {
    PictureErrors errors;
    for (const ErrorKind& kind : error_kinds())
        errors.*kind.value = median_of(runs, [&](const Run& run) { return of(run).*kind.value; });
    return errors;
}

Result summary_of(const std::vector<const Run*>& runs, double start_up_cpu_s, Picture picture) {
    const Run& first = *runs.front();
    Result result{first.scene, first.contestant, first.knobs};
    result.cpu_s = median_of(runs, [](const Run& run) { return run.usage.cpu_s; });
    result.wall_s = median_of(runs, [](const Run& run) { return run.usage.wall_s; });
    result.memory_MiB = median_of(runs, [](const Run& run) { return run.usage.peak_memory_MiB; });
    result.start_up_cpu_s = start_up_cpu_s;
    result.card = first.card;
    result.picture = std::move(picture);
    for (std::size_t i = 0; i < first.errors.size(); ++i) {
        MaskErrors errors{first.errors[i].mask, {}, std::nullopt};
        errors.truth = median_errors(
            runs, [&](const Run& run) -> const PictureErrors& { return run.errors[i].truth; });
        if (first.errors[i].limit)
            errors.limit = median_errors(
                runs, [&](const Run& run) -> const PictureErrors& { return *run.errors[i].limit; });
        result.errors.push_back(std::move(errors));
    }
    return result;
}

/// One scene, from its references to its results.
class SceneMeasurement {
public:
    SceneMeasurement(const BenchScene& scene, const std::vector<ContestantPtr>& contestants,
                     const Plan& plan, const std::function<void(const std::string&)>& say,
                     Measurements& all)
        : scene_(scene), plan_(plan), say_(say), all_(all) {
        for (const auto& contestant : contestants)
            if (contestant->shows(scene.plain)) contestants_.push_back(contestant.get());
        facts_.name = scene.name;
    }

    void run() {
        make_references();
        for (const Contestant* contestant : contestants_) measure_start_up(*contestant);
        std::vector<std::vector<Arm>> arms;
        for (const Contestant* contestant : contestants_)
            arms.push_back(arms_of(*contestant, plan_));
        std::vector<Arm> turns = in_turn(arms);
        for (int repeat = 0; repeat < plan_.repeats; ++repeat) {
            for (const Arm& arm : turns) run_arm(arm, repeat);
            std::reverse(turns.begin(), turns.end());
        }
        for (const auto& of_one : arms)
            for (const Arm& arm : of_one) sum_up(arm);
        all_.scenes.push_back(std::move(facts_));
    }

private:
    void make_references() {
        say_(scene_.name + ": the true picture");
        truth_ = true_picture(scene_, plan_.references);
        if (scene_.plain.has_caustics()) {
            const SeenPicture direct = direct_picture(scene_.plain, kDirectSamples, kDirectSeed);
            masks_ = make_masks(truth_.mean, direct.picture, direct.receivers);
            card_ = masks_.back().mask;
        } else {
            masks_ = make_masks(truth_.mean);
            card_ = pixels_of_lamp(scene_.plain, kCard);
        }
        facts_.truth = truth_.mean;
        facts_.truth_own = own_errors(truth_, masks_.front().mask);
        for (const NamedMask& mask : masks_)
            facts_.mask_share[mask.name] =
                double(std::count(mask.mask.begin(), mask.mask.end(), true)) /
                double(mask.mask.size());
        if (!plan_.with_limits) return;
        for (const Contestant* contestant : contestants_)
            if (!contestant->converges_to_truth()) make_limit(*contestant);
    }

    void make_limit(const Contestant& contestant) {
        const std::string name = contestant.limit_name();
        if (!limits_.count(name)) {
            say_(scene_.name + ": the limit of " + name);
            try {
                limits_[name] = own_limit(scene_, contestant, plan_.references);
            } catch (const InputError& error) {
                facts_.left_out.push_back(error.what());
                return;
            }
        }
        facts_.limit_error[name] =
            Comparison(limits_.at(name).mean, truth_).errors(masks_.front().mask);
    }

    void measure_start_up(const Contestant& contestant) {
        const BenchScene tiny = load_bench_scene(scene_.file, kStartUpSize, kStartUpSize);
        const Knobs knobs{contestant.splits_spectrum() ? plan_.spectral_samples.front() : 0,
                          contestant.possible_samples_per_pixel(1), 1};
        std::vector<double> cpu_s;
        for (int repeat = 0; repeat < plan_.repeats; ++repeat) {
            const ScratchFolder folder;
            const auto words = contestant.write({tiny, knobs, plan_.threads, folder.path()});
            cpu_s.push_back(run_child(words, folder.path()).cpu_s);
        }
        start_up_cpu_s_[contestant.name()] = median(cpu_s);
    }

    void run_arm(const Arm& arm, int repeat) {
        const std::string label = label_of(arm.contestant->name(), arm.knobs);
        double& rate = cpu_s_per_sample_[arm.contestant->name()];
        const double predicted_s = rate * arm.samples();
        if (gone_.count(label)) return;
        if (predicted_s > plan_.most_cpu_s) {
            leave_out(label, fmt::format("{} would take about {:.0f} s", label, predicted_s));
            return;
        }
        say_(fmt::format("{}: {} ({} of {})", scene_.name, label, repeat + 1, plan_.repeats));
        const ScratchFolder folder;
        Knobs knobs = arm.knobs;
        knobs.seed = std::uint64_t(repeat) + 1;
        const Order order{scene_, knobs, plan_.threads, folder.path()};
        try {
            Run run{scene_.name, arm.contestant->name(), knobs, repeat, {}, load_average()};
            run.usage = run_child(arm.contestant->write(order), folder.path());
            if (run.usage.exit_code != 0)
                throw InputError(fmt::format("{} ended with {}: {}", label, run.usage.exit_code,
                                             log_tail(folder.path())));
            Picture picture = arm.contestant->read(order);
            compare(*arm.contestant, picture, run);
            rate = run.usage.cpu_s / arm.samples();
            all_.runs.push_back(std::move(run));
            if (repeat == 0) pictures_[label] = std::move(picture);
        } catch (const InputError& error) {
            leave_out(label, error.what());
        }
    }

    void leave_out(const std::string& label, const std::string& why) {
        say_("left out: " + why);
        facts_.left_out.push_back(why);
        gone_[label] = true;
    }

    void compare(const Contestant& contestant, const Picture& picture, Run& run) const {
        const Comparison with_truth(picture, truth_);
        const auto limit = limits_.find(contestant.limit_name());
        std::optional<Comparison> with_limit;
        if (limit != limits_.end() && !contestant.converges_to_truth())
            with_limit.emplace(picture, limit->second);
        for (const NamedMask& mask : masks_) {
            MaskErrors errors{mask.name, with_truth.errors(mask.mask), std::nullopt};
            if (with_limit) errors.limit = with_limit->errors(mask.mask);
            run.errors.push_back(std::move(errors));
        }
        run.card = mean_colour(picture, card_);
        if (!scene_.plain.has_caustics()) return;
        const Colour<LinearSrgb> whole = mean_colour(truth_.mean, card_);
        for (const std::size_t c : {0u, 1u, 2u}) run.card[c] /= whole[c];
    }

    void sum_up(const Arm& arm) {
        std::vector<const Run*> runs;
        for (const Run& run : all_.runs)
            if (run.scene == scene_.name && run.contestant == arm.contestant->name() &&
                run.knobs.spectral_samples == arm.knobs.spectral_samples &&
                run.knobs.samples_per_pixel == arm.knobs.samples_per_pixel)
                runs.push_back(&run);
        if (runs.empty()) return;
        const std::string label = label_of(arm.contestant->name(), arm.knobs);
        all_.results.push_back(summary_of(runs, start_up_cpu_s_.at(arm.contestant->name()),
                                          std::move(pictures_[label])));
    }

    const BenchScene& scene_;
    const Plan& plan_;
    const std::function<void(const std::string&)>& say_;
    Measurements& all_;
    std::vector<const Contestant*> contestants_;
    SceneFacts facts_;
    Reference truth_;
    std::map<std::string, Reference> limits_;  ///< by limit_name
    std::vector<NamedMask> masks_;
    Mask card_;
    std::map<std::string, double> start_up_cpu_s_, cpu_s_per_sample_;  ///< by contestant
    std::map<std::string, bool> gone_;                                 ///< by label
    std::map<std::string, Picture> pictures_;                          ///< by label
};

}  // namespace

double Result::work_cpu_s() const { return std::max(kLeastWork_s, cpu_s - start_up_cpu_s); }

const MaskErrors& Result::over(const std::string& mask) const {
    const auto found = std::find_if(errors.begin(), errors.end(),
                                    [&](const MaskErrors& e) { return e.mask == mask; });
    if (found == errors.end()) throw InputError("there is no mask '" + mask + "'");
    return *found;
}

std::string label_of(const std::string& contestant, const Knobs& knobs) {
    if (knobs.spectral_samples == 0)
        return fmt::format("{}, {} spp", contestant, knobs.samples_per_pixel);
    return fmt::format("{}, N {}, {} spp", contestant, knobs.spectral_samples,
                       knobs.samples_per_pixel);
}

BenchScene load_bench_scene(const std::filesystem::path& file, int width, int height) {
    BenchScene bench{
        file.stem().string(), std::filesystem::absolute(file), load_scene(file).scene, {}};
    bench.scene.film.width = width;
    bench.scene.film.height = height;
    bench.plain = plain_scene(bench.scene);
    return bench;
}

Measurements measure(const std::vector<BenchScene>& scenes,
                     const std::vector<ContestantPtr>& contestants, const Plan& plan,
                     const std::function<void(const std::string&)>& say) {
    Measurements all;
    for (const auto& contestant : contestants)
        all.versions[contestant->name()] = contestant->version();
    for (const BenchScene& scene : scenes)
        SceneMeasurement(scene, contestants, plan, say, all).run();
    return all;
}

}  // namespace dewbow::bench
