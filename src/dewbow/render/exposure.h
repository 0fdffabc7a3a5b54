// SPDX-License-Identifier: Apache-2.0
#pragma once

// The exposure of a picture whose scene states none.

#include "dewbow/render/film.h"

namespace dewbow {

/// The exposure in stops, to a quarter of one, at which nine tenths of the pixels lie below 0.7 of
/// white. 0 of a black picture. A function of the film alone.
double automatic_exposure(const FilmSums& film, const Film& settings);

/// The exposure to show `film` at, by the mode of `settings`.
double exposure_of(const FilmSums& film, const Film& settings);

}  // namespace dewbow
