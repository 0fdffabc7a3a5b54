#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes bench/scenes/tumbler.obj and bench/scenes/water.obj: a tumbler of twelve sides, and what is in it.

All lengths in metres, y up. The tumbler stands on y = 0. Its inner wall has a ring of corners at
the water's level, so that each of its faces is either wet or dry. The water reaches 1 um into the
glass, whose priority is to be higher.

    tools/make_tumbler.py bench/scenes
"""

import math
import pathlib
import sys

SIDES = 12
HEIGHT, BASE, LEVEL = 0.090, 0.012, 0.062  # of the rim, the inner bottom, the water
FOOT_RADIUS, RIM_RADIUS, WALL = 0.026, 0.034, 0.004  # to the corners; WALL along the radius
OVERLAP = 1e-6


def outer_radius(y):
    return FOOT_RADIUS + (RIM_RADIUS - FOOT_RADIUS) * y / HEIGHT


def ring(radius, y):
    return [(radius * math.cos(2 * math.pi * k / SIDES), y, radius * math.sin(2 * math.pi * k / SIDES))
            for k in range(SIDES)]


def band(lower, upper):
    """Faces of the wall between two rings (numbers of their first corners), seen from outside."""
    return [(lower + k, upper + k, upper + (k + 1) % SIDES, lower + (k + 1) % SIDES)
            for k in range(SIDES)]


def flipped(faces):
    return [face[::-1] for face in faces]


def lid(first):
    """A regular polygon, seen from above."""
    return [tuple(first + k for k in reversed(range(SIDES)))]


def write(path, title, rings, faces):
    with open(path, 'w', encoding='ascii') as out:
        out.write(f'# {title}, made by tools/make_tumbler.py.\n')
        for x, y, z in (corner for r in rings for corner in r):
            out.write(f'v {x:.9f} {y:.9f} {z:.9f}\n')
        for face in faces:
            out.write('f ' + ' '.join(str(corner + 1) for corner in face) + '\n')


def main():
    folder = pathlib.Path(sys.argv[1])
    foot, rim, inner_rim, inner_level, inner_base = (SIDES * k for k in range(5))
    rings = [ring(outer_radius(0), 0), ring(outer_radius(HEIGHT), HEIGHT),
             *(ring(outer_radius(y) - WALL, y) for y in (HEIGHT, LEVEL, BASE))]
    write(folder / 'tumbler.obj', 'A tumbler of twelve sides', rings,
          band(foot, rim) + flipped(lid(foot)) + band(rim, inner_rim) +
          flipped(band(inner_level, inner_rim)) + flipped(band(inner_base, inner_level)) +
          lid(inner_base))
    rings = [ring(outer_radius(y) - WALL + OVERLAP, at)
             for y, at in ((BASE, BASE - OVERLAP), (LEVEL, LEVEL))]
    write(folder / 'water.obj', 'The water in tumbler.obj', rings,
          band(0, SIDES) + flipped(lid(0)) + lid(SIDES))


if __name__ == '__main__':
    main()
