// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "command.h"
#include "command_option.h"
#include "dewbow/base/error.h"
#include "dewbow/import/import.h"
#include "dewbow/render/estimator.h"
#include "dewbow/render/output.h"
#include "glass_command_line.h"
#include "option_value.h"
#include "rainbow_command_line.h"
#include "spectrum_command_line.h"

// All values arrive here as text: what a number must be is said by option_value.h in our words, and
// read without locale.

namespace dewbow {

namespace {

constexpr int kMaxThreads = 1024;
constexpr double kSmallestNoise = 1e-6;
constexpr double kFewestFps = 1e-3, kMostFrames = 1e9;
constexpr double kMostExposureStops = 64.0;
constexpr std::string_view kExamples = R"(Examples:
  dewbow render examples/disc.toml                    write disc.exr and disc.png
  dewbow render ring.glb -o ring.png --time 2m        as good as two minutes make it
  dewbow glass show N-SF11                            the index of a glass
  dewbow rainbow --radius 0.3mm -o curve.csv          what a drop does to light
  dewbow spectrum -o curves.svg                       how samples of white are coloured
`dewbow SUBCOMMAND --help` tells more.)";

constexpr std::string_view kRenderExamples = R"(Examples:
  dewbow render prism.toml                            write prism.exr and prism.png
  dewbow render ring.glb -o ring.exr --spp 256 --size 1920x1080
  dewbow render ring.glb -o ring.png --time 2m --exposure 0.5
  dewbow render prism.toml --noise 0.01 --json        stop at 1 % noise; tell a program
  dewbow render prism.toml --crop 100,50,64x64        a part, with the very pixels of the whole
  dewbow render ring.glb --glass Stone=gem/diamond    with another glass; --set, --env, --camera
  dewbow render ring.glb --spp 4096 --resume          go on where Ctrl-C or a crash ended it
  dewbow render prism.toml --pixel 12,7 --sample 3    what one path brought home

Exit codes: 0 done, 1 failed, 2 used wrongly, 3 done but more than one sample in a million was
invalid, 130 or 143 interrupted (what was rendered so far is written, and kept for --resume).)";

constexpr std::string_view kSceneExamples = R"(Examples:
  dewbow scene check ring.glb
  dewbow scene check ring.glb --glass Diamond=gem/diamond --json

Exit codes: 0 the scene can be rendered, 1 it cannot, 2 used wrongly.)";

/// "path, the spectral path tracer; …"
std::string estimators_described() {
    std::string text;
    for (const EstimatorRow& row : estimators()) text += row.name + ", " + row.description + "; ";
    return text + "auto, path or caustics, by what a pilot of the scene tells. Default: " +
           kDefaultEstimator;
}

std::vector<std::string> estimator_names() {
    std::vector<std::string> names{kAutomaticEstimator};
    for (const EstimatorRow& row : estimators()) names.push_back(row.name);
    return names;
}

/// Names of gamut mappings as options spell them: "towards-white".
std::vector<std::string> gamut_words() {
    std::vector<std::string> words = gamut_mapping_names();
    for (std::string& word : words) std::replace(word.begin(), word.end(), '_', '-');
    return words;
}

/// ".exr, .png"
std::string endings(const std::vector<std::string>& extensions) {
    std::string text;
    for (const std::string& extension : extensions) text += (text.empty() ? "" : ", ") + extension;
    return text;
}

const std::vector<std::string> kProgressNames{"auto", "bar", "plain", "json", "none"};
const std::vector<std::string> kWavelengthNames{"visual", "uniform"};
const std::vector<std::string> kPacketNames{"1", "4", "8", "16"};

/// Every option's text as it was given; an option that was not is absent.
struct SceneTexts {
    std::optional<std::string> scene, camera, environment, frame, fps;
    std::vector<std::string> glasses, settings;
};

struct RenderTexts {
    SceneTexts scene;
    std::vector<std::string> outputs;
    std::optional<std::string> size, spp, time, noise, crop, threads, seed, packet, exposure, gamut,
        slice, spectral_bins, max_depth, wavelengths, estimator, pixel, sample, checkpoint,
        checkpoint_every, progress;
    bool no_checkpoint = false, quiet = false, json = false;
    std::vector<std::string> resume_file;
};

