// SPDX-License-Identifier: Apache-2.0

// The Lee diagram: colours by angle and drop size.

#include <fmt/format.h>

#include <cmath>

#include "dewbow/base/error.h"
#include "dewbow/export/plot.h"
#include "dewbow/image/png.h"
#include "dewbow/rainbow/lee_table.h"
#include "rainbow_bow.h"
#include "rainbow_degrees.h"
#include "rainbow_plots.h"

namespace dewbow {
namespace {

constexpr Length kSmallest = 10.0 * unit::um, kLargest = 1.0 * unit::mm;
constexpr int kRadii = 200;
/// Around the antisolar point.
struct Part {
    const char* title;
    double from_deg, to_deg;
};
constexpr Part kParts[] = {{"primary bow", 32.0, 44.0}, {"secondary bow", 49.0, 61.0}};
constexpr double kStep_deg = 0.02;
constexpr double kPanelWidth = 560.0, kPanelHeight = 510.0;

std::vector<Angle> angles_of(const Part& part) {
    std::vector<Angle> angles;
    for (const double degrees : stepped(180.0 - part.to_deg, 180.0 - part.from_deg, kStep_deg))
        angles.push_back(degrees * unit::deg);
    return angles;
}

std::vector<Length> radii() {
    std::vector<Length> all;
    for (int k = 0; k < kRadii; ++k)
        all.push_back(kSmallest * std::pow(kLargest.to(kSmallest), (k + 0.5) / kRadii));
    return all;
}

/// The part of a Lee table that is of one radius. All wavelengths count as scattered alike: rows
/// are as bright as each other anyway.
ScatteringTable table_at(const LeeTable& lee, std::size_t radius) {
    ScatteringTable table;
    table.angles = lee.angles;
    table.wavelengths = lee.wavelengths;
    const std::size_t size = lee.angles.size() * lee.wavelengths.size();
    const auto first = lee.phase.begin() + std::ptrdiff_t(radius * size);
    table.phase.assign(first, first + std::ptrdiff_t(size));
    table.efficiencies.assign(lee.wavelengths.size(), {1.0, 1.0, 0.0});
    return table;
}

/// Rows are as bright as they can be, the secondary bow's too; tolerances are of the primary's
/// peak.
constexpr double kFinerThanTheRow = 4.0;

/// By auto, of drops that differ by 5 % in each row.
std::vector<BowColours> automatic_bows(const RainbowSetup& setup, const TableRequest& request) {
    LeeRequest lee;
    lee.radii = radii();
    lee.tolerance = request.tolerance / kFinerThanTheRow;
    lee.optics = request.optics;
    lee.wavelengths = request.wavelengths;
    lee.angles = request.angles;
    lee.disc = request.disc;
    const LeeTable table = make_lee_table(lee);
    std::vector<BowColours> bows;
    for (std::size_t k = 0; k < table.radii.size(); ++k)
        bows.push_back(bow_colours(table_at(table, k), *setup.light, *setup.white));
    return bows;
}

std::vector<BowColours> bows_of(const RainbowSetup& setup, const std::vector<Angle>& angles) {
    TableRequest request = setup.request_for(setup.models.front(), visible_wavelengths(), angles);
    if (request.model == "auto" && request.orders.empty()) return automatic_bows(setup, request);
    std::vector<BowColours> bows;
    for (const Length radius : radii()) {
        request.sizes = single_drop_size(radius);
        bows.push_back(bow_colours(make_scattering_table(request), *setup.light, *setup.white));
    }
    return bows;
}

Image8 side_by_side(const std::vector<Image8>& images) {
    Image8 all{0, images.front().height, {}};
    for (const Image8& image : images) all.width += image.width;
    for (int y = 0; y < all.height; ++y)
        for (const Image8& image : images) {
            const auto row = image.rgb.begin() + std::ptrdiff_t(3) * y * image.width;
            all.rgb.insert(all.rgb.end(), row, row + std::ptrdiff_t(3) * image.width);
        }
    return all;
}

}  // namespace

std::string draw_lee(RainbowTables& tables, const std::string& ending) {
    const RainbowSetup& setup = tables.setup();
    if (!setup.storm.sizes.empty())
        throw InputError("a Lee diagram shows drops of 10 µm to 1 mm; no radius or sizes count");
    std::vector<Part> parts(std::begin(kParts), std::end(kParts));
    const std::vector<Angle>& asked = setup.request.angles;
    if (asked.size() == 1) throw InputError("a Lee diagram needs two angles or more");
    if (!asked.empty())
        parts = {{"", 180.0 - degrees_of(asked.back()), 180.0 - degrees_of(asked.front())}};

    std::vector<Image8> images;
    std::vector<PlotPanel> panels;
    for (const Part& part : parts) {
        const LeeView view{part.from_deg * unit::deg, part.to_deg * unit::deg};
        images.push_back(lee_picture(bows_of(setup, angles_of(part)), look_of(setup).shares, view,
                                     *setup.white));
        PlotPanel panel;
        panel.title = fmt::format("{} {}", setup.models.front(), part.title);
        panel.x = {"angle from the antisolar point (°)", part.from_deg, part.to_deg};
        panel.y = {"radius of the drops (µm)", kSmallest.to(unit::um), kLargest.to(unit::um), true};
        panel.picture = PlotPicture{encode_png(images.back(), {}), panel.x.from, panel.x.to,
                                    panel.y.from, panel.y.to};
        panel.width = kPanelWidth;
        panel.height = kPanelHeight;
        panels.push_back(std::move(panel));
    }
    if (ending == ".svg") return svg_of(panels);
    return encode_png(side_by_side(images), setup.facts());
}

}  // namespace dewbow
