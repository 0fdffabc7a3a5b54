// SPDX-License-Identifier: Apache-2.0
#pragma once

// What validate() asks of numbers and spectra. Each throws InputError "`who`: `what` is …; it must
// be …". `who` is 'material "gold"', `what` "roughness".

#include <limits>
#include <string>

#include "dewbow/scene/scene.h"

namespace dewbow::checks {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Rounding that a reflectance may exceed 1 by, and a unit vector miss its length by.
inline constexpr double kRounding = 1e-6;

[[noreturn]] void fail(const std::string& who, const std::string& what);

void check_range(const std::string& who, const char* what, double value, double low, double high);
void check_positive(const std::string& who, const char* what, double value);
/// `index` is that of a material, of which there are `size`.
void check_index(const std::string& who, const char* what, int index, std::size_t size);
/// Looks at `spectrum` at every nanometre of the visible range.
void check_spectrum(const std::string& who, const char* what, const SpectrumPtr& spectrum,
                    double high = kInfinity);
/// A spectrum between 0 and 1.
void check_share(const std::string& who, const char* what, const SpectrumPtr& spectrum);
/// Between 0 and 1 wherever it is looked up; an empty input is.
void check_share(const std::string& who, const char* what, const ColourInput& input);
void check_share(const std::string& who, const char* what, const NumberInput& input);
/// A texture whose picture has as many texels as it states, and whose numbers are in range.
void check_texture(const std::string& who, const char* what, const TexturePtr& texture);
void check_medium(const std::string& who, const MediumPtr& medium);
void check_finite(const std::string& who, const char* what, Vec3 v);
void check_unit(const std::string& who, const char* what, Vec3 v);
void check_affine(const std::string& who, const Affine& affine);
/// With triangles, all of its own vertices, which are finite.
void check_mesh(const std::string& who, const std::shared_ptr<const Mesh>& mesh);

// The parts of validate().
void check_camera(const CameraView& camera, const Film& film);
void check_materials(const Scene& scene);
void check_shapes(const Scene& scene);
void check_lights(const Scene& scene);
void check_rains(const Scene& scene);

}  // namespace dewbow::checks