/// One command line's parser.
class Parser {
public:
    Parser()
        : app_("A spectral renderer for light that has come apart into its colours.", "dewbow") {
        app_.set_version_flag("--version", "dewbow " DEWBOW_VERSION, "Show the version and end");
        app_.footer(std::string(kExamples));
        app_.allow_extras();
        app_.require_subcommand(0, 1);  // a file may be named like another subcommand
        add_render();
        add_scene();
        glass_.emplace(app_);
        rainbow_.emplace(app_);
        spectrum_.emplace(app_);
        merge_.emplace(app_);
    }

    Command parse(int argc, const char* const* argv) {
        try {
            app_.parse(argc, argv);
        } catch (const CLI::CallForVersion& version) {
            return ShowText{std::string(version.what()) + "\n"};
        } catch (const CLI::Success&) {
            return ShowText{deepest(app_).help(path_of(deepest(app_).get_parent()))};
        } catch (const CLI::ArgumentMismatch& error) {
            // "--spp: 1 required N missing", "json was given a disallowed flag override"
            const std::string what = error.what();
            const std::size_t colon = what.find(':');
            if (colon == std::string::npos)
                throw UsageError("--" + what.substr(0, what.find(' ')) + " takes no value",
                                 help_hint());
            throw UsageError(what.substr(0, colon) + " wants a value", help_hint());
        } catch (const CLI::ParseError& error) {
            refuse_extras();  // the cause, where an option is not known
            throw UsageError(error.what(), help_hint());
        }
        refuse_extras();
        if (render_->parsed()) return render_command();
        if (scene_check_->parsed()) return scene_check_command();
        if (const auto command = glass_->command()) return *command;
        if (const auto command = rainbow_->command()) return *command;
        if (const auto command = spectrum_->command()) return *command;
        if (const auto command = merge_->command()) return *command;
        throw UsageError("a subcommand is missing", help_hint());
    }

private:
    /// The scene's file, and what is to be otherwise in it.
    static void add_scene_options(CLI::App& app, SceneTexts& t) {
        add_option(app, "scene", t.scene, "The scene (" + endings(scene_extensions()) + ")",
                   "FILE");
        add_option(app, "--camera", t.camera, "The camera of the scene that takes the picture",
                   "NAME");
        add_option(app, "--frame", t.frame,
                   "The frame of a glTF file's animations; else it is at rest", "N");
        add_option(app, "--fps", t.fps, "Frames a second, for --frame (default 24)", "F");
        add_repeatable(app, "--glass", t.glasses,
                       "Make a material a body of that glass; repeatable", "MATERIAL=GLASS");
        add_option(app, "--env", t.environment,
                   "Surround the scene with this picture (.exr, .hdr) instead of its own "
                   "environment",
                   "FILE");
        add_repeatable(
            app, "--set", t.settings,
            "Put a value into the scene file, or above a file of another format; repeatable",
            "PATH=VALUE");
    }

    void add_scene() {
        scene_ = app_.add_subcommand("scene", "Look into scenes");
        scene_->allow_extras();
        scene_->footer(std::string(kSceneExamples));
        scene_check_ = scene_->add_subcommand(
            "check", "Tell what is in a scene, what is not used, and what will cost time");
        scene_check_->allow_extras();
        scene_check_->footer(std::string(kSceneExamples));
        add_scene_options(*scene_check_, scene_check_texts_);
        add_flag(*scene_check_, "--json", scene_check_json_, "Print JSON");
    }

