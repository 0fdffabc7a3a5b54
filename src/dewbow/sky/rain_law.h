// SPDX-License-Identifier: Apache-2.0
#pragma once

// The law of rain's light, of which a bow is the part that one sees: single scattering of light
// from infinitely far, dimmed on its way in and on its way to the eye. The text stands once, in
// rain_law.inl, and shaders take it from there; here it is C++, in double precision.
//
// Where regions are convex, the optical depth to the eye and to the sun is linear along pieces of a
// line (rain_region.h), so that the integral of the law is a sum of closed forms:
//
//     const double piece = rain_law::rain_piece(depth, rate, length);           // m
//     radiance += rain_law::rain_light(irradiance, albedo, phase, extinction, piece);
//
// All functions hold for optical depths from 0 to 1e308; relative error below 1e-14, but for what
// the difference of two large depths has lost before.

#include <algorithm>
#include <cmath>

namespace dewbow::rain_law {

using real = double;
using std::abs;
using std::exp;
using std::log;
using std::max;
using std::min;

#define RAIN_LAW inline
#include "dewbow/sky/rain_law.inl"
#undef RAIN_LAW

}  // namespace dewbow::rain_law
