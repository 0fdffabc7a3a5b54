// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/farm/lease_work.h"

#include <chrono>
#include <set>
#include <utility>

#include "dewbow/base/error.h"
#include "dewbow/base/parallel.h"

namespace dewbow {

namespace {

using message::Piece;

/// An empty film of the run's tile.
FilmSums tile_film(const UnitRun& run, const UnitPlan& plan, FilmLayout layout) {
    layout.crop = plan.unit(0, run.number).tile;
    return FilmSums(layout);
}

Piece render_tile(UnitRun run, const Estimator& estimator, const UnitPlan& plan,
                  const FilmLayout& layout, const std::function<bool()>& stopped) {
    FilmSums film = tile_film(run, plan, layout);
    std::uint64_t pass = run.first_pass;
    for (; pass < run.end_pass && !stopped(); ++pass)
        estimator.render(plan.unit(pass, run.number), film);
    Piece piece{{run.number, run.first_pass, pass}, {}, film.invalid()};
    if (piece.run.units() > 0) film.append_pixels(film.crop(), piece.sums);
    return piece;
}

Piece trace_light(UnitRun run, const Estimator& estimator, const UnitPlan& plan,
                  const FilmLayout& layout, const std::function<bool()>& stopped) {
    SplatList splats(layout);
    std::uint64_t pass = run.first_pass;
    for (; pass < run.end_pass && !stopped(); ++pass)
        estimator.trace_light(plan.light_unit(pass, run.number), splats);
    Piece piece{{run.number, run.first_pass, pass}, {}, {0, {}, splats.invalid()}};
    if (piece.run.units() > 0) splats.append_bytes(piece.sums);
    return piece;
}

}  // namespace

message::Result render_lease(const Lease& lease, const Estimator& estimator, const UnitPlan& plan,
                             const FilmLayout& layout, const std::function<bool()>& stopped) {
    const auto start = std::chrono::steady_clock::now();
    message::Result result{lease.number, std::vector<Piece>(lease.runs.size()), 0.0};
    parallel_for(lease.runs.size(), [&](std::size_t i) {
        const UnitRun& run = lease.runs[i];
        const auto& finish = plan.is_light(run.number) ? trace_light : render_tile;
        result.pieces[i] = finish(run, estimator, plan, layout, stopped);
    });
    std::erase_if(result.pieces, [](const Piece& piece) { return piece.run.units() == 0; });
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

void check_pieces(const message::Result& result, const UnitPlan& plan, const FilmLayout& layout) {
    const auto check = [](bool holds) {
        if (!holds) throw InputError("it sent sums of other units than it was asked for");
    };
    const std::size_t pixel_bytes = FilmSums::bytes_per_pixel(layout.spectral_bins);
    std::set<std::pair<std::uint64_t, std::uint64_t>> units;
    for (const Piece& piece : result.pieces) {
        const UnitRun& run = piece.run;
        check(run.number < plan.units_per_pass() && run.end_pass <= plan.passes());
        if (plan.is_light(run.number)) {
            check(piece.invalid.splats >= 0);
            static_cast<void>(SplatList::from_bytes(layout, piece.sums));
        } else {
            const auto area = static_cast<std::size_t>(plan.unit(0, run.number).tile.area());
            check(piece.sums.size() == area * pixel_bytes);
        }
        for (std::uint64_t pass = run.first_pass; pass < run.end_pass; ++pass)
            check(!plan.finished(pass, run.number) && units.emplace(pass, run.number).second);
    }
}

std::size_t add_pieces(const message::Result& result, const UnitPlan& plan,
                       const FilmLayout& layout, LiveState& to) {
    std::size_t units = 0;
    for (const Piece& piece : result.pieces) {
        const UnitRun& run = piece.run;
        if (plan.is_light(run.number)) {
            SplatList splats = SplatList::from_bytes(layout, piece.sums);
            splats.add_invalid(piece.invalid.splats);
            to.hand_in(run.first_pass, run.end_pass, run.number, splats);
        } else {
            FilmSums film = tile_film(run, plan, layout);
            film.add_pixels(film.crop(), piece.sums);
            film.add_invalid(piece.invalid);
            to.hand_in(run.first_pass, run.end_pass, run.number, film);
        }
        units += piece.run.units();
    }
    return units;
}

}  // namespace dewbow
