# SPDX-License-Identifier: Apache-2.0
"""A desk lamp: brushed brass, a perforated shade, a glowing bulb, a spot on the wall, a turning globe.

    blender --background --factory-startup --python examples/blender/lamp.py -- lamp.glb
    dewbow render lamp.glb -o lamp.png
    dewbow render lamp.glb --frame 12 -o lamp_12.png        # the globe has turned
"""

import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from kit import *  # noqa: E402,F403


def holes(u, v):
    """A shade of sheet metal with rows of holes: alpha 0 is a hole."""
    row = math.floor(v * 10)
    x, y = (u * 36 + 0.5 * (row % 2)) % 1 - 0.5, (v * 10) % 1 - 0.5
    hole = math.hypot(x, y) < 0.27 and 1 <= row <= 8
    return (0.10, 0.22, 0.20, 0.0 if hole else 1.0)


def shade(material):
    vertices, faces, uvs, sides = [], [], [], 96
    for k in range(sides + 1):
        azimuth = 2 * math.pi * k / sides
        for radius, z, v in ((0.075, 0.26, 0.0), (0.045, 0.36, 1.0)):
            vertices.append((radius * math.cos(azimuth), radius * math.sin(azimuth), z))
            uvs.append((k / sides, v))
    for k in range(sides):
        faces.append([2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1])
    return mesh("Shade", vertices, faces, material, smooth=True, uv=lambda i: uvs[i])


def globe_colour(u, v):
    """Meridians and parallels over two seas."""
    line = min((u * 12) % 1, (v * 6) % 1) < 0.07
    land = math.sin(7 * u * math.pi) * math.cos(5 * v * math.pi + 3 * u) > 0.15
    return (0.9, 0.85, 0.7) if line else (0.25, 0.42, 0.16) if land else (0.07, 0.20, 0.45)


empty_scene()
brass = metal("Brass", (0.89, 0.72, 0.42), 0.28)
lathe("Foot", [(0.0, 0.0), (0.075, 0.0), (0.078, 0.006), (0.070, 0.014), (0.012, 0.022), (0.006, 0.03),
               (0.006, 0.27), (0.012, 0.275), (0.012, 0.285), (0.0, 0.286)], brass)
shade(textured("Shade", picture("shade", 1024, 512, holes, alpha=True), 0.5, "CLIP"))
bpy.ops.mesh.primitive_uv_sphere_add(radius=0.022, segments=48, ring_count=24, location=(0, 0, 0.31))
bulb = bpy.context.object
bulb.name = "Bulb"
bulb.data.materials.append(glow("Bulb", (1.0, 0.72, 0.42), 60.0))
bpy.ops.object.shade_smooth()

bpy.ops.mesh.primitive_uv_sphere_add(radius=0.06, segments=64, ring_count=32, location=(0.17, -0.06, 0.06))
globe = bpy.context.object
globe.name = "Globe"
globe.data.materials.append(textured("Globe", picture("globe", 512, 256, globe_colour), 0.25))
bpy.ops.object.shade_smooth()
globe.rotation_euler = (math.radians(23), 0, 0)
for frame, turn in ((0, 0), (24, 180)):
    globe.rotation_euler[2] = math.radians(turn)
    globe.keyframe_insert("rotation_euler", frame=frame)
bpy.context.scene.frame_end = 24
bpy.context.scene.frame_set(0)

plane("Desk", (2.0, 1.4), paint("Desk", (0.30, 0.17, 0.09), 0.35))
plane("Window", (0.8, 1.0), glow("Window", (0.75, 0.87, 1.0), 2.0), (-1.4, -0.9, 0.7), (90, 0, -60))
plane("Wall", (3.0, 2.0), paint("Wall", (0.62, 0.60, 0.55), 0.9), (0, 0.45, 0.9), (90, 0, 0))

camera((0.16, -1.02, 0.34), (0.055, 0.0, 0.185), 50)
export(output_path("lamp.glb"))
