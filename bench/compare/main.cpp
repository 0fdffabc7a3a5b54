// SPDX-License-Identifier: Apache-2.0

// Error at equal time: named scenes, each contestant that is found, several numbers of samples. See
// docs/bench.md.

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>

#include "contact_sheet.h"
#include "dewbow/base/error.h"
#include "dewbow/base/file.h"
#include "dewbow/image/png.h"
#include "report.h"

namespace dewbow::bench {
namespace {

struct Options {
    std::vector<std::string> scenes = {"disc", "slit", "diamond"};
    std::filesystem::path scene_folder = "bench/scenes";
    std::vector<std::string> contestants;  ///< none: all
    std::map<std::string, std::filesystem::path> programs;
    std::vector<std::string> program_words;  ///< NAME=FILE
    std::string size = "96x96";
    int width = 96, height = 96;
    std::filesystem::path out = "out/bench";
    bool no_limits = false, list = false, references_only = false;
    Plan plan;
};

void add_options(CLI::App& app, Options& options) {
    Plan& plan = options.plan;
    app.add_option("--scenes", options.scenes, "Scenes of the folder, by name")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--scene-folder", options.scene_folder)->capture_default_str();
    app.add_option("--contestants", options.contestants,
                   "Who runs; default: all that are found (see --list)")
        ->delimiter(',');
    app.add_option("--program", options.program_words,
                   "NAME=FILE: where a contestant's program is, if not on the PATH (dewbow: beside "
                   "this one); repeatable");
    app.add_option("--size", options.size, "WxH, pixels")->capture_default_str();
    app.add_option("--spp", plan.samples_per_pixel,
                   "Samples a pixel of contestants that do not split rays")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--splits", plan.spectral_samples, "N of contestants that split rays")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--split-spp", plan.split_samples_per_pixel, "Their samples a pixel")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--repeats", plan.repeats)->check(CLI::Range(1, 1000))->capture_default_str();
    app.add_option("--threads", plan.threads, "Of each program")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    app.add_option("--most-cpu-s", plan.most_cpu_s, "Runs that would take longer are left out")
        ->capture_default_str();
    app.add_option("--truth-samples", plan.references.truth_samples, "Of each half of the truth")
        ->check(CLI::Range(1, 1 << 24))
        ->capture_default_str();
    app.add_option("--limit-splits", plan.references.limit_spectral_samples,
                   "N of the limits of contestants with a model of their own")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    app.add_option("--limit-spp", plan.references.limit_samples_per_pixel,
                   "Samples a pixel of each half of them; more than --split-spp")
        ->check(CLI::Range(1, 1 << 20))
        ->capture_default_str();
    app.add_flag("--no-limits", options.no_limits, "Compare with the truth alone");
    app.add_flag("--references-only", options.references_only, "Make references, run nothing");
    app.add_option("--references", plan.references.folder,
                   "Where references are kept; default: OUT/references");
    app.add_option("-o,--out", options.out, "Folder of the report")->capture_default_str();
    app.add_flag("--list", options.list, "Say who is here, and end");
}

void finish_options(Options& options) {
    if (std::sscanf(options.size.c_str(), "%dx%d", &options.width, &options.height) != 2 ||
        options.width < 1 || options.height < 1)
        throw InputError("--size is '" + options.size + "', but is WxH, as 96x96");
    for (const std::string& word : options.program_words) {
        const auto equals = word.find('=');
        if (equals == std::string::npos)
            throw InputError("--program is '" + word + "', but is NAME=FILE");
        options.programs[word.substr(0, equals)] = word.substr(equals + 1);
    }
    const auto here = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "dewbow";
    if (std::filesystem::exists(here)) options.programs.try_emplace("dewbow", here);
    Plan& plan = options.plan;
    plan.with_limits = !options.no_limits;
    if (plan.references.folder.empty()) plan.references.folder = options.out / "references";
    if (options.references_only) {
        plan.samples_per_pixel.clear();
        plan.split_samples_per_pixel.clear();
    }
}

/// Those that are asked for and found; names of the rest go to `absent`.
std::vector<ContestantPtr> find_contestants(const Options& options,
                                            std::vector<std::string>& absent) {
    std::vector<std::string> names;
    for (const ContestantRow& row : contestants()) names.push_back(row.name);
    for (const std::string& name : options.contestants)
        if (std::find(names.begin(), names.end(), name) == names.end())
            throw InputError("there is no contestant '" + name + "'", hint_for(name, names));
    const Programs programs(options.programs);
    std::vector<ContestantPtr> found;
    for (const ContestantRow& row : contestants()) {
        const auto& wanted = options.contestants;
        if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), row.name) == wanted.end())
            continue;
        ContestantPtr contestant = row.find(programs);
        if (contestant)
            found.push_back(std::move(contestant));
        else
            absent.push_back(row.name);
    }
    return found;
}

void list_contestants(const Programs& programs) {
    for (const ContestantRow& row : contestants()) {
        const ContestantPtr contestant = row.find(programs);
        std::printf("%-32s %-28s %s\n", row.name.c_str(),
                    contestant ? contestant->version().c_str() : ("no " + row.program).c_str(),
                    row.description.c_str());
    }
}

void write_report(const Options& options, const Measurements& all, const Circumstances& where) {
    std::filesystem::create_directories(options.out);
    const auto write = [&](const std::string& name, const std::string& bytes) {
        write_file_atomically(options.out / name, bytes);
    };
    write("results.jsonl", json_lines_of(all, options.plan, where));
    for (const SceneFacts& scene : all.scenes)
        write("error-" + scene.name + ".svg", plot_of(all, scene));
    write("contact-sheet.png", encode_png(contact_sheet(all), {}));
    write("report.md", report_of(all, options.plan, where));
}

int run(Options& options, const std::string& command) {
    finish_options(options);
    if (options.list) {
        list_contestants(Programs(options.programs));
        return 0;
    }
    Circumstances where{this_machine(), command, load_average(), 0.0, {}};
    const std::vector<ContestantPtr> found = find_contestants(options, where.absent);
    if (found.empty()) throw InputError("none of the contestants is here");
    std::vector<BenchScene> scenes;
    for (const std::string& name : options.scenes)
        scenes.push_back(load_bench_scene(options.scene_folder / (name + ".toml"), options.width,
                                          options.height));
    const auto say = [](const std::string& what) { std::cerr << what << std::endl; };
    const Measurements all = measure(scenes, found, options.plan, say);
    if (options.references_only) return 0;
    where.load_after = load_average();
    write_report(options, all, where);
    std::cout << summary_of(all);
    return 0;
}

}  // namespace
}  // namespace dewbow::bench

int main(int argc, char** argv) {
    using namespace dewbow::bench;
    Options options;
    CLI::App app("Error at equal time of dewbow and of other renderers");
    add_options(app, options);
    CLI11_PARSE(app, argc, argv);
    std::string command = "bench_compare";
    for (int i = 1; i < argc; ++i) command += std::string(" ") + argv[i];
    try {
        return run(options, command);
    } catch (const std::exception& error) {
        std::cerr << "bench_compare: " << error.what() << '\n';
        return 1;
    }
}
