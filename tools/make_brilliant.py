#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes examples/brilliant.obj: a round brilliant of 57 facets, girdle diameter 1, table up (+y).

The stone is the intersection of half spaces, one a facet. Proportions (of the girdle's diameter):
table 57 %, crown angle 34.5 deg, pavilion angle 40.75 deg, girdle 3 %, star length 50 %, lower
halves 75 %: the middle of the range that the GIA grades as excellent.

    tools/make_brilliant.py > examples/brilliant.obj
"""

import itertools
import math

TABLE, GIRDLE, STAR, LOWER = 0.57, 0.03, 0.50, 0.75
CROWN, PAVILION = math.radians(34.5), math.radians(40.75)
GIRDLE_SIDES = 64
SAME = 1e-9  # lengths and distances closer than this are one: far below any edge, far above rounding


def polar(radius, azimuth, height):
    return (radius * math.cos(azimuth), height, radius * math.sin(azimuth))


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def plane_through(a, b, c):
    """(n, d) with n . x <= d inside; the centre of the stone is inside."""
    n = cross(sub(b, a), sub(c, a))
    length = math.sqrt(dot(n, n))
    n = tuple(x / length for x in n)
    d = dot(n, a)
    return (n, d) if d > 0 else (tuple(-x for x in n), -d)


def facets():
    half = GIRDLE / 2
    top = half + (0.5 - TABLE / 2) * math.tan(CROWN)
    yield ((0.0, 1.0, 0.0), top)
    eighth, sixteenth = math.pi / 4, math.pi / 8
    table_side = TABLE / 2 * math.cos(sixteenth)
    star_radius = table_side + STAR * (0.5 - table_side)
    star_height = half + (0.5 - star_radius * math.cos(sixteenth)) * math.tan(CROWN)
    lower_radius = 0.5 * (1 - LOWER)
    lower_height = -half - (0.5 - lower_radius * math.cos(sixteenth)) * math.tan(PAVILION)
    for k in range(8):
        main, middle, following = k * eighth, (k + 0.5) * eighth, (k + 1) * eighth
        normal = polar(math.sin(CROWN), main, math.cos(CROWN))
        yield (normal, dot(normal, polar(0.5, main, half)))
        normal = polar(math.sin(PAVILION), main, -math.cos(PAVILION))
        yield (normal, dot(normal, polar(0.5, main, -half)))
        star = polar(star_radius, middle, star_height)
        yield plane_through(polar(TABLE / 2, main, top), polar(TABLE / 2, following, top), star)
        lower = polar(lower_radius, middle, lower_height)
        for azimuth in (main, following):
            yield plane_through(star, polar(0.5, azimuth, half), polar(0.5, middle, half))
            yield plane_through(lower, polar(0.5, azimuth, -half), polar(0.5, middle, -half))


def girdle():
    for k in range(GIRDLE_SIDES):
        azimuth = (k + 0.5) * 2 * math.pi / GIRDLE_SIDES
        yield (polar(1.0, azimuth, 0.0), 0.5 * math.cos(math.pi / GIRDLE_SIDES))


def meeting_point(p, q, r):
    (a, da), (b, db), (c, dc) = p, q, r
    bc, ca, ab = cross(b, c), cross(c, a), cross(a, b)
    determinant = dot(a, bc)
    if abs(determinant) < 1e-7:
        return None
    return tuple((da * x + db * y + dc * z) / determinant for x, y, z in zip(bc, ca, ab))


def corners(planes):
    points = []
    for p, q, r in itertools.combinations(planes, 3):
        x = meeting_point(p, q, r)
        if x is None or dot(x, x) > 1 or any(dot(n, x) > d + SAME for n, d in planes):
            continue
        if all(dot(sub(x, y), sub(x, y)) > SAME for y in points):
            points.append(x)
    return points


def polygon(plane, points):
    """Indices of the corners on `plane`, counter-clockwise from outside."""
    n, d = plane
    on = [i for i, x in enumerate(points) if abs(dot(n, x) - d) < 1e-6]
    centre = tuple(sum(points[i][k] for i in on) / len(on) for k in range(3))
    u = sub(points[on[0]], centre)
    v = cross(n, u)
    return sorted(on, key=lambda i: math.atan2(dot(sub(points[i], centre), v), dot(sub(points[i], centre), u)))


def main():
    cut = list(facets())
    planes = cut + list(girdle())
    points = corners(planes)
    faces = [face for face in (polygon(p, points) for p in planes) if len(face) >= 3]
    print("# A round brilliant of 57 facets, made by tools/make_brilliant.py; girdle diameter 1, table up.")
    print(f"# {len(points)} corners, {len(cut)} facets and a girdle of {GIRDLE_SIDES} sides.")
    for x in points:
        print("v " + " ".join(f"{c:.9f}" for c in x))
    for face in faces:
        print("f " + " ".join(str(i + 1) for i in face))


if __name__ == "__main__":
    main()
