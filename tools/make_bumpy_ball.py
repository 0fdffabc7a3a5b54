#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes ball.ply, a closed ball with bumps of 2 n (n - 1) triangles, and ball.toml, a diffuse scene of it.

    tools/make_bumpy_ball.py FOLDER [n = 300]
"""
import math
import pathlib
import struct
import sys

SCENE = """\
[camera]
position = [0.0, 2.0, 5.0]
look_at = [0.0, 0.2, 0.0]
vertical_fov_deg = 35

[materials]
grey = { type = "diffuse", reflectance = 0.7 }
lamp = { type = "black", emission = { illuminant = "D65", scale = 20 } }

[[shapes]]
type = "mesh"
file = "ball.ply"
material = "grey"

[[shapes]]
type = "rectangle"
width_m = 20
height_m = 20
material = "grey"
position = [0.0, -1.1, 0.0]
rotate_x_deg = -90

[[shapes]]
type = "disc"
radius_m = 0.5
material = "lamp"
position = [2.0, 4.0, 2.0]
look_at = [0.0, 0.0, 0.0]

[[lights]]
type = "environment"
radiance = 0.3
"""


def corner(row, column, n):
    theta, phi = math.pi * row / n, 2.0 * math.pi * column / n
    sine = 0.0 if row in (0, n) else math.sin(theta)
    x, y, z = sine * math.cos(phi), math.cos(theta), -sine * math.sin(phi)
    radius = 1.0 + 0.1 * math.sin(17.0 * x) * math.sin(15.0 * y) * math.sin(13.0 * z)
    return radius * x, radius * y, radius * z


def triangles(n):
    for row in range(n):
        for column in range(n):
            a, b = row * n + column, row * n + (column + 1) % n
            if row + 1 < n:
                yield a, a + n, b + n
            if row > 0:
                yield a, b + n, b


def main(folder, n=300):
    n = int(n)
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    faces = list(triangles(n))
    with open(folder / "ball.ply", "wb") as out:
        out.write(f"ply\nformat binary_little_endian 1.0\nelement vertex {(n + 1) * n}\n"
                  "property float x\nproperty float y\nproperty float z\n"
                  f"element face {len(faces)}\n"
                  "property list uchar int vertex_indices\nend_header\n".encode())
        for row in range(n + 1):
            for column in range(n):
                out.write(struct.pack("<3f", *corner(row, column, n)))
        for face in faces:
            out.write(struct.pack("<B3i", 3, *face))
    (folder / "ball.toml").write_text(SCENE)


if __name__ == "__main__":
    main(*sys.argv[1:])
