// SPDX-License-Identifier: Apache-2.0
#include "rainbow_command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "command_option.h"
#include "dewbow/base/error.h"
#include "dewbow/rainbow/models.h"
#include "glass_facts.h"
#include "option_value.h"
#include "rainbow_option_value.h"
#include "rainbow_output.h"
#include "rainbow_plots.h"

namespace dewbow {
namespace {

constexpr int kMaxThreads = 1024;
constexpr Range kSizeParameters{1e-3, 50'000.0};

constexpr const char* kExamples = R"(Examples:
  dewbow rainbow                                      half a millimetre, in words
  dewbow rainbow --radius 0.3mm -o curve.csv --plot intensity=curve.svg
  dewbow rainbow storm.toml -o bow.exr -o bow.png     the table for renderers; the bow in the sky
  dewbow rainbow --model mie,debye,airy --radius 0.1mm --wavelengths 589.3 --plot intensity=m.svg
  dewbow rainbow --model mie --size-parameter 1000 --index 1.333 --angles 0,60,137.5 --amplitudes --json
  dewbow rainbow --self-test

Angles are scattering angles: 0 is forward, and 180 minus it the distance from the antisolar point.
Exit codes: 0 done, 1 failed, 2 used wrongly.)";

std::string models_described() {
    std::string text;
    for (const ScatteringModelRow& row : scattering_models())
        text += (text.empty() ? "" : "; ") + row.name + ", " + row.summary;
    return text;
}

std::vector<PlotKind> plot_kinds() {
    std::vector<PlotKind> kinds;
    for (const RainbowPlotRow& row : rainbow_plots()) kinds.push_back({row.kind, row.endings});
    return kinds;
}

std::string plots_described() {
    std::string text;
    for (const RainbowPlotRow& row : rainbow_plots())
        text += (text.empty() ? "" : "; ") + row.kind + ", " + row.summary;
    return text;
}

std::vector<std::string> model_names() {
    std::vector<std::string> names;
    for (const ScatteringModelRow& row : scattering_models()) names.push_back(row.name);
    return names;
}

/// What `find` finds; its errors name the option, unless they name a file.
template <class Find>
auto of_option(const char* option, Find find) {
    try {
        return find();
    } catch (const InputError& error) {
        if (!error.place().file.empty()) throw;
        throw UsageError(std::string(option) + ": " + error.sentence(), error.hint());
    }
}

}  // namespace

RainbowCommandLine::RainbowCommandLine(CLI::App& app) {
    rainbow_ = app.add_subcommand("rainbow", "Compute rainbows: curves, tables, plots, pictures");
    rainbow_->allow_extras();
    rainbow_->footer(kExamples);
    add_option(*rainbow_, "storm", storm_, "A file that says the same as the options below",
               "FILE.toml");
    add_model();
    add_drops();
    add_sun();
    add_view();
    add_output();
}

void RainbowCommandLine::add_model() {
    add_repeatable(
        *rainbow_, "--model", models_,
        "What computes it; more than one stand side by side in plots. " + models_described(),
        "NAME");
    add_repeatable(*rainbow_, "--order", orders_,
                   "Orders of light that count: 0 reflected, 2 the primary bow, 3 the secondary; "
                   "repeatable. Default: all",
                   "P");
    add_flag(*rainbow_, "--paper", paper_,
             "The rainbow of Musgrave 1989 instead: what is wrong in it, its table of fogs (-o "
             "FILE.csv), --plot paper=FILE and --plot errata=FILE");
    add_option(*rainbow_, "--tolerance", tolerance_,
               "Error that `auto` may make, of the primary bow's peak. Default: 0.02", "0.02");
}

void RainbowCommandLine::add_drops() {
    add_option(*rainbow_, "--radius", radius_, "All drops have this radius. Default: 0.5mm",
               "0.3mm");
    add_repeatable(*rainbow_, "--sizes", sizes_,
                   "How many drops there are of each size, such as normal:mean=0.5mm,width=10% or "
                   "rain:marshall-palmer,rate=5mm/h; repeatable: showers of equal cross section",
                   "KIND:NUMBERS");
    add_option(*rainbow_, "--shape", shape_, "Of the drops; those that fall are flattened",
               alternatives(drop_shape_names()));
    add_option(*rainbow_, "--oscillation", oscillation_,
               "Of flattened drops: standard deviation of the flattening over itself. Default: 0",
               "0.2");
    add_option(*rainbow_, "--tilt", tilt_,
               "Of flattened drops: standard deviation of the axis, degrees. Default: 0", "DEG");
    add_option(
        *rainbow_, "--water", water_,
        "What the drops are of: water or sea-water with temperature (and salt in g/kg), or any "
        "glass. Default: water@20C",
        "water@10C|sea-water@20C,35");
    add_option(*rainbow_, "--air", air_, "What is around the drops. Default: air", "air|vacuum");
    add_option(*rainbow_, "--index", index_,
               "Index against what is around, instead of --water and --air", "1.333|1.33+1e-8i");
    add_option(*rainbow_, "--size-parameter", size_parameter_,
               "Radius as 2 pi a over the wavelength in what is around: one sphere by number, "
               "where neither -o nor --plot is given",
               "1000");
}

void RainbowCommandLine::add_sun() {
    add_option(*rainbow_, "--sun-altitude", sun_altitude_, "Degrees above the horizon. Default: 20",
               "DEG");
    add_option(*rainbow_, "--sun-radius", sun_radius_, "Of its disc, degrees. Default: 0.26656",
               "DEG");
    add_flag(*rainbow_, "--point-sun", point_sun_, "A sun without extent");
    add_option(*rainbow_, "--limb-darkening", limb_darkening_,
               "u of the disc's brightness 1 - u (1 - mu). Default: 0", "0.6");
    add_flag(*rainbow_, "--redden", reddened_,
             "Let the sun shine through as much clear air as its altitude stands for");
    add_option(*rainbow_, "--haze", haze_,
               "Of that air: optical depth at 500 nm straight up. Default: 0.1", "0.1");
    add_option(*rainbow_, "--illuminant", illuminant_,
               "The light, which is white in pictures. Default: D65", "NAME");
}

void RainbowCommandLine::add_view() {
    add_option(*rainbow_, "--wavelengths", wavelengths_,
               "In vacuum, nm: a list or FROM:TO:STEP. Default: 380:780:5, of plots 589.3", "LIST");
    add_option(*rainbow_, "--angles", angles_,
               "Scattering angles, degrees: a list or FROM:TO:STEP. Default: 0:180:0.1", "LIST");
    add_option(*rainbow_, "--polarisation", polarisation_, "What plots and pictures show",
               alternatives(polarisation_names()));
    add_option(*rainbow_, "--polariser", polariser_,
               "Look through a polariser with its axis so many degrees from the vertical", "DEG");
    add_option(*rainbow_, "--clock-angle", clock_angle_,
               "Where on the bow, degrees from its top. Default: 0", "DEG");
}

void RainbowCommandLine::add_output() {
    add_repeatable(*rainbow_, "-o,--output", outputs_,
                   "A file to write, by its ending; repeatable: " + rainbow_outputs_described(),
                   "FILE");
    add_repeatable(*rainbow_, "--plot", plots_, "A plot to write; repeatable: " + plots_described(),
                   "KIND=FILE");
    add_flag(*rainbow_, "--amplitudes", amplitudes_,
             "With --size-parameter: show the complex amplitudes S1 and S2");
    add_flag(*rainbow_, "--self-test", self_test_,
             "Compare with published tables, print a report, and end");
    add_option(*rainbow_, "--threads", threads_, "Threads to use. Default: all", "N");
    add_flag(*rainbow_, "--no-cache", no_cache_,
             "Neither read nor keep spectral tables in $XDG_CACHE_HOME/dewbow or ~/.cache/dewbow");
    add_flag(*rainbow_, "-q,--quiet", quiet_, "Say nothing but warnings and errors");
    add_flag(*rainbow_, "--json", json_, "Print one JSON object on standard output");
}

void RainbowCommandLine::read_model(Storm& storm) const {
    const std::vector<std::string> known = model_names();
    for (const std::string& word : parse_words("--model", models_))
        storm.models.push_back(known[parse_word("--model", word, known)]);
    storm.orders = parse_orders("--order", orders_);
    if (tolerance_) storm.tolerance = parse_in_range("--tolerance", *tolerance_, kTolerances);
    if (paper_) storm.paper = true;
}

void RainbowCommandLine::refuse_all_but(const std::vector<std::string>& names,
                                        const std::string& reason) const {
    for (const CLI::Option* option : rainbow_->get_options())
        if (option->count() > 0 &&
            std::none_of(names.begin(), names.end(),
                         [&](const std::string& name) { return option->check_name(name); }))
            throw UsageError(reason + ": leave " + option->get_name() + " away");
}

void RainbowCommandLine::check_paper() const {
    if (!paper_) return;
    refuse_all_but({"--paper", "--output", "--plot", "--threads", "--quiet", "--json"},
                   "--paper is a rainbow of its own");
    for (const std::string& output : outputs_)
        if (ending_of(output) != ".csv")
            throw UsageError("--paper writes a table of fogs: expected -o FILE.csv, found \"" +
                             output + "\"");
}

void RainbowCommandLine::read_drops(Storm& storm) const {
    if (int(radius_.has_value()) + !sizes_.empty() + size_parameter_.has_value() > 1)
        throw UsageError("--radius, --sizes and --size-parameter contradict each other; keep one");
    if (index_ && (water_ || air_))
        throw UsageError("--index takes the place of --water and --air; keep one or the others");
    if (radius_) storm.sizes = {single_drop_size(parse_drop_radius("--radius", *radius_))};
    for (const std::string& text : sizes_)
        storm.sizes.push_back(of_option("--sizes", [&] { return parse_drop_sizes(text); }));
    if (shape_)
        storm.shape = static_cast<DropShape>(parse_word("--shape", *shape_, drop_shape_names()));
    if ((oscillation_ || tilt_) && storm.shape == DropShape::sphere)
        throw UsageError("--oscillation and --tilt are of drops with --shape oblate");
    if (oscillation_)
        storm.oscillation = parse_in_range("--oscillation", *oscillation_, kOscillations);
    if (tilt_) storm.tilt = parse_in_range("--tilt", *tilt_, kTilts_deg, "deg") * unit::deg;
    const auto glass = [](const char* option, const Text& name) {
        return name ? std::optional(of_option(option, [&] { return glass_named(*name); }))
                    : std::nullopt;
    };
    storm.water = glass("--water", water_);
    storm.air = glass("--air", air_);
    if (index_) storm.index = parse_drop_index("--index", *index_);
}

void RainbowCommandLine::read_sun(Storm& storm) const {
    const auto angle = [](const char* option, const Text& text, const Range& range) {
        return text ? std::optional(parse_in_range(option, *text, range, "deg") * unit::deg)
                    : std::nullopt;
    };
    if (point_sun_ && (sun_radius_ || limb_darkening_))
        throw UsageError(
            "--point-sun contradicts --sun-radius and --limb-darkening; keep one or the others");
    storm.sun_altitude = angle("--sun-altitude", sun_altitude_, kSunAltitudes_deg);
    storm.sun_radius = angle("--sun-radius", sun_radius_, kSunRadii_deg);
    if (point_sun_) storm.sun_radius = Angle{};
    if (limb_darkening_)
        storm.limb_darkening = parse_in_range("--limb-darkening", *limb_darkening_, kShareRange);
    if (reddened_) storm.reddened = true;
    if (haze_) storm.haze = parse_in_range("--haze", *haze_, kHazes);
    if (illuminant_)
        storm.illuminant = of_option("--illuminant", [&] { return &find_lamp(*illuminant_); });
}

void RainbowCommandLine::read_view(Storm& storm) const {
    if (wavelengths_)
        for (const double nm :
             parse_list("--wavelengths", *wavelengths_, kRainbowWavelengths_nm, "nm"))
            storm.wavelengths.push_back(nm * unit::nm);
    if (angles_)
        for (const double degrees : parse_list("--angles", *angles_, kScatteringAngles_deg, "deg"))
            storm.angles.push_back(degrees * unit::deg);
    if (polarisation_ && polariser_)
        throw UsageError("--polarisation and --polariser contradict each other; keep one");
    if (polarisation_)
        storm.polarisation = static_cast<Polarisation>(
            parse_word("--polarisation", *polarisation_, polarisation_names()));
    if (polariser_)
        storm.polariser =
            parse_in_range("--polariser", *polariser_, kPolariserAngles_deg, "deg") * unit::deg;
    if (clock_angle_)
        storm.clock_angle =
            parse_in_range("--clock-angle", *clock_angle_, kClockAngles_deg, "deg") * unit::deg;
}

void RainbowCommandLine::read_sphere(RainbowCommand& command) const {
    if (amplitudes_ && !size_parameter_)
        throw UsageError("--amplitudes are of one sphere: --size-parameter is missing");
    if (!size_parameter_) return;
    command.size_parameter = parse_in_range("--size-parameter", *size_parameter_, kSizeParameters);
    const bool files = !outputs_.empty() || !plots_.empty();
    if (amplitudes_ && files)
        throw UsageError("--amplitudes are printed: there is neither -o nor --plot for them");
    if (!files)
        refuse_all_but({"storm", "--size-parameter", "--index", "--model", "--order", "--angles",
                        "--amplitudes", "--threads", "--no-cache", "--quiet", "--json"},
                       "one sphere by number has neither sun nor sizes");
}

std::optional<RainbowCommand> RainbowCommandLine::command() const {
    if (!rainbow_->parsed()) return std::nullopt;
    RainbowCommand command;
    check_paper();
    if (storm_ && storm_->empty()) throw UsageError("the name of the storm file is empty");
    command.storm_file = storm_.value_or("");
    read_model(command.options);
    read_drops(command.options);
    read_sun(command.options);
    read_view(command.options);
    read_sphere(command);
    for (const std::string& output : outputs_)
        command.outputs.push_back(parse_file_name("--output", output, rainbow_output_endings()));
    for (const std::string& plot : plots_)
        command.plots.push_back(parse_plot("--plot", plot, plot_kinds()));
    if (threads_)
        command.threads = static_cast<int>(parse_integer("--threads", *threads_, 1, kMaxThreads));
    command.amplitudes = amplitudes_;
    command.cache = !no_cache_;
    command.quiet = quiet_;
    command.json = json_;
    command.self_test = self_test_;
    return command;
}

}  // namespace dewbow
