#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The Mie series of a water drop with 50 digits: the oracle of rainbow/mie.

Everything runs upwards, psi_n below its turning point too: there a rounding error grows like
chi_n / psi_n, which is what the guard digits are for. Nothing is shared with the library, which
runs psi_n and D_n downwards in double precision.

    python3 tools/reference/mie_50_digits.py > tests/reference/mie_water_50_digits.csv

takes a minute with gmpy2. --check computes x = 10 and 100 once more with 60 digits more and by
another route (D_n by its continued fraction) and says how far apart they are.
"""

import argparse

import mpmath
from mpmath import mp, mpf

DIGITS = 50
INDEX = "1.333"
SIZES = (10, 100, 1000, 5000, 50000)
# Both poles and their surroundings (glory, forward peak), the bows of p = 2…6, Alexander's band,
# and angles that are no binary fractions.
ANGLES_DEG = ("0 0.013 0.5 5 22.25 41.7 60 77.7 90 110.3 120 128.2 129.1 130 134.55 136.05 137.9 138 "
              "138.2 139.5 142.85 150 165.4 175 179.5 179.97 180").split()
HEADER = "x,quantity,angle_deg,re,im"


def terms_of(x):
    """Where the series ends: the terms beyond are below 1e-50 of the largest."""
    x = float(x)
    return int(x + 18 * x ** (1 / 3) + 25)


def guard_digits(x):
    """log10(chi_N / psi_N), by which psi_N loses accuracy when it runs upwards."""
    n, x = terms_of(x), float(x)
    # WKB: chi_n / psi_n = exp(2 (n acosh(n/x) − √(n² − x²))), up to a factor of order 1.
    return int(2 * float(n * mpmath.acosh(n / x) - mpmath.sqrt(n * n - x * x)) / 2.302) + 15


def riccati_bessel(z, count):
    """psi_n(z) = z j_n(z) and chi_n(z) = −z y_n(z), n = 0…count.   [Bohren & Huffman, §4.8]"""
    sine, cosine = mp.sin(z), mp.cos(z)
    psi, chi = [sine, sine / z - cosine], [cosine, cosine / z + sine]
    for n in range(1, count):
        step = (2 * n + 1) / z
        psi.append(step * psi[n] - psi[n - 1])
        chi.append(step * chi[n] - chi[n - 1])
    return psi, chi


def logarithmic_derivatives(z, count, by_fraction):
    """D_n = psi_n' / psi_n at z."""
    if by_fraction:
        start = int(max(count, float(z)) * 1.2) + 200
        d = [mpf(0)] * (start + 1)
        for n in range(start, 0, -1):
            d[n - 1] = n / z - 1 / (d[n] + n / z)
        return d
    psi, _ = riccati_bessel(z, count)
    return [None] + [psi[n - 1] / psi[n] - n / z for n in range(1, count + 1)]


def coefficients(m, x, by_fraction=False):
    """a_n and b_n, n = 1…, as pairs (re, im); a = P / (P − iQ) for real index.  [B&H, eq. 4.88]"""
    count = terms_of(x)
    psi, chi = riccati_bessel(x, count)
    d = logarithmic_derivatives(m * x, count, by_fraction)
    a, b = [], []
    for n in range(1, count + 1):
        for out, factor in ((a, d[n] / m + n / x), (b, d[n] * m + n / x)):
            p, q = factor * psi[n] - psi[n - 1], factor * chi[n] - chi[n - 1]
            norm = p * p + q * q
            out.append((p * p / norm, p * q / norm))
    return a, b


def efficiencies(a, b, x):
    """Q_ext, Q_sca, g.   [Bohren & Huffman, eqs. 4.61, 4.62, and p. 120]"""
    dot = lambda u, v: u[0] * v[0] + u[1] * v[1]
    q_ext = sum((2 * n + 1) * (a[n - 1][0] + b[n - 1][0]) for n in range(1, len(a) + 1))
    q_sca = sum((2 * n + 1) * (dot(a[n - 1], a[n - 1]) + dot(b[n - 1], b[n - 1]))
                for n in range(1, len(a) + 1))
    g = sum(mpf(2 * n + 1) / (n * (n + 1)) * dot(a[n - 1], b[n - 1]) for n in range(1, len(a) + 1))
    g += sum(mpf(n * (n + 2)) / (n + 1) * (dot(a[n - 1], a[n]) + dot(b[n - 1], b[n]))
             for n in range(1, len(a)))
    return 2 * q_ext / x**2, 2 * q_sca / x**2, 2 * g / q_sca


def amplitudes(series, cosine):
    """S_1 and S_2 of each of `series`, pairs of lists of (re, im).      [Bohren & Huffman, eq. 4.74]

    Shared by the Debye program, which has one series for each order.
    """
    sums = [[mpf(0)] * 4 for _ in series]
    before, pi = mpf(0), mpf(1)
    for n in range(1, len(series[0][0]) + 1):
        tau = n * cosine * pi - (n + 1) * before
        weight = mpf(2 * n + 1) / (n * (n + 1))
        wp, wt = weight * pi, weight * tau
        for s, (a, b) in zip(sums, series):
            (ar, ai), (br, bi) = a[n - 1], b[n - 1]
            s[0] += ar * wp + br * wt
            s[1] += ai * wp + bi * wt
            s[2] += ar * wt + br * wp
            s[3] += ai * wt + bi * wp
        before, pi = pi, ((2 * n + 1) * cosine * pi - (n + 1) * before) / n
    return sums


def cosine_of_degrees(angle):
    return mp.cospi(mpf(angle) / 180)


def number(value):
    return mp.nstr(value, 25, min_fixed=0, max_fixed=0) if value else "0"


def rows_of(size, digits=DIGITS, by_fraction=False):
    with mp.workdps(digits + guard_digits(size)):
        m, x = mpf(INDEX), mpf(size)
        a, b = coefficients(m, x, by_fraction)
        q_ext, q_sca, g = efficiencies(a, b, x)
        rows = [("qext", "", q_ext, 0), ("qsca", "", q_sca, 0), ("g", "", g, 0)]
    with mp.workdps(digits + 20):
        for angle in ANGLES_DEG:
            (s,) = amplitudes([(a, b)], cosine_of_degrees(angle))
            rows += [("S1", angle, s[0], s[1]), ("S2", angle, s[2], s[3])]
    return rows


def check():
    for size in (10, 100):
        one, two = rows_of(size), rows_of(size, DIGITS + 60, by_fraction=True)
        with mp.workdps(2 * DIGITS):
            worst = max(abs(mp.mpc(*u[2:]) / mp.mpc(*v[2:]) - 1) for u, v in zip(one, two))
        print(f"x = {size}: both ways agree to {mp.nstr(worst, 2)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true")
    if parser.parse_args().check:
        return check()
    print(f"# Mie series of a sphere of real index {INDEX} (the decimal number), {DIGITS} digits, the first 25 printed.")
    print("# The angle is the decimal number of degrees. Bohren & Huffman's signs: e^{-iωt}, S1 perpendicular.")
    print("# Source: tools/reference/mie_50_digits.py, mpmath.")
    print(HEADER)
    for size in SIZES:
        for quantity, angle, re, im in rows_of(size):
            print(f"{size},{quantity},{angle},{number(re)},{number(im)}", flush=True)


if __name__ == "__main__":
    main()