    void add_render() {
        render_ = app_.add_subcommand("render", "Render a scene to pictures");
        render_->allow_extras();
        render_->footer(std::string(kRenderExamples));
        RenderTexts& t = render_texts_;
        add_scene_options(*render_, t.scene);
        render_
            ->add_option("-o,--output", t.outputs,
                         "A picture to write (" + endings(picture_extensions()) +
                             "); repeatable. Default: the scene's name with both endings, in the "
                             "current folder")
            ->type_name("FILE")
            ->allow_extra_args(false);
        const auto add = [&](const char* name, std::optional<std::string>& text,
                             const std::string& what, const std::string& form) {
            add_option(*render_, name, text, what, form);
        };
        add("--size", t.size, "Size of the picture in pixels", "WxH");
        add("--spp", t.spp, "Samples per pixel. With --time or --noise: as many as these allow",
            "N");
        add("--time", t.time, "Stop at the end of the pass in which this time is over",
            "30s|2m|1h");
        add("--noise", t.noise, "Stop when the picture's relative noise is below this", "0.01");
        add("--crop", t.crop, "Render only this part of the picture", "X,Y,WxH");
        add("--slice", t.slice,
            "Render only the K-th of N equal parts of the work, into a state (" +
                std::string(kStateExtension) + ") for dewbow merge",
            "K/N");
        add("--threads", t.threads, "Threads to use. Default: all", "N");
        add("--seed", t.seed, "Seed of the random numbers", "N");
        add("--packet", t.packet, "Wavelengths that one path carries", alternatives(kPacketNames));
        add("--exposure", t.exposure, "Exposure of PNG pictures; auto: by the picture",
            "STOPS|auto");
        add("--gamut", t.gamut, "How PNG pictures show colours that a screen does not have",
            alternatives(gamut_words()));
        add("--spectral-bins", t.spectral_bins, "Wavelength bins to write into EXR pictures", "N");
        add("--max-depth", t.max_depth, "Most surfaces that a path meets", "N");
        add("--wavelengths", t.wavelengths, "How wavelengths are spread over 360-830 nm",
            alternatives(kWavelengthNames));
        add("--estimator", t.estimator, "What computes the picture: " + estimators_described(),
            alternatives(estimator_names()));
        add("--pixel", t.pixel, "With --sample: compute one sample, show it, write nothing", "X,Y");
        add("--sample", t.sample, "The sample's number, from 0", "K");
        add("--checkpoint", t.checkpoint,
            "Where the state of the render is kept until the pictures are written. Default: beside "
            "the first output",
            "FILE" + std::string(kStateExtension));
        add("--checkpoint-every", t.checkpoint_every,
            "How often the state is kept (default 60s), beside when the render is interrupted",
            "60s|5m");
        add_flag(*render_, "--no-checkpoint", t.no_checkpoint, "Keep no state");
        resume_ = render_
                      ->add_option("--resume", t.resume_file,
                                   "Go on with the state of an interrupted render; default: where "
                                   "its state is kept")
                      ->type_name("[FILE" + std::string(kStateExtension) + "]")
                      ->expected(0, 1)
                      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
        add_flag(*render_, "-q,--quiet", t.quiet, "Say nothing but warnings and errors");
        add_flag(*render_, "--json", t.json, "Print one JSON object on standard output at the end");
        add("--progress", t.progress, "How progress is shown on standard error",
            alternatives(kProgressNames));
    }

    static const CLI::App& deepest(const CLI::App& app) {
        const auto parsed = app.get_subcommands();
        return parsed.empty() ? app : deepest(*parsed.front());
    }

    /// "dewbow glass show"
    static std::string path_of(const CLI::App* app) {
        std::string path;
        for (; app; app = app->get_parent())
            path = app->get_name() + (path.empty() ? "" : " " + path);
        return path;
    }

    std::string help_hint() const {
        return "`" + path_of(&deepest(app_)) + " --help` tells how it is used";
    }

    /// Words that no option and no place takes: the first of them is the mistake.
    void refuse_extras() const {
        const CLI::App& app = deepest(app_);
        std::vector<std::string> extras = app_.remaining(true);
        std::erase(extras, "--");
        if (extras.empty()) return;
        const auto option = std::find_if(extras.begin(), extras.end(), [](const std::string& word) {
            return word.starts_with("-");
        });
        if (option != extras.end()) refuse_option(app, option->substr(0, option->find('=')));
        refuse_word(app, extras.front());
    }

