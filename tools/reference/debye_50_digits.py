#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The Debye series of a water drop with 50 digits: the oracle of rainbow/debye.

The four Fresnel coefficients of each partial wave come from a 2 x 2 system of linear equations
(continuity of the tangential fields), solved as it stands; the library evaluates a rearranged form.
Orders p = 0…7, p = 0 with the diffraction half of each partial wave, "rest" all p >= 8 by the sum of
the geometric series, "mie" the whole from mie_50_digits.py. The program stops with an error unless
the orders and the rest add up to Mie in 40 digits.

    python3 tools/reference/debye_50_digits.py > tests/reference/debye_50_digits.csv
"""

import sys

from mpmath import mp, mpc, mpf

from mie_50_digits import (DIGITS, INDEX, amplitudes, coefficients, cosine_of_degrees, guard_digits,
                           number, riccati_bessel, terms_of)

HIGHEST_ORDER = 7
SIZES = {
    100: "0 0.5 22.25 41.7 60 77.7 90 129.1 134.55 138 138.2 142.85 150 165.4 179.5 180",
    1000: "0 0.5 22.25 41.7 60 90 129.1 134.55 138 138.2 142.85 150 165.4 179.5 180",
    5712: "0 22.25 41.7 60 90 128.6 134.55 138 138.2 139.5 150 179.97 180",
    20000: "41.7 129.1 134.55 138 142.85 180",
}
HEADER = "x,order,quantity,angle_deg,re,im"
AGREEMENT = mpf(10) ** -40


def travelling_waves(z, count):
    """zeta1 = psi − i chi runs outwards, zeta2 = psi + i chi inwards (e^{-iωt}); and derivatives."""
    psi, chi = riccati_bessel(z, count)
    waves = []
    for sign in (-1, 1):
        f = [mpc(p, sign * c) for p, c in zip(psi, chi)]
        waves.append((f, [None] + [f[n - 1] - n * f[n] / z for n in range(1, count + 1)]))
    return waves


def solve(matrix, right):
    """Cramer's rule."""
    (a, b), (c, d) = matrix
    det = a * d - b * c
    return (right[0] * d - b * right[1]) / det, (a * right[1] - right[0] * c) / det


def fresnel_of_wave(alpha, beta, x1, dx1, x2, dx2, y1, dy1, y2, dy2):
    """Reflection r22 outside and r11 inside, transmission t21 inwards and t12 outwards.

    Tangential fields are continuous: the value outside equals alpha times that inside, the slope
    beta times, up to a common factor; (alpha, beta) is (m, 1) for TM waves (a_n), (1, m) for TE.
    """
    # x2 + r22 x1 = alpha t21 y2 outside in, alpha (y1 + r11 y2) = t12 x1 inside out.
    r22, t21 = solve(((x1, -alpha * y2), (dx1, -beta * dy2)), (-x2, -dx2))
    r11, t12 = solve(((alpha * y2, -x1), (beta * dy2, -dx1)), (-alpha * y1, -beta * dy1))
    return r22, r11, t21, t12


def series_of(size):
    """By name of the order: (a_n, b_n) as lists of pairs."""
    m, x = mpf(INDEX), mpf(size)
    count = terms_of(x)
    (x1, dx1), (x2, dx2) = travelling_waves(x, count)
    (y1, dy1), (y2, dy2) = travelling_waves(m * x, count)
    names = [str(p) for p in range(HIGHEST_ORDER + 1)] + ["rest"]
    series = {name: ([], []) for name in names}
    for polarisation, (alpha, beta) in enumerate(((m, mpf(1)), (mpf(1), m))):
        for n in range(1, count + 1):
            r22, r11, t21, t12 = fresnel_of_wave(alpha, beta, x1[n], dx1[n], x2[n], dx2[n], y1[n],
                                                 dy1[n], y2[n], dy2[n])
            through = t21 * t12
            terms = [(1 - r22) / 2]
            terms += [-through * r11 ** (p - 1) / 2 for p in range(1, HIGHEST_ORDER + 1)]
            terms.append(-through * r11**HIGHEST_ORDER / (1 - r11) / 2)
            for name, term in zip(names, terms):
                series[name][polarisation].append((term.real, term.imag))
    mie = coefficients(m, x)
    require_sum(series.values(), mie)
    series["mie"] = mie
    return series


def require_sum(parts, whole):
    for polarisation in range(2):
        for n, (re, im) in enumerate(whole[polarisation]):
            total = sum(mpc(*part[polarisation][n]) for part in parts)
            if abs(total - mpc(re, im)) > AGREEMENT:
                sys.exit(f"partial wave {n + 1}: the orders do not add up to Mie")


def main():
    print(f"# Debye series of a sphere of real index {INDEX} (the decimal number), {DIGITS} digits, the first 25 printed.")
    print("# Order p: the part of light along p chords inside; 0 outside with the diffraction half of each")
    print("# partial wave; rest all p >= 8; mie everything. qsca: 2/x² Σ (2n + 1) (|a_n|² + |b_n|²) of the order alone.")
    print("# The angle is the decimal number of degrees. Bohren & Huffman's signs: e^{-iωt}, S1 perpendicular.")
    print("# Source: tools/reference/debye_50_digits.py, mpmath.")
    print(HEADER)
    for size, angles in SIZES.items():
        with mp.workdps(DIGITS + guard_digits(size)):
            series = series_of(size)
        with mp.workdps(DIGITS + 20):
            for name, (a, b) in series.items():
                energy = sum((2 * n + 1) * sum(u * u for u in a[n - 1] + b[n - 1])
                             for n in range(1, len(a) + 1))
                print(f"{size},{name},qsca,,{number(2 * energy / mpf(size) ** 2)},0", flush=True)
            for angle in angles.split():
                sums = amplitudes(list(series.values()), cosine_of_degrees(angle))
                for name, s in zip(series, sums):
                    print(f"{size},{name},S1,{angle},{number(s[0])},{number(s[1])}")
                    print(f"{size},{name},S2,{angle},{number(s[2])},{number(s[3])}", flush=True)


if __name__ == "__main__":
    main()
