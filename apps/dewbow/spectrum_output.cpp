// SPDX-License-Identifier: Apache-2.0
#include "spectrum_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "dewbow/base/check.h"
#include "dewbow/spectrum/monitors.h"
#include "rainbow_output.h"
#include "spectrum_plots.h"
#include "spectrum_white.h"

namespace dewbow {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kCurveSteps = 1300;  ///< hits the nodes of the linear curves

std::string curves_csv(const SpectrumSetup& setup) {
    std::string text = fmt::format(
        "# {}; each channel as a share of white per unit of f, of area 1\n"
        "f,lambda_nm,red,green,blue\n",
        setup.title());
    for (const double f : setup.steps(kCurveSteps)) {
        const MonitorRgb rgb = setup.model().density(f);
        text += fmt::format("{},{},{},{},{}\n", f, setup.model().wavelength(f).to(unit::nm), rgb[0],
                            rgb[1], rgb[2]);
    }
    return text;
}

Json model_json(const SpectrumSetup& setup) {
    const SpectralModelSettings& m = setup.command().model;
    const MonitorRow& monitor = find_monitor(m.monitor);
    Json json{{"colours", spectral_colours_names()[std::size_t(m.colours)]},
              {"spacing", spectral_spacing_names()[std::size_t(m.spacing)]}};
    if (m.colours == SpectralColours::empirical)
        json["negative"] = negative_colours_names()[std::size_t(m.negative)];
    json["red_nm"] = setup.model().wavelength(0.0).to(unit::nm);
    json["violet_nm"] = setup.model().wavelength(1.0).to(unit::nm);
    json["monitor"] = {{"name", monitor.primaries.name},   {"red", monitor.primaries.red},
                       {"green", monitor.primaries.green}, {"blue", monitor.primaries.blue},
                       {"white", monitor.primaries.white}, {"source", monitor.source}};
    return json;
}

Json place_json(const SpectrumSetup& setup, double f, const MonitorRgb& rgb) {
    return {{"f", f}, {"lambda_nm", setup.model().wavelength(f).to(unit::nm)}, {"rgb", rgb.v}};
}

Json samples_json(const SpectrumSetup& setup) {
    Json list = Json::array();
    for (int k = 0; k < setup.command().sampling.samples; ++k) {
        const SpectralSample sample = setup.prepared().sample(k, 0.5);
        list.push_back(place_json(setup, sample.f_colour, sample.rgb));
    }
    return list;
}

Json white_json(const SpectrumSetup& setup) {
    const SpectrumWhite white = measure_white(setup);
    Json json{{"sets", white.sums.size()}, {"any_channel_above_1", white.any_above_one}};
    for (std::size_t c = 0; c < 3; ++c) {
        const WhiteChannel& w = white.channels[c];
        json[kChannelNames[c]] = {{"mean", w.mean},         {"sd", w.sd},
                                  {"least", w.least},       {"greatest", w.greatest},
                                  {"above_1", w.above_one}, {"mean_clamped", w.clamped}};
    }
    return json;
}

Json summary(const SpectrumSetup& setup) {
    const SpectralSampling& s = setup.command().sampling;
    return {{"model", model_json(setup)},
            {"sampling",
             {{"samples", s.samples},
              {"jitter", jitter_names()[std::size_t(s.jitter)]},
              {"correlated", s.correlated},
              {"tailored", s.tailored}}},
            {"samples", samples_json(setup)},
            {"fixed_sum", setup.prepared().raw_tint().v},
            {"white", white_json(setup)}};
}

std::string json_with_curves(const SpectrumSetup& setup) {
    Json json = summary(setup);
    Json& curves = json["curves_per_f"] = Json::array();
    for (const double f : setup.steps(kCurveSteps))
        curves.push_back(place_json(setup, f, setup.model().density(f)));
    return json.dump(1) + "\n";
}

struct OutputRow {
    std::string ending, summary;
    bool shows_colours;  ///< as they look
    std::string (*encode)(const SpectrumSetup& setup);
};

const std::vector<OutputRow>& rows() {
    static const std::vector<OutputRow> all{
        {".csv", "the curves as a table", false, curves_csv},
        {".json", "curves, samples and sums for programs", false, json_with_curves},
        {".svg", "the curves as a plot", true,
         [](const SpectrumSetup& s) { return draw_spectrum_curves(s, ".svg"); }},
        {".png", "the spectrum as a strip of colours", true,
         [](const SpectrumSetup& s) { return draw_spectrum_strip(s, ".png"); }},
    };
    return all;
}

const OutputRow& row_of(const std::string& file) {
    const auto row = std::find_if(rows().begin(), rows().end(),
                                  [&](const OutputRow& r) { return r.ending == ending_of(file); });
    DEWBOW_CHECK(row != rows().end(), "the command line knows the endings");
    return *row;
}

std::string white_text(const SpectrumSetup& setup) {
    const SpectrumWhite white = measure_white(setup);
    std::string text = fmt::format("White over {} sets{}:\n", white.sums.size(),
                                   setup.command().sampling.correlated ? " at common offsets" : "");
    text += "           mean      sd   least  greatest  above 1  mean if clamped\n";
    for (std::size_t c = 0; c < 3; ++c) {
        const WhiteChannel& w = white.channels[c];
        text += fmt::format("  {:<6} {:8.4f} {:6.2f}% {:7.4f}  {:8.4f} {:8.3f} {:16.4f}\n",
                            kChannelNames[c], w.mean, 100.0 * w.sd, w.least, w.greatest,
                            w.above_one, w.clamped);
    }
    return text + fmt::format("  any channel above 1 in {:.3f} of them\n", white.any_above_one);
}

}  // namespace

