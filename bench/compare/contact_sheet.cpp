// SPDX-License-Identifier: Apache-2.0
#include "contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dewbow/spectrum/display.h"
#include "small_letters.h"

namespace dewbow::bench {
namespace {

constexpr int kColumns = 6, kGap = 8, kLine = kLetterHeight + 3, kCaptionLines = 3;
constexpr std::uint8_t kPaper = 40, kInk = 220;
/// Cells are at least as wide as this: room for captions.
constexpr int kLeastCell = 192;

/// Small pictures are shown larger.
int scale_of(const Picture& picture) { return std::max(1, kLeastCell / picture.width); }

struct Cell {
    const Picture* picture;
    std::vector<std::string> caption;
};

std::vector<Cell> cells_of(const Measurements& all, const SceneFacts& scene) {
    std::vector<Cell> cells{{&scene.truth, {scene.name + ": truth"}}};
    for (const Result& result : all.results) {
        if (result.scene != scene.name || result.picture.pixels.empty()) continue;
        cells.push_back({&result.picture,
                         {result.contestant, label_of("", result.knobs).substr(2),
                          fmt::format("{:.3g} s, rmse {:.2g}", result.cpu_s,
                                      std::sqrt(result.over("whole").truth.mse))}});
    }
    return cells;
}

std::uint8_t code_value(double linear) {
    const double shown = std::isfinite(linear) ? std::clamp(linear, 0.0, 1.0) : 0.0;
    return std::uint8_t(std::lround(255.0 * srgb_encode(shown)));
}

/// Each pixel a square of `scale` pixels.
void put_picture(Image8& sheet, const Picture& picture, int scale, int left, int top) {
    for (int y = 0; y < picture.height * scale; ++y)
        for (int x = 0; x < picture.width * scale; ++x) {
            const auto& pixel = picture.pixels[std::size_t(y / scale * picture.width + x / scale)];
            const auto at = 3 * std::size_t((top + y) * sheet.width + left + x);
            for (std::size_t c = 0; c < 3; ++c) sheet.rgb[at + c] = code_value(pixel[c]);
        }
}

}  // namespace

Image8 contact_sheet(const Measurements& all) {
    int cell_width = kLeastCell, cell_height = 0;
    std::vector<std::vector<Cell>> scenes;
    for (const SceneFacts& scene : all.scenes) {
        scenes.push_back(cells_of(all, scene));
        cell_width = std::max(cell_width, scene.truth.width);
        cell_height = std::max(cell_height,
                               scene.truth.height * scale_of(scene.truth) + kCaptionLines * kLine);
    }
    const auto rows_of = [](const std::vector<Cell>& cells) {
        return (int(cells.size()) + kColumns - 1) / kColumns;
    };
    const int width = kGap + kColumns * (cell_width + kGap);
    int height = kGap;
    for (const auto& cells : scenes) height += rows_of(cells) * (cell_height + kGap);
    Image8 sheet{width, height, {}};
    sheet.rgb.assign(std::size_t(width) * std::size_t(height) * 3, kPaper);
    int top = kGap;
    for (const auto& cells : scenes) {
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const int left = kGap + int(i) % kColumns * (cell_width + kGap);
            const int y = top + int(i) / kColumns * (cell_height + kGap);
            const Picture& picture = *cells[i].picture;
            put_picture(sheet, picture, scale_of(picture), left, y);
            for (std::size_t line = 0; line < cells[i].caption.size(); ++line)
                put_letters(sheet, cells[i].caption[line], left,
                            y + picture.height * scale_of(picture) + 2 + int(line) * kLine, kInk);
        }
        top += rows_of(cells) * (cell_height + kGap);
    }
    return sheet;
}

}  // namespace dewbow::bench
