# SPDX-License-Identifier: Apache-2.0
"""A gold ring with a diamond, at its true size, under soft boxes and small lamps.

    blender --background --factory-startup --python examples/blender/ring.py -- ring.glb
    dewbow render ring.glb -o ring.png
"""

import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from kit import *  # noqa: E402,F403

STONE = 6.5 * MM  # diameter of a brilliant of one carat
RADIUS, BAND = 9.0 * MM, 1.1 * MM


def brilliant(name, material):
    """The stone that examples/brilliant.obj holds: girdle diameter 1, table up (+y)."""
    vertices, faces = [], []
    folder = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    with open(os.path.join(folder, "brilliant.obj")) as file:
        for line in file:
            words = line.split()
            if words and words[0] == "v":
                x, y, z = (float(w) * STONE for w in words[1:])
                vertices.append((x, -z, y))
            elif words and words[0] == "f":
                faces.append([int(w) - 1 for w in words[1:]])
    return mesh(name, vertices, faces, material)


empty_scene()
gold = metal("Gold", (1.0, 0.77, 0.34), 0.18)
diamond = glass("Diamond", 2.417, "gem/diamond")
velvet = paint("Table", (0.05, 0.055, 0.07), 0.35)

bpy.ops.mesh.primitive_torus_add(major_radius=RADIUS, minor_radius=BAND, major_segments=128,
                                 minor_segments=32, location=(0, 0, RADIUS + BAND),
                                 rotation=(math.radians(90), 0, 0))
band = bpy.context.object
band.name = "Band"
band.data.materials.append(gold)
bpy.ops.object.shade_smooth()

top = 2 * RADIUS + 2 * BAND
stone = brilliant("Stone", diamond)
stone.location = (0, 0, top + 0.36 * STONE)
for k in range(6):
    azimuth = math.radians(60 * k + 30)
    prong = lathe("Prong", [(0.0, 0.0), (0.4 * MM, 0.0), (0.45 * MM, 3.2 * MM), (0.3 * MM, 3.6 * MM),
                            (0.0, 3.7 * MM)], gold, sides=24)
    lean = math.radians(18)
    foot = 0.24 * STONE
    prong.location = (foot * math.cos(azimuth), foot * math.sin(azimuth), top - 0.5 * MM)
    prong.rotation_euler = (0, lean, azimuth)
    prong.rotation_mode = "XYZ"

plane("Table", (0.6, 0.6), velvet)
plane("Soft box", (60 * MM, 40 * MM), glow("Soft box", (1.0, 0.97, 0.92), 5.0), (-50 * MM, -30 * MM, 75 * MM),
      (150, -35, 0))
plane("Strip", (12 * MM, 90 * MM), glow("Strip", (0.92, 0.96, 1.0), 4.0), (60 * MM, 10 * MM, 60 * MM),
      (0, 228, 0))
lamp = glow("Lamps", (1.0, 1.0, 1.0), 160.0)
for k in range(14):
    azimuth, height = math.radians(137.5 * k), 55 * MM + 4 * MM * (k % 5)
    reach = 14 * MM + 4.5 * MM * k
    bpy.ops.mesh.primitive_uv_sphere_add(radius=1.3 * MM, segments=16, ring_count=8,
                                         location=(reach * math.cos(azimuth), reach * math.sin(azimuth), height))
    bpy.context.object.data.materials.append(lamp)

camera((26 * MM, -66 * MM, 40 * MM), (0, 0, 12.5 * MM), 55)
export(output_path("ring.glb"))
