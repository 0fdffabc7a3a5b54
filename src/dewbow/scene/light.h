// SPDX-License-Identifier: Apache-2.0
#pragma once

// Lights that are no shapes. (A shape gives off light through its material's emission.)

#include <memory>
#include <variant>
#include <vector>

#include "dewbow/math/transform.h"
#include "dewbow/scene/photometric_web.h"
#include "dewbow/sky/sky_dome.h"
#include "dewbow/spectrum/colour.h"
#include "dewbow/spectrum/spectrum.h"

namespace dewbow {

struct PointLight {
    Point<World> position;
    SpectrumPtr intensity;  ///< W sr⁻¹ nm⁻¹
};

/// A point light within a cone; between the inner and the outer angle it falls off smoothly
/// (glTF KHR_lights_punctual: (saturate(cos θ·scale + offset))²).
struct SpotLight {
    Point<World> position;
    Dir<World> direction;
    Angle inner, outer;     ///< from the axis, 0 <= inner < outer <= 90°
    SpectrumPtr intensity;  ///< on the axis, W sr⁻¹ nm⁻¹
};

/// A point light whose intensity differs from direction to direction, as measured.
struct ProfileLight {
    Point<World> position;
    Transform<World, Object> world_from_object;  ///< a rotation: how the web is turned
    std::shared_ptr<const PhotometricWeb> web;
    SpectrumPtr intensity_per_cd;  ///< W sr⁻¹ nm⁻¹ where the web says 1 cd
};

/// Parallel light in a cylinder that begins at a disc and never ends: a laser, a collimator.
struct BeamLight {
    Point<World> position;  ///< of the disc's centre
    Dir<World> direction;   ///< in which the light travels, and the disc's normal
    Length radius;
    SpectrumPtr irradiance;  ///< on a surface that faces the light, W m⁻² nm⁻¹
};

/// Light from infinitely far: all directions within `angular_radius` of −direction, evenly.
struct DistantLight {
    Dir<World> direction;    ///< in which the light travels
    Angle angular_radius;    ///< 0 = parallel; the sun: 0.2666°
    SpectrumPtr irradiance;  ///< on a surface that faces the light, W m⁻² nm⁻¹
};

/// The same radiance from everywhere.
struct UniformEnvironment {
    SpectrumPtr radiance;  ///< W m⁻² sr⁻¹ nm⁻¹
};

/// Radiance by direction from an equirectangular picture. Row 0 is straight up (+y); the picture's
/// centre is −z in its own frame, and longitude grows to the right (towards +x).
struct ImageEnvironment {
    int width = 0, height = 0;
    /// Row-major; (1,1,1) is D65 of the radiance whose Y is that of the constant spectrum 1.
    std::vector<Colour<LinearSrgb>> pixels;
    double scale = 1.0;
    Transform<World, Object> world_from_object;  ///< a rotation
};

/// A SkyDomePtr is the light of a sky by direction; its sun or moon is a DistantLight beside it.
using Light = std::variant<PointLight, SpotLight, ProfileLight, BeamLight, DistantLight,
                           UniformEnvironment, std::shared_ptr<const ImageEnvironment>, SkyDomePtr>;

}  // namespace dewbow
