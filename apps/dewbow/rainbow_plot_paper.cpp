// SPDX-License-Identifier: Apache-2.0

// The rainbows of Musgrave 1989 as strips of colour, by angle from the antisolar point.

#include <algorithm>
#include <cmath>

#include "dewbow/export/plot.h"
#include "dewbow/image/png.h"
#include "dewbow/rainbow/paper/fog_table.h"
#include "dewbow/rainbow/paper/impressionistic.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/display.h"
#include "dewbow/spectrum/illuminant.h"
#include "dewbow/spectrum/rgb.h"
#include "rainbow_plots.h"

namespace dewbow {
namespace {

constexpr double kFrom_deg = 38.0, kTo_deg = 56.0;
constexpr int kPixelsPerBucket = 5, kStripHeight = 60, kGap = 6;
constexpr int kWidth = int((kTo_deg - kFrom_deg) * 10.0) * kPixelsPerBucket;

using Row = std::vector<Colour<LinearSrgb>>;
struct Strip {
    std::string label;
    Row pixels;
};

Angle angle_of(int pixel) {
    return (kFrom_deg + (pixel + 0.5) * (kTo_deg - kFrom_deg) / kWidth) * unit::deg;
}

Strip rings(std::string label, const FogJitter& jitter) {
    std::vector<Angle> angles;
    for (int x = 0; x < kWidth; ++x) angles.push_back(angle_of(x));
    ImpressionisticBow bow;
    bow.jitter = jitter;
    constexpr int kSamples = 64;
    return {std::move(label), impressionistic_strip(bow, angles, kSamples, 0)};
}

Strip table(std::string label, const PaperMethod& method) {
    const FogTable fogs = make_fog_table(method);
    Row pixels;
    for (int x = 0; x < kWidth; ++x)
        pixels.push_back(fogs.intensity[std::size_t(angle_of(x) / kPaperBucket)]);
    return {std::move(label), pixels};
}

/// The corrected one in colours that are seen instead of the linear ones; daylight is white.
Strip as_seen(std::string label) {
    constexpr int kSamples = 130;
    const PaperMethod method = paper_method_corrected();
    const SpectrumPtr daylight = find_illuminant("D65");
    std::vector<Colour<Xyz>> buckets(kPaperBuckets);
    for (int k = 0; k < kSamples; ++k) {
        const Wavelength lambda =
            paper_wavelength((k + 0.5) / kSamples, SpectralSpacing::wavelength);
        const Colour<Xyz> colour = {cie_xyz_bar(lambda.to(unit::nm))};
        const auto flux =
            convolve_mirrored(paper_intensities(method, lambda), sun_kernel(SunKernel::disc));
        for (std::size_t i = 0; i < flux.size(); ++i)
            buckets[i] = buckets[i] + (*daylight)(lambda)*flux[i] * colour;
    }
    Row pixels;
    for (int x = 0; x < kWidth; ++x)
        pixels.push_back(
            map_gamut(rgb_from_xyz<LinearSrgb>(buckets[std::size_t(angle_of(x) / kPaperBucket)]),
                      GamutMapping::towards_white));
    return {std::move(label), pixels};
}

std::vector<Strip> strips() {
    PaperMethod published, point, jittered;
    point.kernel = SunKernel::none;
    jittered.jitter_wavelengths = true;
    return {rings("13 fogs", {}),
            rings("jittered", {2.0, true}),
            table("table, point sun", point),
            table("table, 5 entries", published),
            table("λ jittered", jittered),
            table("all corrected", paper_method_corrected()),
            as_seen("in CIE colours")};
}

/// Each strip exposed so that its brightest channel is 1.
Image8 picture_of(const std::vector<Strip>& strips) {
    Image8 image;
    image.width = kWidth, image.height = int(strips.size()) * (kStripHeight + kGap) - kGap;
    image.rgb.assign(std::size_t(3 * image.width * image.height), 255);
    for (std::size_t s = 0; s < strips.size(); ++s) {
        double brightest = 0.0;
        for (const auto& colour : strips[s].pixels)
            brightest = std::max(brightest, *std::max_element(colour.v.begin(), colour.v.end()));
        for (int y = 0; y < kStripHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                for (std::size_t c = 0; c < 3; ++c) {
                    const std::size_t line = s * (kStripHeight + kGap) + std::size_t(y);
                    const double value = strips[s].pixels[std::size_t(x)][c] / brightest;
                    image.rgb[3 * (line * kWidth + std::size_t(x)) + c] =
                        static_cast<std::uint8_t>(std::lround(255.0 * srgb_encode(value)));
                }
    }
    return image;
}

}  // namespace

std::string draw_paper(RainbowTables&, const std::string& ending) {
    const std::vector<Strip> all = strips();
    const Image8 image = picture_of(all);
    const std::string png = encode_png(
        image, {{"dewbow:content", "the rainbows of Musgrave 1989, angle to the right"}});
    if (ending == ".png") return png;

    PlotPanel panel;
    panel.title = "The rainbows of Musgrave 1989";
    panel.x = {"angle from the antisolar point (°)", kFrom_deg, kTo_deg};
    panel.y = {"", double(image.height), 0.0, false, /*ticks=*/false};
    panel.picture = PlotPicture{png, kFrom_deg, kTo_deg, double(image.height), 0.0};
    panel.width = kWidth + 260.0, panel.height = image.height + 120.0;
    // A curve without points that are seen, for the label at its end.
    for (std::size_t s = 0; s < all.size(); ++s) {
        const double y = double(s) * (kStripHeight + kGap) + 0.5 * kStripHeight;
        panel.curves.push_back({all[s].label, "#333333", {{kTo_deg - 0.01, y}, {kTo_deg, y}}});
    }
    return svg_of({&panel, 1});
}

}  // namespace dewbow
