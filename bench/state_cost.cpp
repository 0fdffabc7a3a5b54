// SPDX-License-Identifier: Apache-2.0

// What share of a render do the exact film and the bookkeeping of units take?
//
//     bench_state_cost scene [SAMPLES_PER_PIXEL [WIDTH HEIGHT [ESTIMATOR]]]
//
// The estimator is run unit by unit on one thread, as a session does, and samples are kept.
// Then all that is not the estimator's is done again with those samples: a film for the unit,
// adding its samples, handing it in; and adding the samples to one film without units, so that the
// difference is what units cost. Last, each tile is copied as a checkpoint does under its lock.
// Light units are traced, and their splats handed in. Processor time of the thread.

#include <time.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "dewbow/base/error.h"
#include "dewbow/import/import.h"
#include "dewbow/render/live_state.h"
#include "dewbow/render/session.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow::bench {
namespace {

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

struct Place {
    int x, y;
    std::int64_t index;
};

/// A unit's samples, of which so many are kept as fit into the first cache, where a render has the
/// one that it adds: a different one each time, and of the whole unit in turn.
struct Kept {
    static constexpr std::size_t kSamples = 32;
    std::vector<Place> places;
    std::vector<PixelSample> samples;
    void keep(int x, int y, const PixelSample& sample, std::int64_t index) {
        if (places.size() % 32 == 0 && samples.size() < kSamples) samples.push_back(sample);
        places.push_back({x, y, index});
    }
    /// The colours alone, which a film of floats would need too.
    double colours() const {
        double sum = 0.0;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const PixelSample& sample = samples[i % samples.size()];
            const auto lanes = std::size_t(sample.wavelengths.count);
            sum += xyz_from_lanes(sample.wavelengths, {sample.radiance.data(), lanes})[1];
        }
        return sum;
    }
    void add_to(FilmSums& film) const {
        for (std::size_t i = 0; i < places.size(); ++i)
            film.add(places[i].x, places[i].y, samples[i % samples.size()], places[i].index);
    }
};

FilmSums film_of(const Unit& unit, FilmLayout layout) {
    layout.crop = unit.tile;
    return FilmSums(layout);
}

struct Costs {
    double estimator_s = 0.0, colours_s = 0.0, luminance = 0.0, film_s = 0.0, units_s = 0.0,
           copy_s = 0.0, longest_copy_s = 0.0, light_s = 0.0, splats_s = 0.0;
    std::size_t units = 0, light_paths = 0, splats = 0;
};

void measure_light_unit(const Estimator& estimator, RenderState& state, LiveState& live,
                        std::size_t pass, std::size_t number, Costs& costs) {
    const LightUnit unit = state.plan.light_unit(pass, number);
    double start = cpu_seconds();
    SplatList splats(state.film.layout());
    estimator.trace_light(unit, splats);
    costs.light_s += cpu_seconds() - start;
    start = cpu_seconds();
    live.hand_in(pass, pass + 1, number, splats);
    costs.splats_s += cpu_seconds() - start;
    costs.light_paths += unit.paths();
    costs.splats += splats.splats().size();
}

void print_light(const Costs& costs) {
    if (costs.light_paths == 0) return;
    const auto paths = double(costs.light_paths), splats = double(costs.splats);
    std::printf(
        "light path: %.2f us, %.2f splats; handing in: %.1f ns a splat, %.2f %% of tracing\n",
        1e6 * costs.light_s / paths, splats / paths, 1e9 * costs.splats_s / splats,
        100.0 * costs.splats_s / costs.light_s);
}

void measure_unit(const Estimator& estimator, RenderState& state, LiveState& live, FilmSums& plain,
                  std::size_t pass, std::size_t tile, Costs& costs) {
    const Unit unit = state.plan.unit(pass, tile);
    Kept kept;
    {
        FilmSums part = film_of(unit, state.film.layout());
        const double start = cpu_seconds();
        estimator.render(unit, part);
        costs.estimator_s += cpu_seconds() - start;
    }
    {
        FilmSums part = film_of(unit, state.film.layout());
        part.observe([&](int x, int y, const PixelSample& sample, std::int64_t index) {
            kept.keep(x, y, sample, index);
        });
        estimator.render(unit, part);
    }
    double start = cpu_seconds();
    costs.luminance += kept.colours();
    costs.colours_s += cpu_seconds() - start;

    start = cpu_seconds();
    kept.add_to(plain);
    costs.film_s += cpu_seconds() - start;

    start = cpu_seconds();
    FilmSums part = film_of(unit, state.film.layout());
    kept.add_to(part);
    if (!live.finished(pass, tile)) live.hand_in(pass, pass + 1, tile, part);
    costs.units_s += cpu_seconds() - start;
    ++costs.units;

    start = cpu_seconds();
    std::string bytes;
    state.film.append_pixels(unit.tile, bytes);
    const double copy = cpu_seconds() - start;
    costs.copy_s += copy;
    costs.longest_copy_s = std::max(costs.longest_copy_s, copy);
}

const EstimatorRow& find_row(const std::string& name) {
    for (const EstimatorRow& row : estimators())
        if (row.name == name) return row;
    throw InputError("there is no estimator " + name);
}

int run(int argc, char** argv) {
    if (argc < 2) return 2;
    LoadOptions load;
    if (argc > 4) load.width = std::atoi(argv[3]), load.height = std::atoi(argv[4]);
    Scene scene = load_scene(argv[1], load).scene;
    if (argc > 2) scene.render.samples_per_pixel = std::atoi(argv[2]);
    const EstimatorRow& row = find_row(argc > 5 ? argv[5] : "path");
    const auto estimator = row.make(scene);
    RenderState state(render_identity(scene, {}, row, 0, estimator->light_paths()));
    LiveState live(state);
    FilmSums plain = make_film(scene, {});
    Costs costs;
    for (std::size_t pass = 0; pass < state.plan.passes(); ++pass) {
        for (std::size_t tile = 0; tile < state.plan.tiles(); ++tile)
            measure_unit(*estimator, state, live, plain, pass, tile, costs);
        for (std::size_t unit = state.plan.tiles(); unit < state.plan.units_per_pass(); ++unit)
            measure_light_unit(*estimator, state, live, pass, unit, costs);
    }
    const double render_s = costs.estimator_s, all = render_s + (costs.units_s - costs.film_s);
    std::printf("render %.3f s, of which colours %.4f s, film %.4f s (sum of Y %.3g)\n", all,
                costs.colours_s, costs.film_s, costs.luminance);
    std::printf("integers and units: %.2f %% of the render; units alone %.2f %%, %.1f us each\n",
                100.0 * (costs.units_s - costs.colours_s) / all,
                100.0 * (costs.units_s - costs.film_s) / all,
                1e6 * (costs.units_s - costs.film_s) / double(costs.units));
    std::printf("copy of a tile: mean %.1f us, longest %.1f us\n",
                1e6 * costs.copy_s / double(costs.units), 1e6 * costs.longest_copy_s);
    print_light(costs);
    return 0;
}

}  // namespace
}  // namespace dewbow::bench

int main(int argc, char** argv) { return dewbow::bench::run(argc, argv); }
