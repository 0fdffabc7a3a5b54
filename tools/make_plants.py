#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the plants of the landscapes in examples/, and the tables that say where they stand.

Plants are binary PLY meshes with colours, in metres, y up.
Each stands on y = 0 around the origin. Leaves are single triangles whose normals lean outwards, so that a
crown is lit as a body and casts the shadow of a lattice. Colours are leaves' and bark's (sRGB in the file).

    tools/make_plants.py examples/bows/plants
"""

import math
import pathlib
import random
import struct
import sys

BARK = (0.11, 0.08, 0.055)  # linear, as all colours here


class Mesh:
    def __init__(self):
        self.vertices, self.faces = [], []

    def add(self, corners, colour):
        first = len(self.vertices)
        self.vertices += [(*corner, *(coded(c) for c in colour)) for corner in corners]
        self.faces.append(tuple(range(first, first + len(corners))))

    def write(self, path):
        with open(path, 'wb') as out:
            out.write((f'ply\nformat binary_little_endian 1.0\ncomment made by tools/make_plants.py\n'
                       f'element vertex {len(self.vertices)}\n'
                       'property float x\nproperty float y\nproperty float z\n'
                       'property uchar red\nproperty uchar green\nproperty uchar blue\n'
                       f'element face {len(self.faces)}\nproperty list uchar ushort vertex_indices\n'
                       'end_header\n').encode())
            for vertex in self.vertices:
                out.write(struct.pack('<3f3B', *vertex))
            for face in self.faces:
                out.write(struct.pack(f'<B{len(face)}H', len(face), *face))


def coded(linear):
    """A channel as sRGB in 8 bits."""
    s = 12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055
    return round(255 * min(max(s, 0.0), 1.0))


def add(a, b, s=1.0):
    return tuple(x + s * y for x, y in zip(a, b))


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return tuple(x / length for x in v)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def in_ball(rng):
    while True:
        v = tuple(rng.uniform(-1, 1) for _ in range(3))
        if 1e-3 < sum(x * x for x in v) <= 1:
            return v


def across(direction):
    """Two unit vectors that make a right-handed frame with `direction`."""
    helper = (1, 0, 0) if abs(direction[0]) < 0.7 else (0, 0, 1)
    u = unit(cross(direction, helper))
    return u, cross(direction, u)


def limb(mesh, start, end, thick, thin, sides=5):
    """A branch: a tapering tube."""
    u, v = across(unit(add(end, start, -1)))
    ring = [(math.cos(2 * math.pi * k / sides), math.sin(2 * math.pi * k / sides)) for k in range(sides)]
    for k in range(sides):
        a, b = ring[k], ring[(k + 1) % sides]
        mesh.add([add(add(start, u, thick * a[0]), v, thick * a[1]), add(add(start, u, thick * b[0]), v, thick * b[1]),
                  add(add(end, u, thin * b[0]), v, thin * b[1]), add(add(end, u, thin * a[0]), v, thin * a[1])], BARK)


def leaf(mesh, rng, place, lean, size, colour, fade=0.35):
    """One triangle at `place`, its normal near `lean`."""
    normal = unit(add(unit(lean), in_ball(rng), 0.8))
    u, v = across(normal)
    turn = rng.uniform(0, 2 * math.pi)
    corners = [add(add(place, u, size * math.cos(turn + k * 2.0944)), v, size * math.sin(turn + k * 2.0944))
               for k in range(3)]
    bright = 1 + fade * rng.uniform(-1, 1)
    mesh.add(corners, (colour[0] * bright * rng.uniform(0.8, 1.25), colour[1] * bright, colour[2] * bright))


def broadleaf(seed, height, spread, clusters, leaves, size, colour):
    """A tree with a round crown: a trunk, limbs to clusters of leaves."""
    rng, mesh = random.Random(seed), Mesh()
    fork = (0.0, 0.28 * height, 0.0)
    limb(mesh, (0, -0.3, 0), fork, 0.028 * height, 0.020 * height, 8)
    middle, half = 0.60 * height, 0.38 * height
    for _ in range(clusters):
        d = in_ball(rng)
        out = unit(d)
        reach = 0.55 + 0.35 * rng.random()
        centre = (out[0] * spread * reach, middle + out[1] * half * reach, out[2] * spread * reach)
        limb(mesh, fork, centre, 0.010 * height, 0.003 * height, 3)
        radius = spread * rng.uniform(0.28, 0.42)
        for _ in range(leaves):
            b = unit(in_ball(rng))
            at = add(centre, b, radius * rng.random() ** 0.3)
            leaf(mesh, rng, (at[0], centre[1] + 0.8 * (at[1] - centre[1]), at[2]),
                 add(b, out, 0.8), size, colour)
    return mesh


def fir(seed, height, spread, layers, leaves, size, colour):
    """A conifer: whorls of drooping boughs."""
    rng, mesh = random.Random(seed), Mesh()
    limb(mesh, (0, -0.3, 0), (0, height, 0), 0.02 * height, 0.002 * height, 6)
    for layer in range(layers):
        up = 0.1 + 0.88 * layer / layers
        radius = spread * (1 - up) ** 0.8
        boughs = 5 + int(9 * (1 - up))
        for bough in range(boughs):
            turn = 2 * math.pi * (bough + rng.random()) / boughs
            reach = radius * rng.uniform(0.8, 1.1)
            for k in range(leaves):
                r = reach * math.sqrt((k + rng.random()) / leaves)
                at = (r * math.cos(turn) + size * rng.uniform(-1, 1), height * up - 0.35 * r + size * rng.uniform(-1, 1),
                      r * math.sin(turn) + size * rng.uniform(-1, 1))
                leaf(mesh, rng, at, (math.cos(turn), 1.2, math.sin(turn)), size, colour)
    return mesh


def bush(seed, size_xyz, leaves, size, colour):
    """A piece of clipped hedge: leaves on and below the skin of a box with soft edges."""
    rng, mesh = random.Random(seed), Mesh()
    for _ in range(leaves):
        b = in_ball(rng)
        n = sum(abs(x) ** 5 for x in b) ** 0.2
        depth = rng.uniform(0.86, 1.0)
        skin = tuple(x / n * depth for x in b)
        at = (skin[0] * size_xyz[0] / 2, (skin[1] + 1) * size_xyz[1] / 2, skin[2] * size_xyz[2] / 2)
        leaf(mesh, rng, at, tuple(x ** 5 for x in skin), size * rng.uniform(0.7, 1.2), colour)
    return mesh


def tuft(seed, blades, radius, length, width, colour):
    """Grass: blades that are one triangle each."""
    rng, mesh = random.Random(seed), Mesh()
    for _ in range(blades):
        turn, off = rng.uniform(0, 2 * math.pi), radius * math.sqrt(rng.random())
        foot = (off * math.cos(turn), -0.02, off * math.sin(turn))
        tall = length * rng.uniform(0.5, 1.0)
        bend = add((0, 1, 0), in_ball(rng), 0.45)
        side = unit((rng.uniform(-1, 1), 0, rng.uniform(-1, 1)))
        bright = rng.uniform(0.7, 1.3)
        mesh.add([add(foot, side, width), add(foot, bend, tall), add(foot, side, -width)],
                 (colour[0] * bright * rng.uniform(0.85, 1.3), colour[1] * bright, colour[2] * bright))
    return mesh


def written(path, places):
    """A table for [[instances]]: x, y, z, turn, scale."""
    with open(path, 'w', encoding='ascii') as out:
        out.write('x_m,y_m,z_m,rotate_y_deg,scale\n')
        for x, y, z, turn, scale in places:
            out.write(f'{x:.1f},{y:.0f},{z:.1f},{turn:.0f},{scale:.2f}\n')


def groves(seed, count, groves_count, near, far, spread, kept):
    """Places of trees in groves between the distances `near` and `far` from the origin, where kept(x, z)."""
    rng = random.Random(seed)
    places = []
    middles = []
    while len(middles) < groves_count:
        r, turn = near + (far - near) * rng.random() ** 0.7, rng.uniform(0, 2 * math.pi)
        x, z = r * math.cos(turn), r * math.sin(turn)
        if kept(x, z):
            middles.append((x, z, spread * rng.uniform(0.5, 1.5)))
    while len(places) < count:
        x, z, wide = rng.choice(middles)
        x, z = rng.gauss(x, wide), rng.gauss(z, wide)
        if near < math.hypot(x, z) and kept(x, z):
            places.append((x, 0, z, rng.uniform(0, 360), rng.uniform(0.7, 1.2)))
    return places


def hedgerow(seed, start, end, step):
    """Places along a line, a little off it."""
    rng = random.Random(seed)
    length = math.dist(start, end)
    turn = -math.degrees(math.atan2(end[1] - start[1], end[0] - start[0]))
    return [(start[0] + (end[0] - start[0]) * t / length + rng.uniform(-0.2, 0.2),
             0, start[1] + (end[1] - start[1]) * t / length + rng.uniform(-0.2, 0.2),
             (turn + rng.choice((0, 180))) % 360, rng.uniform(0.9, 1.15))
            for t in (step * k for k in range(int(length / step)))]


def meadow(seed, count, near, far, azimuth_deg, half_angle_deg):
    """Places of tufts before a camera at the origin, as many in each part of the picture."""
    rng = random.Random(seed)
    places = []
    for _ in range(count):
        r = near * (far / near) ** rng.random()
        turn = math.radians(azimuth_deg + half_angle_deg * rng.uniform(-1, 1))
        places.append((r * math.sin(turn), 0, -r * math.cos(turn), rng.uniform(0, 360), rng.uniform(0.7, 1.3)))
    return places


# Trees that stand out in examples/landscape.toml.
OAKS = [(78, 0, -46, 40, 1.15), (160, 0, 84, 120, 1.1), (172, 0, 96, 10, 0.95), (150, 0, 100, 200, 1.0), (262, 0, -70, 77, 1.0)]
ASHES = [(92, 0, -60, 0, 0.8), (181, 0, 82, 90, 0.9), (240, 0, -84, 30, 1.0), (252, 0, -96, 160, 1.1)]


def in_valley(x, z):
    """Whether a place is off the floor of the valley of examples/landscape.toml, which leads east."""
    return abs(z + 0.09 * x) > 110


def main():
    folder = pathlib.Path(sys.argv[1])
    broadleaf(1, 12.0, 4.8, 34, 80, 0.30, (0.085, 0.150, 0.036)).write(folder / 'oak.ply')
    broadleaf(2, 15.0, 3.6, 34, 72, 0.30, (0.120, 0.185, 0.045)).write(folder / 'ash.ply')
    fir(3, 15.0, 3.6, 20, 14, 0.33, (0.045, 0.088, 0.040)).write(folder / 'fir.ply')
    bush(4, (2.2, 1.8, 1.0), 2600, 0.055, (0.050, 0.100, 0.026)).write(folder / 'hedge.ply')
    tuft(5, 60, 0.30, 0.20, 0.006, (0.085, 0.150, 0.030)).write(folder / 'grass.ply')

    written(folder / 'lawn.csv', meadow(18, 4000, 0.3, 9, 0, 100))
    written(folder / 'park-oak.csv', groves(19, 90, 12, 60, 700, 18, lambda x, z: True))
    written(folder / 'park-fir.csv', groves(20, 160, 8, 90, 900, 25, lambda x, z: True))


    written(folder / 'landscape-oak.csv', groves(11, 320, 40, 150, 1500, 22, in_valley) + OAKS)
    written(folder / 'landscape-ash.csv', groves(12, 700, 40, 220, 2000, 26, in_valley) + ASHES)
    written(folder / 'landscape-fir.csv', groves(13, 1800, 22, 380, 2400, 55, in_valley))
    written(folder / 'landscape-hedge.csv', hedgerow(14, (95, -120), (150, 30), 1.9) +
            hedgerow(15, (150, 30), (210, 150), 1.9) + hedgerow(16, (150, 30), (420, -10), 1.9))
    written(folder / 'landscape-grass.csv', meadow(17, 2600, 3.5, 45, 85, 58))


if __name__ == '__main__':
    main()
