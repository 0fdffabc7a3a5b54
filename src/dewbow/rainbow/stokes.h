// SPDX-License-Identifier: Apache-2.0
#pragma once

// Polarisation of light that drops have scattered once: linear, along the bow or across it.

#include "dewbow/base/quantity.h"
#include "dewbow/math/vector.h"
#include "dewbow/rainbow/scattering.h"

namespace dewbow {

/// I, Q and U of light that comes towards an observer, against a reference direction in the
/// picture: Q = I_0° − I_90°, U = I_45° − I_135°, angles counterclockwise as the observer sees
/// them. V is 0: one sphere makes no circular polarisation out of sunlight.
struct Stokes {
    double i = 0.0, q = 0.0, u = 0.0;
};

/// Of sunlight scattered with these intensities: I = (I_⊥ + I_∥)/2.
/// @param tangent  of the direction perpendicular to the plane of scattering (tangential to the
/// bow) against the reference.
Stokes stokes_of(const Intensities& scattered, Angle tangent);

/// The direction perpendicular to the plane of scattering, against the vertical of the picture (the
/// plane of the line of sight and y), counterclockwise, −90° to 90°. 0 where the line of sight
/// passes through the sun or the antisolar point.
/// @param view  from the observer to the drop.   @param to_sun  from the observer to the sun.
Angle tangent_of_bow(Dir<World> view, Dir<World> to_sun);

/// Intensity behind an ideal polariser whose axis stands at `axis` against the reference:
/// (I + Q cos 2φ + U sin 2φ) / 2. Half of light without polarisation.
double through_polariser(const Stokes& light, Angle axis);

/// (I_⊥ − I_∥) / (I_⊥ + I_∥), −1 to 1: 0.924 for the primary bow by rays at index 1.333. Not the
/// share of the perpendicular component, which is often quoted for it. 0 without light.
double degree_of_polarisation(const Intensities& scattered);
/// √(Q² + U²) / I, 0 to 1. 0 without light.
double degree_of_polarisation(const Stokes& light);
/// I_⊥ / (I_⊥ + I_∥), 0 to 1: 0.962 for the primary bow by rays at index 1.333. 1/2 without light.
double perpendicular_share(const Intensities& scattered);

}  // namespace dewbow
