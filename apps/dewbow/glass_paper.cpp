// SPDX-License-Identifier: Apache-2.0
#include "glass_paper.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dewbow/base/error.h"
#include "glass_facts.h"

namespace dewbow {
namespace {

std::array<PaperLine, 5> lines_of(SpectralSpacing spacing) {
    std::array<PaperLine, 5> lines{{{"far red", kPaperRed.to(unit::nm)},
                                    {"C", kLineC.to(unit::nm)},
                                    {"D", kLineD.to(unit::nm)},
                                    {"F", kLineF.to(unit::nm)},
                                    {"far violet", kPaperViolet.to(unit::nm)}}};
    for (PaperLine& line : lines) line.f = paper_coordinate(line.lambda_nm * unit::nm, spacing);
    return lines;
}

/// eq. 2 of a line. As printed it is a number like any other.
double power_of(const LinearIndex& line, SpectralSpacing spacing) {
    const auto at = [&](Wavelength lambda) { return line.at(paper_coordinate(lambda, spacing)); };
    return (at(kLineF) - at(kLineC)) / (at(kLineD) - 1.0);
}

std::array<PaperReading, 3> readings_of(double eta_red, double w, SpectralSpacing spacing) {
    std::array<PaperReading, 3> readings{
        {{IndexReading::printed}, {IndexReading::intended}, {IndexReading::exact}}};
    for (PaperReading& reading : readings) {
        try {
            reading.line = linear_index(eta_red, w, reading.reading, spacing);
            reading.w = power_of(*reading.line, spacing);
        } catch (const InputError&) {  // beyond the pole
        }
    }
    return readings;
}

/// Greatest |Δn| at every nanometre of the paper's spectrum.
double worst_of(const LinearIndex& line, const Dispersion& real, SpectralSpacing spacing) {
    double worst = 0.0;
    for (double nm = kPaperViolet.to(unit::nm); nm <= kPaperRed.to(unit::nm); nm += 1.0) {
        const Wavelength lambda = nm * unit::nm;
        const double n = (real(lambda) / (*air())(lambda)).value;
        worst = std::max(worst, std::abs(line.at(paper_coordinate(lambda, spacing)) - n));
    }
    return worst;
}

std::vector<PaperFit> fits_of(const IndexInAir& n) {
    const auto whole = index_samples(n, kPaperSpectrum);
    const auto narrow = index_samples(n, kPaperWaterData);
    std::vector<PaperFit> fits;
    for (const PaperFormula& formula : paper_formulas()) {
        PaperFit fit{&formula, formula.fit(whole), formula.fit(narrow), {}, {}, {}};
        fit.whole_error = index_error(fit.whole, whole);
        fit.narrow_error = index_error(fit.narrow, narrow);
        fit.beyond = index_error(fit.narrow, whole);
        fits.push_back(std::move(fit));
    }
    return fits;
}

void add_glass(const std::string& name, GlassPaper& paper) {
    const GlassFacts facts(glass_named(name));
    const Dispersion& real = *facts.dispersion;
    const auto n = [&](double nm) { return (real(nm * unit::nm) / (*air())(nm * unit::nm)).value; };
    if (!disperses_in_air(facts.dispersion))
        throw UsageError(facts.glass.name + " has no dispersion against air",
                         "the paper's index is that of a body in air");
    paper.title = facts.glass.name;
    paper.notes = facts.notes();
    paper.real = facts.in_air;
    paper.eta_red = n(kPaperRed.to(unit::nm));
    paper.w = dispersive_power(facts.in_air);
    paper.readings = readings_of(paper.eta_red, paper.w, paper.spacing);
    for (PaperLine& line : paper.lines) line.real = n(line.lambda_nm);
    for (PaperReading& reading : paper.readings)
        if (reading.line) reading.worst = worst_of(*reading.line, real, paper.spacing);
    paper.fits = fits_of(paper.real);
}

}  // namespace

GlassPaper glass_paper(const GlassPaperCommand& command) {
    GlassPaper paper;
    paper.spacing = command.spacing;
    paper.lines = lines_of(command.spacing);
    if (!command.name.empty()) {
        add_glass(command.name, paper);
        return paper;
    }
    paper.title = fmt::format("eta_red {:g}, w {:g}", command.eta_red, command.w);
    paper.eta_red = command.eta_red;
    paper.w = command.w;
    paper.readings = readings_of(paper.eta_red, paper.w, paper.spacing);
    return paper;
}

}  // namespace dewbow
