// SPDX-License-Identifier: Apache-2.0
#pragma once

// From the film to picture files.

#include <filesystem>

#include "dewbow/image/image.h"
#include "dewbow/render/session.h"
#include "dewbow/spectrum/display.h"

namespace dewbow {

/// The picture of the crop: R, G, B, A (linear sRGB; 1 = the film's white luminance), the layers
/// albedo.R, albedo.G, albedo.B, normal.X, normal.Y, normal.Z, Z, one channel a spectral bin
/// (absolute), and, if light paths were traced, caustics.R, caustics.G, caustics.B: the part of R,
/// G, B that they brought.
Image image_from_film(const FilmSums& film, const Film& settings);

/// The same picture as a screen shows it. The exposure is that of `display`; dither goes by the
/// place in the whole picture, so that a crop is a part of it bit for bit.
Image8 display_from_film(const FilmSums& film, const Film& settings,
                         const DisplaySettings& display);

/// The facts of a render that its files state: version, fingerprint, scene, estimator and its
/// settings, seed, samples, packet, size, crop, stop reason, invalid samples, film hash, seconds,
/// white luminance.
Attributes render_facts(const Scene& scene, const RenderIdentity& identity,
                        const SessionResult& result, const std::string& scene_file);

/// Writes `path` in the format of its extension (.exr or .png), whole or not at all. The data of a
/// film with a crop are the crop alone; `facts` say where it lies. Throws InputError.
void write_picture(const std::filesystem::path& path, const FilmSums& film, const Scene& scene,
                   const DisplaySettings& display, const Attributes& facts);

/// The extensions that write_picture knows, with their dots.
const std::vector<std::string>& picture_extensions();

/// Throws the InputError that write_picture would throw for this path, as far as that can be known
/// before there is a picture: an extension that is not known, a place that cannot be written.
void check_picture_path(const std::filesystem::path& path);

}  // namespace dewbow
