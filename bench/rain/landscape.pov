// SPDX-License-Identifier: Apache-2.0
//
// examples/landscape.toml as POV-Ray 3.7 can show it: the same ground, plants, sun and camera, and for the bows its
// `rainbow {}`. What that leaves to the user is set as well as it can be: two bows with the radii and widths of
// docs/rainbow.md, the primary with red outside, the secondary reversed, colours softened at their edges, no jitter.
// docs/rain.md says how it is run.

#version 3.7;
global_settings {
  assumed_gamma 1
  radiosity { count 80 error_bound 0.5 recursion_limit 1 nearest_count 8 low_error_factor 0.5 pretrace_end 0.01 }
}
#default { finish { ambient 0 diffuse 1 } }

#include "scene.inc"

light_source { Sun_Direction * 1e6 color Sun_Colour parallel point_at 0 }

// The clear sky and its cloud, as the scene has them.
sky_sphere { pigment { image_map { exr "sky.exr" gamma 1 map_type 1 interpolate 2 } rotate -90 * y } }

// Haze. A constant fog (type 1) would erase the bows, so it is one that thins with height.
fog { fog_type 2 distance 20000 rgb <0.55, 0.60, 0.66> * 0.12 fog_offset 200 fog_alt 400 }

// A bow of the colours that docs/rain.md describes; the sky shows through by their last number.
#macro Bow(Radius, Width, Outwards, Clear)
  rainbow {
    angle Radius width Width
    arc_angle 360 falloff_angle 360
    direction -Sun_Direction
    up y
    distance 1200
    jitter 0
    color_map {
      // index 0 is the inner edge
      #if (Outwards)
        [0.00 rgbt <0.35, 0.20, 0.60, 1.00>]
        [0.14 rgbt <0.45, 0.30, 0.85, Clear + 0.10>]
        [0.32 rgbt <0.30, 0.45, 0.95, Clear>]
        [0.48 rgbt <0.35, 0.85, 0.55, Clear>]
        [0.62 rgbt <0.80, 0.90, 0.30, Clear>]
        [0.76 rgbt <1.00, 0.75, 0.25, Clear>]
        [0.90 rgbt <1.00, 0.35, 0.20, Clear>]
        [1.00 rgbt <0.90, 0.15, 0.12, 1.00>]
      #else
        [0.00 rgbt <0.90, 0.15, 0.12, 1.00>]
        [0.10 rgbt <1.00, 0.35, 0.20, Clear>]
        [0.24 rgbt <1.00, 0.75, 0.25, Clear>]
        [0.38 rgbt <0.80, 0.90, 0.30, Clear>]
        [0.52 rgbt <0.35, 0.85, 0.55, Clear>]
        [0.68 rgbt <0.30, 0.45, 0.95, Clear>]
        [0.86 rgbt <0.45, 0.30, 0.85, Clear + 0.10>]
        [1.00 rgbt <0.35, 0.20, 0.60, 1.00>]
      #end
    }
  }
#end
Bow(41.55, 2.4, true, 0.70)
Bow(51.9, 3.9, false, 0.86)
