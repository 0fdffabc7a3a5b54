// SPDX-License-Identifier: Apache-2.0
//
// What drops do to light that comes from infinitely far: one text for C++ and for shaders.
//
//   L = L_bg T + E albedo p(theta) \int V(s) e^{-tau_sun(s)} e^{-tau(s)} dtau_r(s)
//
// It is written in what C++ and GLSL 3.30 have in common. Whoever includes it has defined `real`, a
// floating-point type, and `RAIN_LAW`, what stands before a function (`inline`, or nothing); `exp`,
// `log`, `abs`, `min` and `max` of reals are there. rain_law.h is its manual.
//
// Symbols: tau, an optical depth towards the eye, and tau_sun, towards the sun, of all rains; tau_r, of
// the rain that scatters; p, the share that is scattered into a steradian (sr^-1).

/// (1 - e^{-x}) / x, of any sign, 1 at 0: the mean of e^{-tau} where tau grows evenly from 0 to x.
/// Below 1/2 by its series, whose first omitted term is 5e-17.
RAIN_LAW real rain_mean_transmittance(real x) {
    if (abs(x) >= 0.5) return (1.0 - exp(-x)) / x;
    real sum = 1.0;
    for (int k = 14; k >= 2; --k) sum = 1.0 - x * sum / real(k);
    return sum;
}

/// 1 - e^{-x} for x >= 0, without loss where x is small.
RAIN_LAW real rain_opacity(real x) {
    if (x >= 0.5) return 1.0 - exp(-x);
    return x * rain_mean_transmittance(x);
}

/// -log(1 - y) / y for 0 <= y < 1, 1 at 0. Below 1/4 by the series of artanh(z), z = y / (2 - y) < 1/7,
/// whose first omitted term is 6e-19.
RAIN_LAW real rain_mean_logarithm(real y) {
    if (y >= 0.25) return -log(1.0 - y) / y;
    real z = y / (2.0 - y);
    real sum = 0.0;
    for (int k = 19; k >= 1; k -= 2) sum = sum * z * z + 1.0 / real(k);
    return 2.0 * sum / (2.0 - y);
}

/// The share of light that comes through an optical depth.
RAIN_LAW real rain_transmittance(real depth) { return exp(-depth); }

/// \int_0^length e^{-(depth + rate s)} ds in m: how much of a piece of a line is seen and lit, on which
/// the optical depth towards the eye and the sun together, `depth` at its begin, changes by `rate` a
/// metre. The depth is nowhere negative. `length` may be infinite where `rate` > 0.
RAIN_LAW real rain_piece(real depth, real rate, real length) {
    real change = rate * length;
    if (abs(change) >= 0.5) {
        // Each end by itself, from the end where more is left: no product of infinite and 0.
        real least = min(depth, depth + change);
        return exp(-least) * rain_opacity(abs(change)) / abs(rate);
    }
    return exp(-depth) * length * rain_mean_transmittance(change);
}

/// Where a share `u` of the integral of e^{-rate s} from 0 to `length` is reached, 0 <= u < 1, in m.
RAIN_LAW real rain_decay_place(real rate, real length, real u) {
    real change = rate * length;
    if (change < 0.25) {
        real share = u * rain_mean_transmittance(change);
        return length * share * rain_mean_logarithm(share * change);
    }
    real y = u * rain_opacity(change);
    return y * rain_mean_logarithm(y) / rate;
}

/// Where a share `u` of rain_piece() is reached: a distance into the piece in m, 0 <= u < 1. Of a piece
/// on which more is left at the end it is measured from there.
RAIN_LAW real rain_piece_place(real rate, real length, real u) {
    if (rate < 0.0) return max(0.0, length - rain_decay_place(-rate, length, 1.0 - u));
    return min(length, rain_decay_place(rate, length, u));
}

/// What a piece of a rain sends to the eye of a sun's light: radiance, of its irradiance on a surface
/// that faces it, above all rains. `extinction` is the rain's in m^-1, `piece` its rain_piece() in m.
RAIN_LAW real rain_light(real irradiance, real albedo, real phase, real extinction, real piece) {
    return irradiance * albedo * phase * (extinction * piece);
}

/// The integral over a slab of optical depth `depth` along the view, lit through the face that the
/// view comes in by. `slant`, the way towards the sun over the way towards the eye, >= 0: of a sun
/// at altitude h that lights a layer of rain from above, seen from above at altitude -a, it is
/// sin a / sin h.                              (1 - e^{-(1 + slant) depth}) / (1 + slant)
RAIN_LAW real rain_slab(real depth, real slant) {
    return rain_opacity((1.0 + slant) * depth) / (1.0 + slant);
}

/// At the antisolar point of a slab, where light goes back by the way that it came.
///                                                                    (1 - e^{-2 depth}) / 2
RAIN_LAW real rain_antisolar(real depth) { return rain_slab(depth, 1.0); }

/// The integral over rain without end, into which sunlight comes undimmed, before something at an
/// optical depth.                                                                1 - e^{-depth}
RAIN_LAW real rain_endless(real depth) { return rain_slab(depth, 0.0); }
