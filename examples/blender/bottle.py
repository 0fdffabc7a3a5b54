# SPDX-License-Identifier: Apache-2.0
"""A still life: a bottle of green glass with wine and a label, a glass of water, a checked cloth.

    blender --background --factory-startup --python examples/blender/bottle.py -- bottle.glb
    dewbow render bottle.glb -o bottle.png
"""

import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from kit import *  # noqa: E402,F403

OUTER = [(0.0, 0.004), (0.030, 0.0), (0.0365, 0.003), (0.037, 0.010), (0.037, 0.185), (0.034, 0.205),
         (0.022, 0.228), (0.0155, 0.245), (0.0145, 0.260), (0.0145, 0.292), (0.0160, 0.294),
         (0.0160, 0.300), (0.0145, 0.302)]
WALL = 0.0030


def inner_outline():
    return [(max(0.0, r - WALL), h + (WALL if r < 0.035 and h < 0.01 else 0.0)) for r, h in OUTER]


def bottle_body(material):
    """The wall: up the outside, over the lip, down the inside."""
    return lathe("Bottle", OUTER + list(reversed(inner_outline())), material)


def wine_body(level, material):
    """The wine fills the inside up to `level` and reaches a hair into the wall, so that no film of air
    is left between the two."""
    into = 0.0004
    outline = [(r + into if r > 0 else 0.0, h - (into if r == 0 else 0.0)) for r, h in inner_outline() if h < level]
    outline += [(outline[-1][0], level), (0.0, level)]
    return lathe("Wine", outline, material)


def label_colour(u, v):
    """Cream paper with a frame, a crest and lines of text, with rounded corners cut out."""
    x, y = min(u, 1 - u) * 1.5, min(v, 1 - v)
    radius = 0.08
    corner = x < radius and y < radius and math.hypot(radius - x, radius - y) > radius
    ink, paper, gold = (0.10, 0.06, 0.05), (0.93, 0.90, 0.80), (0.62, 0.45, 0.13)
    colour = paper
    if 0.035 < min(x, y) < 0.05:
        colour = gold
    if math.hypot((u - 0.5) * 1.5, v - 0.66) < 0.14:
        colour = gold if math.hypot((u - 0.5) * 1.5, v - 0.66) > 0.115 else (0.45, 0.05, 0.08)
    for line, half in ((0.40, 0.30), (0.29, 0.22), (0.20, 0.25)):
        if abs(v - line) < 0.018 and abs(u - 0.5) < half and math.sin(u * 170 + line * 50) > -0.55:
            colour = ink
    return (*colour, 0.0 if corner else 1.0)


def label(material):
    """A strip of paper around a third of the bottle."""
    vertices, faces, uvs = [], [], []
    columns, radius = 32, 0.0373
    for k in range(columns + 1):
        azimuth = math.radians(-90 - 62 + 124 * k / columns)
        for z, v in ((0.055, 0.0), (0.135, 1.0)):
            vertices.append((radius * math.cos(azimuth), radius * math.sin(azimuth), z))
            uvs.append((k / columns, v))
    for k in range(columns):
        faces.append([2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1])
    return mesh("Label", vertices, faces, material, smooth=True, uv=lambda i: uvs[i])


def checks(u, v):
    white, blue = (0.85, 0.84, 0.80), (0.16, 0.24, 0.48)
    a, b = (u * 20) % 1 < 0.5, (v * 20) % 1 < 0.5
    return tuple((w * (2 - a - b) + c * (a + b)) / 2 for w, c in zip(white, blue))


empty_scene()
bottle_body(glass("Bottle glass", 1.52, "schott/N-BK7", (0.35, 0.62, 0.30), 8 * MM))
wine_body(0.200, glass("Wine", 1.34, None, (0.50, 0.045, 0.07), 6 * MM))
label(textured("Label", picture("label", 384, 256, label_colour, alpha=True), 0.6, "CLIP"))

# A drinking glass: the water again reaches into the wall.
outline = [(0.0, 0.0), (0.030, 0.0), (0.0335, 0.090), (0.0320, 0.0905), (0.0286, 0.008), (0.0, 0.008)]
tumbler = lathe("Tumbler", outline, glass("Tumbler", 1.52, "schott/N-BK7"))
tumbler.location = (0.095, -0.035, 0)
water = lathe("Water", [(0.0, 0.0078), (0.0288, 0.0078), (0.0312, 0.060), (0.0, 0.060)],
              glass("Water", 1.333, "fluid/water"))
water.location = (0.095, -0.035, 0)

cloth = textured("Cloth", picture("cloth", 512, 512, checks), 0.9)
plane("Table", (1.2, 1.2), cloth)
plane("Wall", (3.0, 2.0), paint("Wall", (0.55, 0.50, 0.44), 0.9), (0, 0.9, 0.8), (90, 0, 0))
plane("Window", (0.7, 0.9), glow("Window", (0.93, 0.97, 1.0), 9.0), (-0.9, -0.2, 0.6), (90, 0, -100))
plane("Fill", (0.5, 0.5), glow("Fill", (1.0, 0.9, 0.8), 1.5), (0.8, -0.7, 0.8), (55, 0, 50))

camera((0.10, -0.72, 0.30), (0.035, 0.0, 0.125), 50)
export(output_path("bottle.glb"))
