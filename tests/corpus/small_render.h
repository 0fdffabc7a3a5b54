// SPDX-License-Identifier: Apache-2.0
#pragma once

// Whole files, rendered small.

#include <gtest/gtest.h>

#include <filesystem>

#include "dewbow/import/import.h"
#include "dewbow/render/estimator_choice.h"
#include "dewbow/render/session.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow::corpus {

struct SmallPicture {
    ImportedScene imported;
    FilmSums film;

    Colour<LinearSrgb> rgb(int x, int y) const {
        const double white = imported.scene.film.white_luminance /
                             Film{}.white_luminance;  // radiance of the film's white
        return rgb_from_xyz<LinearSrgb>(film.xyz(x, y)) * (1.0 / white);
    }
    Colour<LinearSrgb> albedo(int x, int y) const {
        return rgb_from_xyz<LinearSrgb>(film.albedo(x, y));
    }
    /// Share of the pixels for which `holds(x, y)`.
    template <class Holds>
    double share(Holds&& holds) const {
        int count = 0;
        for (int y = 0; y < film.height(); ++y)
            for (int x = 0; x < film.width(); ++x) count += holds(x, y) ? 1 : 0;
        return double(count) / (film.width() * film.height());
    }
};

/// Expects that no sample is invalid.
inline SmallPicture render_small(const std::filesystem::path& file, int width, int height,
                                 int samples, LoadOptions options = {}) {
    options.width = width, options.height = height;
    ImportedScene imported = load_scene(file, options);
    imported.scene.film.spectral_bins = 0;
    imported.scene.render.samples_per_pixel = samples;
    FilmSums film = make_film(imported.scene, {});
    const SessionResult result =
        run_session(imported.scene, *choose_estimator(imported.scene).estimator, {}, film);
    EXPECT_EQ(result.invalid_samples, 0) << file;
    return {std::move(imported), std::move(film)};
}

}  // namespace dewbow::corpus
