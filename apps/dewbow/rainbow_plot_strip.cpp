// SPDX-License-Identifier: Apache-2.0

// Colours by the angle from the antisolar point.

#include <fmt/format.h>

#include "dewbow/base/error.h"
#include "dewbow/export/plot.h"
#include "dewbow/image/png.h"
#include "rainbow_bow.h"
#include "rainbow_degrees.h"
#include "rainbow_plots.h"

namespace dewbow {
namespace {

constexpr double kPanelHeight = 230.0;

std::string title_of(const RainbowSetup& setup) {
    return fmt::format("{}, {}", setup.drops, setup.models.front());
}

}  // namespace

std::string draw_strip(RainbowTables& tables, const std::string& ending) {
    const RainbowSetup& setup = tables.setup();
    const BowAround bow = bow_of(tables, around_the_bows());
    const std::vector<Angle>& angles = bow.colours.front().angles;
    if (angles.size() < 2) throw InputError("a strip of colours needs two angles or more");
    StripView view;
    view.left = 180.0 * unit::deg - angles.back();
    view.right = 180.0 * unit::deg - angles.front();
    view.clock = setup.storm.clock_angle.value_or(Angle{});
    const DisplaySettings settings = display_of(bow, view.left, view.right, setup);
    const Image8 image = strip_picture(bow, look_of(setup), view, settings);
    const std::string png = encode_png(image, picture_facts(setup, settings));
    if (ending == ".png") return png;

    PlotPanel panel;
    panel.title = title_of(setup);
    panel.x = {"angle from the antisolar point (°)", degrees_of(view.left), degrees_of(view.right)};
    panel.y = {"", 0.0, 1.0, false, /*ticks=*/false};
    panel.picture = PlotPicture{png, panel.x.from, panel.x.to, 0.0, 1.0};
    panel.width = view.width + 100.0;
    panel.height = kPanelHeight;
    return svg_of({&panel, 1});
}

}  // namespace dewbow
