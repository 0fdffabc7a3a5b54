// SPDX-License-Identifier: Apache-2.0

// What `dewbow glass paper` prints.

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "command.h"
#include "console.h"
#include "dewbow/base/file.h"
#include "dewbow/optics/paper_claims.h"
#include "glass_paper.h"

namespace dewbow {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kMakers[] = {"schott/", "ohara/", "hoya/", "hikari/", "cdgm/", "sumita/", ""};

std::string cell(std::optional<double> value, const char* form = "{:<10.6f} ") {
    return value ? fmt::format(fmt::runtime(form), *value) : fmt::format("{:<11}", "-");
}
template <class Value>
std::string row(const GlassPaper& paper, const std::string& title, std::optional<double> real,
                const Value& value, const char* form) {
    std::string text = fmt::format("  {:<32}", title);
    if (paper.real) text += cell(real, form);
    for (const PaperReading& reading : paper.readings)
        text += cell(reading.line ? value(reading) : std::nullopt, form);
    return text + "\n";
}

std::string index_text(const GlassPaper& paper) {
    std::string text =
        fmt::format("{}: at the far red (800 nm) {:.6g}, w {:.6g} (eq. 2)\n\n  {:<11}{:<14}{:<7}",
                    paper.title, paper.eta_red, paper.w, "line", "λ in vacuum", "f");
    if (paper.real) text += fmt::format("{:<11}", "real");
    for (const PaperReading& reading : paper.readings)
        text += fmt::format("{:<11}", reading.name());
    text += "\n";
    for (const PaperLine& line : paper.lines)
        text += row(
            paper, fmt::format("{:<11}{:>8.4f} nm   {:.4f}", line.name, line.lambda_nm, line.f),
            line.real, [&](const PaperReading& r) { return std::optional(r.line->at(line.f)); },
            "{:<10.6f} ");
    text += row(
        paper, "slope, per unit of f", std::nullopt,
        [](const PaperReading& r) { return std::optional(r.line->slope); }, "{:<10.6f} ");
    text += row(
        paper, "its w, by eq. 2", paper.w, [](const PaperReading& r) { return std::optional(r.w); },
        "{:<10.6f} ");
    if (paper.real)
        text += row(
            paper, "worst Δn, 380 to 800 nm", std::nullopt,
            [](const PaperReading& r) { return r.worst; }, "{:<10.1e} ");
    return text + fmt::format(
                      "\n  Eq. 9 as printed gives no index; as intended before the print "
                      "lost \"+ η\"; exact: the line that\n  has this w. Against air, "
                      "straight in the {}.\n",
                      spectral_spacing_names()[std::size_t(paper.spacing)]);
}

std::string fits_text(const GlassPaper& paper) {
    std::string text =
        "\n  Worst Δn of the formulas of §3.2, constants by least squares\n"
        "                                  fitted over      380-800 nm  405-670 nm\n"
        "                                  worst over       380-800     405-670     380-800\n";
    for (const PaperFit& fit : paper.fits) {
        const PaperFormula& formula = *fit.formula;
        const char* kind = !formula.right ? "printed" : formula.printed ? "" : "right";
        text += fmt::format("  {:<16}{:<33}{:<12.1e}{:<12.1e}{:<9.1e}{}\n", formula.name, kind,
                            fit.whole_error.worst, fit.narrow_error.worst, fit.beyond.worst,
                            formula.text);
    }
    for (const std::string& note : paper.notes) text += fmt::format("  note    {}\n", note);
    return text;
}

Json optional_json(std::optional<double> value) { return value ? Json(*value) : Json(nullptr); }

Json json_of(const FittedFormula& fit, const IndexError& error, SpectralBand band) {
    return {{"range_nm", {band.from_nm, band.to_nm}},
            {"constants", fit.constants},
            {"worst", error.worst},
            {"rms", error.rms}};
}

Json json_of(const GlassPaper& paper) {
    Json json = {{"name", paper.real ? Json(paper.title) : Json(nullptr)},
                 {"eta_red", paper.eta_red},
                 {"w", paper.w},
                 {"spacing", spectral_spacing_names()[std::size_t(paper.spacing)]},
                 {"lines", Json::array()},
                 {"readings", Json::object()},
                 {"formulas", Json::array()},
                 {"notes", paper.notes}};
    for (const PaperLine& line : paper.lines) {
        Json entry = {{"line", line.name},
                      {"lambda_nm", line.lambda_nm},
                      {"f", line.f},
                      {"real", optional_json(line.real)}};
        for (const PaperReading& reading : paper.readings)
            entry[reading.name()] = reading.line ? Json(reading.line->at(line.f)) : Json(nullptr);
        json["lines"].push_back(std::move(entry));
    }
    for (const PaperReading& reading : paper.readings)
        json["readings"][reading.name()] = reading.line
                                               ? Json{{"at_red", reading.line->at_red},
                                                      {"slope", reading.line->slope},
                                                      {"w", reading.w},
                                                      {"worst", optional_json(reading.worst)}}
                                               : Json(nullptr);
    for (const PaperFit& fit : paper.fits) {
        Json narrow = json_of(fit.narrow, fit.narrow_error, kPaperWaterData);
        narrow["worst_380_to_800_nm"] = fit.beyond.worst;
        json["formulas"].push_back(
            {{"name", fit.formula->name},
             {"formula", fit.formula->text},
             {"as_printed", fit.formula->printed},
             {"right", fit.formula->right},
             {"constants", fit.formula->constants},
             {"fits", {json_of(fit.whole, fit.whole_error, kPaperSpectrum), std::move(narrow)}}});
    }
    return json;
}

/// Without a glass: the claim about all of them.
void print_claim(bool json) {
    Json list = Json::array();
    std::string text =
        "\"Dispersive power is independent of optical density\": correlation of w with n_D\n\n"
        "  glasses   r       of\n";
    for (const std::string maker : kMakers) {
        const PowerAndDensity claim = power_and_density(maker);
        const std::string of = maker.empty() ? "all that have dispersion, but gases"
                                             : maker.substr(0, maker.size() - 1);
        text += fmt::format("  {:<9} {:<7.3f} {}\n", claim.glasses, claim.correlation, of);
        list.push_back({{"maker", maker.empty() ? Json(nullptr) : Json(of)},
                        {"glasses", claim.glasses},
                        {"correlation", claim.correlation}});
    }
    print_data(json ? Json{{"w_with_n_D", std::move(list)}}.dump() + "\n" : text);
}

}  // namespace

int run(const GlassPaperCommand& command) {
    if (command.is_of_all()) {
        if (!command.plot.empty()) write_file_atomically(command.plot, glass_claims_plot());
        print_claim(command.json);
        return kDone;
    }
    const GlassPaper paper = glass_paper(command);
    if (!command.plot.empty()) write_file_atomically(command.plot, glass_paper_plot(paper));
    if (command.json)
        print_data(json_of(paper).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
    else
        print_data(index_text(paper) + (paper.real ? fits_text(paper) : ""));
    return kDone;
}

}  // namespace dewbow
