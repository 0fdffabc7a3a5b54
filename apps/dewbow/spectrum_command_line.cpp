// SPDX-License-Identifier: Apache-2.0
#include "spectrum_command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "command_option.h"
#include "dewbow/base/error.h"
#include "dewbow/spectrum/monitors.h"
#include "option_value.h"
#include "spectrum_output.h"
#include "spectrum_plots.h"

namespace dewbow {
namespace {

constexpr int kMostSets = 1'000'000;
constexpr double kLeastGamma = 0.1, kMostGamma = 10.0;

constexpr const char* kExamples = R"(Examples:
  dewbow spectrum                                     the 13 samples of Musgrave 1989, in words
  dewbow spectrum -o curves.svg -o strip.png          his linear curves, and what they look like
  dewbow spectrum --colours empirical --monitor srgb --plot sums=sums.svg
  dewbow spectrum --colours cie --jitter both --correlated --plot white=offset.svg
  dewbow spectrum --samples 7 --jitter both --sets 100000 --json
  dewbow spectrum --colours empirical --gamma 2.5 -o strip.png

Exit codes: 0 done, 1 failed, 2 used wrongly.)";

std::vector<PlotKind> plot_kinds() {
    std::vector<PlotKind> kinds;
    for (const SpectrumPlotRow& row : spectrum_plots()) kinds.push_back({row.kind, row.endings});
    return kinds;
}

std::string plots_described() {
    std::string text;
    for (const SpectrumPlotRow& row : spectrum_plots())
        text += (text.empty() ? "" : "; ") + row.kind + ", " + row.summary;
    return text;
}

/// The enumerator whose word `text` is, if it was given.
template <class Enum>
void read_word(const char* option, const std::optional<std::string>& text,
               const std::vector<std::string>& words, Enum& value) {
    if (text) value = static_cast<Enum>(parse_word(option, *text, words));
}

bool any_shows_colours(const SpectrumCommand& command) {
    return std::any_of(command.outputs.begin(), command.outputs.end(), output_shows_colours) ||
           std::any_of(command.plots.begin(), command.plots.end(), shows_colours);
}

}  // namespace

SpectrumCommandLine::SpectrumCommandLine(CLI::App& app) {
    spectrum_ = app.add_subcommand(
        "spectrum", "Show how white light is taken apart into coloured samples, and their sums");
    spectrum_->allow_extras();
    spectrum_->footer(kExamples);
    add_model();
    add_sampling();
    add_output();
}

void SpectrumCommandLine::add_model() {
    add_option(
        *spectrum_, "--colours", colours_,
        "The model: linear, by eye (Fig. 4.1); empirical, the observer under illuminant B on "
        "a monitor (Fig. 4.2); cie, the observer under D65, never clamped. Default: linear",
        alternatives(spectral_colours_names()));
    add_option(*spectrum_, "--monitor", monitor_,
               "Whose red, green and blue they are. Default: rogers",
               alternatives(monitor_names()));
    add_option(*spectrum_, "--negative", negative_,
               "Of empirical colours that the monitor does not have: keep negative channels, clamp "
               "them to zero, or limit them to the gamut, towards white. Default: clamp",
               alternatives(negative_colours_names()));
    add_option(*spectrum_, "--spacing", spacing_,
               "What samples are spaced evenly in. Default: frequency",
               alternatives(spectral_spacing_names()));
}

void SpectrumCommandLine::add_sampling() {
    add_option(*spectrum_, "--samples", samples_, "In a set. Default: 13", "N");
    add_option(*spectrum_, "--jitter", jitter_,
               "What moves within a sample's interval. Default: none",
               alternatives(jitter_names()));
    add_flag(*spectrum_, "--correlated", correlated_,
             "Jitter all samples of a set by the same offset");
    add_flag(*spectrum_, "--tailored", tailored_,
             "Give samples equal areas under the curves' sum, not equal widths");
    add_option(*spectrum_, "--sets", sets_, "Sets whose sums are measured. Default: 16384", "N");
    add_option(*spectrum_, "--seed", seed_, "Seed of the random numbers", "N");
}

void SpectrumCommandLine::add_output() {
    add_repeatable(*spectrum_, "-o,--output", outputs_,
                   "A file to write, by its ending; repeatable: " + spectrum_outputs_described(),
                   "FILE");
    add_repeatable(*spectrum_, "--plot", plots_,
                   "A plot to write; repeatable: " + plots_described(), "KIND=FILE");
    add_option(*spectrum_, "--gamma", gamma_,
               "Show strips with numbers to the power 1/G instead of sRGB's curve", "G");
    add_flag(*spectrum_, "-q,--quiet", quiet_, "Say nothing but warnings and errors");
    add_flag(*spectrum_, "--json", json_, "Print one JSON object on standard output");
}

SpectralModelSettings SpectrumCommandLine::model() const {
    SpectralModelSettings settings;
    read_word("--colours", colours_, spectral_colours_names(), settings.colours);
    read_word("--spacing", spacing_, spectral_spacing_names(), settings.spacing);
    read_word("--negative", negative_, negative_colours_names(), settings.negative);
    if (monitor_)
        settings.monitor = monitor_names()[parse_word("--monitor", *monitor_, monitor_names())];
    if (negative_ && settings.colours != SpectralColours::empirical)
        throw UsageError(
            "--negative is of --colours empirical: linear colours have no negative "
            "channels, and cie keeps them");
    return settings;
}

SpectralSampling SpectrumCommandLine::sampling() const {
    SpectralSampling sampling;
    if (samples_)
        sampling.samples = int(parse_integer("--samples", *samples_, 1, kMostSpectralSamples));
    read_word("--jitter", jitter_, jitter_names(), sampling.jitter);
    sampling.correlated = correlated_;
    sampling.tailored = tailored_;
    if (correlated_ && sampling.jitter == Jitter::none)
        throw UsageError("--correlated says how samples are jittered: --jitter is missing");
    return sampling;
}

std::optional<SpectrumCommand> SpectrumCommandLine::command() const {
    if (!spectrum_->parsed()) return std::nullopt;
    SpectrumCommand command;
    command.model = model();
    command.sampling = sampling();
    if (sets_) command.sets = int(parse_integer("--sets", *sets_, 1, kMostSets));
    if (seed_) command.seed = parse_seed("--seed", *seed_);
    if ((sets_ || seed_) && !colours_move(command.sampling.jitter))
        throw UsageError("--sets and --seed are of samples whose colours move",
                         "expected --jitter colour or --jitter both");
    if (gamma_) command.gamma = parse_real("--gamma", *gamma_, kLeastGamma, kMostGamma);
    for (const std::string& output : outputs_)
        command.outputs.push_back(parse_file_name("--output", output, spectrum_output_endings()));
    for (const std::string& plot : plots_)
        command.plots.push_back(parse_plot("--plot", plot, plot_kinds()));
    if (gamma_ && !any_shows_colours(command))
        throw UsageError("--gamma is of files that show colours, and none is asked for",
                         "for instance -o strip.png");
    command.quiet = quiet_;
    command.json = json_;
    return command;
}

}  // namespace dewbow
