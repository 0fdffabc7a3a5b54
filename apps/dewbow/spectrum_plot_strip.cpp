// SPDX-License-Identifier: Apache-2.0

// What the spectrum looks like.

#include <algorithm>

#include "dewbow/image/png.h"
#include "spectrum_output.h"
#include "spectrum_plots.h"

namespace dewbow {
namespace {

constexpr int kWidth = 960, kHeight = 120;
constexpr double kPanelHeight = 230.0, kPanelMargin = 100.0;

Image8 picture_of(const SpectrumSetup& setup) {
    Image8 image{kWidth, kHeight, std::vector<std::uint8_t>(std::size_t(3 * kWidth * kHeight))};
    // Middles of the columns.
    const std::vector<double> f = setup.steps(2 * kWidth);
    for (int x = 0; x < kWidth; ++x) {
        const auto codes = setup.shown(f[std::size_t(2 * x + 1)]);
        for (int y = 0; y < kHeight; ++y)
            std::copy(codes.begin(), codes.end(), image.rgb.begin() + 3 * (y * kWidth + x));
    }
    return image;
}

}  // namespace

std::string draw_spectrum_strip(const SpectrumSetup& setup, const std::string& ending) {
    const std::string png = encode_png(picture_of(setup), spectrum_facts(setup));
    if (ending == ".png") return png;
    PlotPanel panel;
    panel.title = setup.title();
    panel.x = setup.axis();
    panel.y = {"", 0.0, 1.0, false, /*ticks=*/false};
    panel.picture = PlotPicture{png, panel.x.from, panel.x.to, 0.0, 1.0};
    panel.width = kWidth + kPanelMargin;
    panel.height = kPanelHeight;
    return svg_of({&panel, 1});
}

}  // namespace dewbow