const std::vector<std::string>& spectrum_output_endings() {
    static const std::vector<std::string> endings = [] {
        std::vector<std::string> names;
        for (const OutputRow& row : rows()) names.push_back(row.ending);
        return names;
    }();
    return endings;
}

std::string spectrum_outputs_described() {
    std::string text;
    for (const OutputRow& row : rows())
        text += (text.empty() ? "" : "; ") + row.ending + ", " + row.summary;
    return text;
}

bool output_shows_colours(const std::string& file) { return row_of(file).shows_colours; }

std::string spectrum_output(const std::string& file, const SpectrumSetup& setup) {
    return row_of(file).encode(setup);
}

std::string spectrum_text(const SpectrumSetup& setup) {
    constexpr int kMostShown = 40;
    const SpectralModelSettings& m = setup.command().model;
    const int samples = setup.command().sampling.samples;
    std::string text = fmt::format("{}: {:g} to {:g} nm, even in {}\n", setup.title(),
                                   setup.model().wavelength(0.0).to(unit::nm),
                                   setup.model().wavelength(1.0).to(unit::nm),
                                   spectral_spacing_names()[std::size_t(m.spacing)]);
    text += setup.sampling_title() + "; in the middle of their intervals:\n";
    text += "       f   λ (nm)      red    green     blue\n";
    for (int k = 0; k < std::min(samples, kMostShown); ++k) {
        const SpectralSample sample = setup.prepared().sample(k, 0.5);
        text += fmt::format("  {:.4f}  {:7.1f} {:8.4f} {:8.4f} {:8.4f}\n", sample.f_colour,
                            setup.model().wavelength(sample.f_colour).to(unit::nm), sample.rgb[0],
                            sample.rgb[1], sample.rgb[2]);
    }
    if (samples > kMostShown) text += fmt::format("  … {} more\n", samples - kMostShown);
    const MonitorRgb tint = setup.prepared().raw_tint();
    const bool moving = colours_move(setup.command().sampling.jitter);
    text += fmt::format("  {}: {:.4f} {:.4f} {:.4f}\n",
                        moving ? "their sum" : "their sum, before it was divided out", tint[0],
                        tint[1], tint[2]);
    return moving ? text + white_text(setup) : text;
}

std::string spectrum_json(const SpectrumSetup& setup, const std::vector<std::string>& written) {
    Json json = summary(setup);
    json["written"] = written;
    return json.dump() + "\n";
}

Attributes spectrum_facts(const SpectrumSetup& setup) {
    Attributes facts{{"dewbow:version", DEWBOW_VERSION}, {"dewbow:spectrum", setup.title()}};
    if (setup.command().gamma) facts.push_back({"dewbow:gamma", *setup.command().gamma});
    return facts;
}

}  // namespace dewbow
