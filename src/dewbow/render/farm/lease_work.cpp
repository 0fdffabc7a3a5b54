// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/farm/lease_work.h"

#include <algorithm>
#include <chrono>
#include <set>

#include "dewbow/base/error.h"
#include "dewbow/base/parallel.h"

namespace dewbow {

namespace {

PixelRect tile_of(const UnitPlan& plan, const UnitRun& run) { return plan.unit(0, run.tile).tile; }

std::size_t bytes_of_tile(const PixelRect& tile, int bins) {
    return static_cast<std::size_t>(tile.area()) * FilmSums::bytes_per_pixel(bins);
}

/// What a thread brings back of one run.
struct Piece {
    UnitRun done;
    std::string pixels;
    InvalidSamples invalid;
};

Piece render_run(UnitRun run, const Estimator& estimator, const UnitPlan& plan, FilmLayout layout,
                 const std::function<bool()>& stopped) {
    layout.crop = tile_of(plan, run);
    FilmSums film(layout);
    std::uint64_t pass = run.first_pass;
    for (; pass < run.end_pass && !stopped(); ++pass)
        estimator.render(plan.unit(pass, run.tile), film);
    Piece piece{{run.tile, run.first_pass, pass}, {}, film.invalid()};
    if (piece.done.units() > 0) film.append_pixels(layout.crop, piece.pixels);
    return piece;
}

/// Throws InputError unless the result's units are open units of the plan, each once, and its
/// pixels are as many as they must be.
void check_result(const message::Result& result, const UnitPlan& plan, int bins) {
    const auto refuse = [] {
        throw InputError("a rank sent sums of units that it was not asked for");
    };
    std::size_t bytes = 0;
    std::set<std::pair<std::uint64_t, std::uint64_t>> units;
    for (const UnitRun& run : result.lease.runs) {
        if (run.tile >= plan.tiles() || run.end_pass > plan.passes()) refuse();
        bytes += bytes_of_tile(tile_of(plan, run), bins);
        for (std::uint64_t pass = run.first_pass; pass < run.end_pass; ++pass)
            if (plan.finished(pass, run.tile) || !units.emplace(pass, run.tile).second) refuse();
    }
    if (bytes != result.pixels.size()) refuse();
}

}  // namespace

message::Result render_lease(const Lease& lease, const Estimator& estimator, const UnitPlan& plan,
                             const FilmLayout& layout, const std::function<bool()>& stopped) {
    const auto start = std::chrono::steady_clock::now();
    std::vector<Piece> pieces(lease.runs.size());
    parallel_for(lease.runs.size(), [&](std::size_t i) {
        pieces[i] = render_run(lease.runs[i], estimator, plan, layout, stopped);
    });
    message::Result result{{lease.number, {}}, {}, {}, 0.0};
    for (const Piece& piece : pieces) {
        if (piece.done.units() == 0) continue;
        result.lease.runs.push_back(piece.done);
        result.pixels += piece.pixels;
        result.invalid.add(piece.invalid);
    }
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

void add_result(const message::Result& result, UnitPlan& plan, FilmSums& film) {
    check_result(result, plan, film.spectral_bins());
    std::string_view pixels = result.pixels;
    for (const UnitRun& run : result.lease.runs) {
        const PixelRect tile = tile_of(plan, run);
        const std::size_t size = bytes_of_tile(tile, film.spectral_bins());
        film.add_pixels(tile, pixels.substr(0, size));
        pixels.remove_prefix(size);
        for (std::uint64_t pass = run.first_pass; pass < run.end_pass; ++pass)
            plan.set_finished(pass, run.tile);
    }
    film.add_invalid(result.invalid);
}

}  // namespace dewbow
