#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Ai and Ai' with 40 digits of work and 20 of print, for tests of math/airy.

    tools/reference/airy_values.py > tests/reference/airy.csv        (needs mpmath)
"""

import mpmath as mp

mp.mp.dps = 40

# Across every branch of the code and their joints, the first zeros of both (DLMF 9.9), arguments
# that are no round numbers, and far out on both sides. All are exact doubles.
ARGUMENTS = (
    [k / 8 for k in range(-96, 97, 3)]
    + [-10.0625, -9.9375, 9.9375, 10.0625, -0.2499, -0.2501, 0.2499, 0.2501]
    + [-1.0187929716474710, -2.3381074104597670, -3.2481975821798366, -4.0879494441309706]
    + [-31.7, -100.3, -127.98, -255.99, -256.01, -1000.7, -9999.9]
    + [15.99, 16.01, 33.3, 77.7, 100.0]
)

print("# Ai and Ai' by mpmath, 40 digits; made by tools/reference/airy_values.py")
print("x,ai,ai_prime")
for x in sorted(ARGUMENTS):
    ai, derivative = mp.airyai(mp.mpf(x)), mp.airyai(mp.mpf(x), derivative=1)
    print(f"{x!r},{mp.nstr(ai, 20)},{mp.nstr(derivative, 20)}")
