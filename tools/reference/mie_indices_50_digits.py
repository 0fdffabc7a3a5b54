#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The Mie series of spheres of many indices with 50 digits: tiny, absorbing, metallic, of air in
water, perfectly conducting. Sizes and indices are the doubles that the decimal numbers stand for.

    python3 tools/reference/mie_indices_50_digits.py > tests/reference/mie_indices_50_digits.csv

takes some seconds.
"""

from mie_50_digits import DIGITS, guard_digits, number, riccati_bessel, terms_of
from mpmath import mp, mpc, mpf

# x, n, k; n = inf is the perfect conductor.
SPHERES = ((1e-3, 1.333, 0), (1e-3, 1.33, 1e-5), (1e-3, 1.5, 1), (1e-3, 0.75, 0), (1e-3, "inf", 0),
           (0.1, 10, 10), (0.1, "inf", 0), (3, 0.75, 0), (20, 100, 100), (50, 1.33, 1e-5), (100, "inf", 0),
           (300, 1.5, 0.1), (300, 1.333, 1e-9), (1000, 0.75, 0), (1000, 10, 10), (3000, 1.33, 1e-4))
ANGLES_DEG = ("0", "1.5", "60", "90", "139", "180")


def logarithmic_derivatives(z, count):
    """D_n of complex z by its continued fraction from far beyond."""
    start = int(max(count, abs(z)) * 1.2) + 200
    d = [mpc(0)] * (start + 1)
    for n in range(start, 0, -1):
        d[n - 1] = n / z - 1 / (d[n] + n / z)
    return d


def coefficients(x, n_re, k):
    """a_n, b_n, n = 1….                                          [Bohren & Huffman, eq. 4.88]"""
    count = terms_of(x)
    psi, chi = riccati_bessel(x, count)
    xi = [p - mpc(0, 1) * c for p, c in zip(psi, chi)]
    a, b = [], []
    if n_re == "inf":  # psi' / xi', psi / xi                     [van de Hulst, §9.22]
        for n in range(1, count + 1):
            a.append((psi[n - 1] - n / x * psi[n]) / (xi[n - 1] - n / x * xi[n]))
            b.append(psi[n] / xi[n])
        return a, b
    m = mpc(n_re, k)
    d = logarithmic_derivatives(m * x, count)
    for n in range(1, count + 1):
        for out, factor in ((a, d[n] / m + n / x), (b, d[n] * m + n / x)):
            out.append((factor * psi[n] - psi[n - 1]) / (factor * xi[n] - xi[n - 1]))
    return a, b


def rows_of(x, n_re, k):
    with mp.workdps(DIGITS + guard_digits(x)):
        x = mpf(x)
        a, b = coefficients(x, n_re, k)
        orders = range(1, len(a) + 1)
        extinction = sum((2 * n + 1) * (a[n - 1] + b[n - 1]).real for n in orders)
        scattering = sum((2 * n + 1) * (abs(a[n - 1]) ** 2 + abs(b[n - 1]) ** 2) for n in orders)
        g = sum(mpf(2 * n + 1) / (n * (n + 1)) * (a[n - 1] * b[n - 1].conjugate()).real for n in orders)
        g += sum(mpf(n * (n + 2)) / (n + 1) *
                 (a[n - 1] * a[n].conjugate() + b[n - 1] * b[n].conjugate()).real for n in orders[:-1])
        yield "qext", "", 2 * extinction / x**2
        yield "qsca", "", 2 * scattering / x**2
        yield "g", "", 2 * g / scattering
        for angle in ANGLES_DEG:
            cosine, s1, s2, before, pi = mp.cospi(mpf(angle) / 180), mpc(0), mpc(0), mpf(0), mpf(1)
            for n in orders:
                tau, c = n * cosine * pi - (n + 1) * before, mpf(2 * n + 1) / (n * (n + 1))
                s1 += c * (a[n - 1] * pi + b[n - 1] * tau)
                s2 += c * (a[n - 1] * tau + b[n - 1] * pi)
                before, pi = pi, ((2 * n + 1) * cosine * pi - (n + 1) * before) / n
            yield "S1", angle, s1
            yield "S2", angle, s2


def main():
    print(f"# Mie series of spheres of many indices n + ik, {DIGITS} digits, the first 25 printed; n = inf conducts perfectly.")
    print("# Sizes and indices are the doubles next to the decimal numbers; angles are the decimal numbers of degrees.")
    print("# Bohren & Huffman's signs: e^{-iωt}, S1 perpendicular. Source: tools/reference/mie_indices_50_digits.py, mpmath.")
    print("x,n,k,quantity,angle_deg,re,im")
    for x, n, k in SPHERES:
        for quantity, angle, value in rows_of(x, n, k):
            value = mpc(value)
            print(f"{x},{n},{k},{quantity},{angle},{number(value.real)},{number(value.imag)}", flush=True)


if __name__ == "__main__":
    main()
