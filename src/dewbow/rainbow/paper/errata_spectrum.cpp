// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "dewbow/rainbow/paper/errata_parts.h"
#include "dewbow/rainbow/paper/fog_table.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow::errata {
namespace {

/// The part of the sky around both bows, 34 to 56° from the antisolar point.
constexpr double kFrom_deg = 34.0, kTo_deg = 56.0;
/// Where each bow is, with its sun; the other one is far.
constexpr double kPrimary_deg[] = {38.0, 44.0}, kSecondary_deg[] = {48.0, 55.0};
/// What stands for the continuous spectrum.
constexpr int kMany = 400;

enum class Colours { cie, linear };

/// How intensities are made into colours: as the paper does, or without what else is wrong there.
struct Setup {
    PaperMethod method;
    double bucket_deg;
    std::vector<double> kernel;
};

Setup as_published() { return {{}, 0.1, sun_kernel(SunKernel::five_entries)}; }
Setup otherwise_right() {
    PaperMethod method;
    method.density = RayDensity::even_over_disc;
    method.per_solid_angle = true;
    method.divide_by_air = false;
    constexpr double kBucket_deg = 0.05;
    return {method, kBucket_deg, projection_kernel({kSunRadius, 0.0}, kBucket_deg * unit::deg)};
}

/// [bucket], from 34° on.
std::vector<double> intensities(const Setup& setup, Wavelength lambda) {
    const int count = int(std::lround((kTo_deg - kFrom_deg) / setup.bucket_deg));
    std::vector<Angle> edges;
    for (int k = count; k >= 0; --k)
        edges.push_back((180.0 - kFrom_deg - k * setup.bucket_deg) * unit::deg);
    std::vector<PolarisedFlux> cells(std::size_t(count), PolarisedFlux{});
    for (int p : {2, 3})
        add_geometric_flux(paper_index(setup.method, lambda), p, edges, cells,
                           setup.method.density);
    std::vector<double> result(cells.size());
    for (std::size_t k = 0; k < cells.size(); ++k) {
        const std::size_t cell = cells.size() - 1 - k;
        const double area = cell_solid_angle(edges[cell], edges[cell + 1]).to(unit::sr);
        result[k] = cells[cell].unpolarised() / (setup.method.per_solid_angle ? area : 1.0);
    }
    return convolve_mirrored(result, setup.kernel);
}

using Strip = std::vector<std::array<double, 3>>;

/// The bows in white light of equal energy (per nm), by `count` wavelengths. [bucket]
Strip strip(const Setup& setup, SpectralSpacing spacing, Colours colours, int count) {
    Strip result;
    for (int k = 0; k < count; ++k) {
        const double f = (k + 0.5) / count;
        const Wavelength lambda = paper_wavelength(f, spacing);
        const double nm = lambda.to(unit::nm);
        std::array<double, 3> colour = cie_xyz_bar(nm);
        // dλ/df, with the linear colours taken as they are at f.
        const double width =
            spacing == SpectralSpacing::frequency && colours == Colours::cie ? nm * nm : 1.0;
        if (colours == Colours::linear) colour = linear_spectrum_colour(f).v;
        const std::vector<double> buckets = intensities(setup, lambda);
        result.resize(buckets.size());
        for (std::size_t i = 0; i < buckets.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                result[i][c] += colour[c] * buckets[i] * width / count;
    }
    return result;
}

/// Greatest difference in any channel over the greatest Y (or green) of the bow.
double error_of(const Strip& few, const Strip& many, double bucket_deg, const double (&bow)[2]) {
    const auto first = std::size_t((bow[0] - kFrom_deg) / bucket_deg);
    const auto last = std::size_t((bow[1] - kFrom_deg) / bucket_deg);
    double difference = 0.0, brightest = 0.0;
    for (std::size_t i = first; i < last; ++i) {
        brightest = std::max(brightest, many[i][1]);
        for (std::size_t c = 0; c < 3; ++c)
            difference = std::max(difference, std::abs(few[i][c] - many[i][c]));
    }
    return difference / brightest;
}

struct Case {
    const char* name;
    SpectralSpacing spacing;
    Colours colours;
};
constexpr Case kCases[] = {
    {"even in wavelength, CIE", SpectralSpacing::wavelength, Colours::cie},
    {"even in frequency, CIE", SpectralSpacing::frequency, Colours::cie},
    {"even in frequency, linear colours", SpectralSpacing::frequency, Colours::linear},
};

ErratumCurve luminance(const std::string& label, const Strip& strip, double bucket_deg,
                       double brightest, bool as_published) {
    ErratumCurve curve{label, {}, {}, as_published};
    for (std::size_t i = 0; i < strip.size(); ++i) {
        const double r = kFrom_deg + (double(i) + 0.5) * bucket_deg;
        if (r < kSecondary_deg[0] || r > kTo_deg) continue;
        curve.x.push_back(r);
        curve.y.push_back(strip[i][2] / brightest);
    }
    return curve;
}

}  // namespace

Erratum thirteen_samples() {
    Erratum e;
    e.name = "E17", e.subject = "13 wavelengths";
    e.paper_says =
        "13 samples even in \"frequencies or wavelengths\"; the sun's disc blurs their "
        "rings together well enough";
    e.right =
        "it does not: 40 wavelengths for the primary, 60 for both, or jitter (right: with 65)";
    const auto percent = [](double error) { return 100.0 * error; };
    for (const auto& [where, setup] : {std::pair{"", otherwise_right()},
                                       std::pair{", with all else as published", as_published()}})
        for (const Case& c : kCases) {
            const Strip many = strip(setup, c.spacing, c.colours, kMany);
            const Strip few = strip(setup, c.spacing, c.colours, kPaperSamples);
            const Strip enough = strip(setup, c.spacing, c.colours, 5 * kPaperSamples);
            const auto row = [&](const char* bow, const double(&range)[2]) {
                e.rows.push_back({std::string(bow) + ", " + c.name + where, "%",
                                  percent(error_of(few, many, setup.bucket_deg, range)),
                                  percent(error_of(enough, many, setup.bucket_deg, range))});
            };
            row("primary", kPrimary_deg);
            row("secondary", kSecondary_deg);
            if (c.colours == Colours::cie && c.spacing == SpectralSpacing::wavelength &&
                e.curves.empty()) {
                double brightest = 0.0;
                for (std::size_t i = many.size() / 2; i < many.size(); ++i)
                    brightest = std::max(brightest, many[i][2]);
                e.curves = {luminance("13", few, setup.bucket_deg, brightest, true),
                            luminance("400", many, setup.bucket_deg, brightest, false)};
            }
        }
    e.x_label = "angle from the antisolar point (deg)";
    e.y_label = "Z of the secondary over its greatest";
    return e;
}

}  // namespace dewbow::errata