    [[noreturn]] void refuse_option(const CLI::App& app, const std::string& word) const {
        std::vector<std::string> names;
        for (const CLI::Option* option : app.get_options()) {
            for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        }
        const std::string nearest = nearest_word(word, names);
        throw UsageError("unknown option " + word,
                         nearest.empty() ? help_hint() : "did you mean " + nearest + "?");
    }

    [[noreturn]] void refuse_word(const CLI::App& app, const std::string& word) const {
        std::vector<std::string> names;
        for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
            names.push_back(sub->get_name());
        if (names.empty()) throw UsageError("one word too many: \"" + word + "\"", help_hint());
        throw UsageError("unknown subcommand \"" + word + "\"", hint_for(word, names));
    }

    std::string scene_file(const SceneTexts& t) const {
        if (!t.scene && !render_texts_.resume_file.empty() && !render_texts_.resume_file[0].empty())
            throw UsageError("the scene is missing: \"" + render_texts_.resume_file[0] +
                                 "\" is taken for the file of --resume",
                             "write --resume after the scene");
        if (!t.scene || t.scene->empty()) throw UsageError("the scene is missing", help_hint());
        return *t.scene;
    }

    LoadOptions load_options(const SceneTexts& t) const {
        if (t.camera && t.camera->empty()) throw UsageError("--camera wants a name", help_hint());
        if (t.environment && t.environment->empty())
            throw UsageError("--env wants the name of a file", help_hint());
        LoadOptions load;
        load.camera = t.camera.value_or("");
        load.environment = t.environment.value_or("");
        load.settings = t.settings;
        if (t.fps && !t.frame) throw UsageError("--fps counts for --frame N", help_hint());
        if (t.frame) load.frame = parse_real("--frame", *t.frame, 0.0, kMostFrames);
        if (t.fps) load.frames_per_second = parse_real("--fps", *t.fps, kFewestFps, kMostFrames);
        for (const std::string& text : t.glasses)
            load.glasses.push_back(parse_glass_override("--glass", text));
        return load;
    }

    SceneCheckCommand scene_check_command() const {
        return {scene_file(scene_check_texts_), load_options(scene_check_texts_),
                scene_check_json_};
    }

    RenderCommand render_command() const {
        const RenderTexts& t = render_texts_;
        RenderCommand command;
        command.scene_file = scene_file(t.scene);
        command.load = load_options(t.scene);
        read_slice(command);
        const std::vector<std::string> endings =
            t.slice ? std::vector<std::string>{std::string(kStateExtension)} : picture_extensions();
        for (const std::string& output : t.outputs)
            command.outputs.push_back(parse_file_name("--output", output, endings));
        command.quiet = t.quiet;
        command.json = t.json;
        if (t.size) command.size = parse_size("--size", *t.size);
        if (t.crop) command.crop = parse_crop("--crop", *t.crop);
        read_effort(command);
        read_sampling(command);
        read_display(command);
        read_replay(command);
        read_checkpoint(command.checkpoint);
        if (t.estimator)
            command.estimator =
                estimator_names()[parse_word("--estimator", *t.estimator, estimator_names())];
        return command;
    }

    void read_slice(RenderCommand& command) const {
        const RenderTexts& t = render_texts_;
        if (!t.slice) return;
        if (t.time || t.noise)
            throw UsageError(
                "--slice is a part of the samples of --spp; with --time or --noise "
                "nobody knows how many these are");
        const SliceOf slice = parse_slice("--slice", *t.slice);
        command.slice = Slice{slice.number, slice.count};
    }

