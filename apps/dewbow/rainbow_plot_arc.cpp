// SPDX-License-Identifier: Apache-2.0

// The bow in the sky.

#include <fmt/format.h>

#include "console.h"
#include "dewbow/export/plot.h"
#include "dewbow/image/png.h"
#include "rainbow_bow.h"
#include "rainbow_degrees.h"
#include "rainbow_plots.h"

namespace dewbow {
namespace {

/// What the picture shows of the sky, above the horizon and around the antisolar point.
constexpr Angle kHalfWidth = 62.0 * unit::deg, kTop = 60.0 * unit::deg, kGround = 4.0 * unit::deg;
constexpr int kWidth = 800;
/// The bows, and not the glory around the antisolar point.
constexpr Angle kExposedFrom = 25.0 * unit::deg, kExposedTo = 65.0 * unit::deg;

SkyView view_of(Angle sun_altitude) {
    SkyView view;
    view.sun_altitude = sun_altitude;
    view.half_width = kHalfWidth;
    view.top = kTop;
    view.width = kWidth;
    const double up = (kTop - sun_altitude + kGround).to(2.0 * kHalfWidth);
    view.height = static_cast<int>(std::max(up, 0.1) * kWidth);
    return view;
}

/// What lies nearer to the antisolar point than the horizon is not seen; there the glory costs
/// most.
Angle nearest_seen(Angle sun_altitude) { return std::min(sun_altitude, kExposedFrom); }

}  // namespace

std::string draw_arc(RainbowTables& tables, const std::string& ending) {
    const RainbowSetup& setup = tables.setup();
    const BowAround bow = bow_all_around(tables, half_the_sky(nearest_seen(setup.sun_altitude)));
    const SkyView view = view_of(setup.sun_altitude);
    const DisplaySettings settings = display_of(bow, kExposedFrom, kExposedTo, setup);
    const Image8 image = sky_picture(bow, look_of(setup), view, settings);
    const std::string png = encode_png(image, picture_facts(setup, settings));
    if (ending == ".png") return png;

    const double half = degrees_of(kHalfWidth), top = degrees_of(kTop);
    PlotPanel panel;
    panel.title = fmt::format("{}, {}, sun {:g}° high", setup.drops, setup.models.front(),
                              degrees_of(setup.sun_altitude));
    panel.x = {"angle from the antisolar point (°)", -half, half};
    panel.y = {"(°)", top - 2.0 * half * view.height / view.width, top};
    panel.picture = PlotPicture{png, panel.x.from, panel.x.to, panel.y.from, panel.y.to};
    panel.width = view.width + 100.0;
    panel.height = view.height + 110.0;
    return svg_of({&panel, 1});
}

}  // namespace dewbow
