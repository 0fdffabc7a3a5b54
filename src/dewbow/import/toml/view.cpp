// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/view.h"

#include <fmt/format.h>

#include <array>
#include <limits>

#include "dewbow/import/toml/caustics.h"
#include "dewbow/import/toml/distributed_1989.h"
#include "dewbow/import/toml/rain_settings.h"

namespace dewbow::toml_import {
namespace {

constexpr Range kFilterRadiusRange{0.1, 16.0};
constexpr Range kExposureRange{-100.0, 100.0};
constexpr Range kLuminanceRange{1e-9, kHuge};
constexpr std::int64_t kMaxSide = 65536;
constexpr std::int64_t kMaxInt = std::numeric_limits<int>::max();
constexpr std::int64_t kMaxSeed = std::numeric_limits<std::int64_t>::max();

const std::array<std::string, 3> kFilterNames = {"box", "gaussian", "blackman-harris"};
constexpr std::array kFilterKinds = {FilterKind::box, FilterKind::gaussian,
                                     FilterKind::blackman_harris};
const std::array<std::string, 1> kExposureWords = {"auto"};
const std::array<std::string, 2> kSamplingNames = {"visual", "uniform"};

PixelFilter read_filter(Table& table) {
    PixelFilter filter;
    if (const TomlValue* name = table.find("filter")) {
        filter.kind = kFilterKinds[read_choice(table.document(), *name, "filter", kFilterNames)];
    }
    if (filter.kind == FilterKind::box) filter.radius = 0.5;
    filter.radius = table.number("filter_radius_px", kFilterRadiusRange, filter.radius);
    return filter;
}

/// A number of stops, or "auto".
void read_exposure(Table& table, Film& film) {
    const TomlValue* value = table.find("exposure_stops");
    if (!value) return;
    if (value->text()) {
        read_choice(table.document(), *value, "exposure_stops", kExposureWords);
        film.exposure = ExposureMode::automatic;
        return;
    }
    film.exposure_stops = read_number(table.document(), *value, "exposure_stops", kExposureRange);
}

int read_packet(Table& table, int otherwise) {
    const TomlValue* value = table.find("packet");
    if (!value) return otherwise;
    const auto lanes = read_integer(table.document(), *value, "packet", 1, 16);
    if (lanes != 1 && lanes != 4 && lanes != 8 && lanes != 16) {
        fail(table.document(), value->place,
             fmt::format("packet is {}; it must be 1, 4, 8 or 16", lanes));
    }
    return int(lanes);
}

}  // namespace

void read_film(const TomlDocument& document, const TomlValue* value, Film& film) {
    if (!value) return;
    Table table(document, *value, "[film]");
    film.width = int(table.integer("width", 1, kMaxSide, film.width));
    film.height = int(table.integer("height", 1, kMaxSide, film.height));
    film.filter = read_filter(table);
    read_exposure(table, film);
    film.white_luminance =
        table.number("white_luminance_cd_m2", kLuminanceRange, film.white_luminance);
    film.spectral_bins =
        int(table.integer("spectral_bins", 0, kMostSpectralBins, film.spectral_bins));
    table.finish();
}

void read_render(const TomlDocument& document, const TomlValue* value, RenderSettings& settings) {
    if (!value) return;
    Table table(document, *value, "[render]");
    settings.samples_per_pixel =
        int(table.integer("samples_per_pixel", 1, kMostSamples, settings.samples_per_pixel));
    settings.seed = std::uint64_t(table.integer("seed", 0, kMaxSeed, std::int64_t(settings.seed)));
    settings.packet = read_packet(table, settings.packet);
    if (const TomlValue* name = table.find("wavelengths")) {
        const auto which = read_choice(document, *name, "wavelengths", kSamplingNames);
        settings.wavelengths =
            which == 0 ? WavelengthSampling::visual : WavelengthSampling::uniform;
    }
    settings.max_depth = int(table.integer("max_depth", 0, kMostDepth, settings.max_depth));
    settings.roulette_depth =
        int(table.integer("roulette_depth", 0, kMaxInt, settings.roulette_depth));
    read_distributed_1989(document, table.find("distributed_1989"), settings.distributed_1989);
    read_caustics(document, table.find("caustics"), settings.caustics);
    read_rain_settings(document, table.find("rain"), settings.rain);
    table.finish();
}

}  // namespace dewbow::toml_import