    void read_effort(RenderCommand& command) const {
        const RenderTexts& t = render_texts_;
        if (t.time) command.time_limit = parse_duration("--time", *t.time);
        if (t.noise) command.noise_target = parse_real("--noise", *t.noise, kSmallestNoise, 1.0);
        if (t.spp)
            command.samples_per_pixel =
                static_cast<int>(parse_integer("--spp", *t.spp, 1, kMostSamples));
        else if (t.time || t.noise)
            command.samples_per_pixel = kMostSamples;
        if (t.threads)
            command.threads =
                static_cast<int>(parse_integer("--threads", *t.threads, 1, kMaxThreads));
        if (t.progress) {
            constexpr ProgressStyle kStyles[] = {ProgressStyle::automatic, ProgressStyle::bar,
                                                 ProgressStyle::plain, ProgressStyle::json,
                                                 ProgressStyle::none};
            command.progress = kStyles[parse_word("--progress", *t.progress, kProgressNames)];
        }
        if (command.quiet) command.progress = ProgressStyle::none;
    }

    void read_sampling(RenderCommand& command) const {
        const RenderTexts& t = render_texts_;
        if (t.seed) command.seed = parse_seed("--seed", *t.seed);
        if (t.packet) command.packet = parse_packet("--packet", *t.packet);
        if (t.wavelengths) {
            constexpr WavelengthSampling kWays[] = {WavelengthSampling::visual,
                                                    WavelengthSampling::uniform};
            command.wavelengths =
                kWays[parse_word("--wavelengths", *t.wavelengths, kWavelengthNames)];
        }
        if (t.max_depth)
            command.max_depth =
                static_cast<int>(parse_integer("--max-depth", *t.max_depth, 0, kMostDepth));
        if (t.spectral_bins)
            command.spectral_bins = static_cast<int>(
                parse_integer("--spectral-bins", *t.spectral_bins, 0, kMostSpectralBins));
    }

    void read_display(RenderCommand& command) const {
        const RenderTexts& t = render_texts_;
        command.automatic_exposure = t.exposure && *t.exposure == "auto";
        if (t.exposure && !command.automatic_exposure)
            command.exposure_stops =
                parse_real("--exposure", *t.exposure, -kMostExposureStops, kMostExposureStops);
        if (!t.gamut) return;
        const std::size_t index = parse_word("--gamut", *t.gamut, gamut_words());
        command.gamut = gamut_mapping_from_name(gamut_mapping_names()[index]);
    }

    void read_checkpoint(CheckpointWish& wish) const {
        const RenderTexts& t = render_texts_;
        const std::vector<std::string> endings{std::string(kStateExtension)};
        wish.wanted = !t.no_checkpoint;
        if (t.no_checkpoint && (t.checkpoint || t.checkpoint_every))
            throw UsageError(
                "--no-checkpoint keeps no state; --checkpoint and --checkpoint-every "
                "say how it is kept");
        if (t.checkpoint) wish.file = parse_file_name("--checkpoint", *t.checkpoint, endings);
        if (t.checkpoint_every)
            wish.interval = parse_duration("--checkpoint-every", *t.checkpoint_every);
        wish.resume = resume_->count() > 0;
        if (wish.resume && !t.resume_file.empty() && !t.resume_file.front().empty())
            wish.resume_file = parse_file_name("--resume", t.resume_file.front(), endings);
    }

    void read_replay(RenderCommand& command) const {
        const RenderTexts& t = render_texts_;
        if (t.pixel.has_value() != t.sample.has_value())
            throw UsageError("--pixel and --sample belong together");
        if (!t.pixel) return;
        const PixelPlace place = parse_pixel("--pixel", *t.pixel);
        command.replay =
            Replay{place.x, place.y, parse_integer("--sample", *t.sample, 0, kMostSamples - 1)};
    }

    CLI::App app_;
    CLI::App *render_ = nullptr, *scene_ = nullptr, *scene_check_ = nullptr;
    CLI::Option* resume_ = nullptr;
    std::optional<GlassCommandLine> glass_;
    std::optional<RainbowCommandLine> rainbow_;
    std::optional<SpectrumCommandLine> spectrum_;
    std::optional<MergeCommandLine> merge_;
    RenderTexts render_texts_;
    SceneTexts scene_check_texts_;
    bool scene_check_json_ = false;
};

}  // namespace

Command parse_command_line(int argc, const char* const* argv) { return Parser().parse(argc, argv); }

}  // namespace dewbow
