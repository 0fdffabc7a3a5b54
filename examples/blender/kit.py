# SPDX-License-Identifier: Apache-2.0
"""What the example scenes share: materials as an artist makes them in Blender, shapes, the export."""

import math
import os
import sys

import bpy

MM, CM = 0.001, 0.01


def output_path(default):
    """The path after `--` on Blender's command line."""
    if "--" in sys.argv and sys.argv[-1] != "--":
        return os.path.abspath(sys.argv[-1])
    return os.path.abspath(default)


def empty_scene():
    bpy.ops.wm.read_factory_settings(use_empty=True)


def export(path):
    """Writes a .glb with everything that the glTF exporter knows of a scene."""
    bpy.ops.export_scene.gltf(filepath=path, export_format="GLB", export_cameras=True,
                              export_lights=True, export_extras=True, export_apply=True)


# ---- materials ----------------------------------------------------------------------------------


def principled(name, **inputs):
    """A material of one Principled BSDF. Keys are its inputs, with _ for spaces."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    shader = material.node_tree.nodes["Principled BSDF"]
    for key, value in inputs.items():
        shader.inputs[key.replace("_", " ")].default_value = value
    return material


def metal(name, colour, roughness):
    return principled(name, Base_Color=(*colour, 1), Metallic=1.0, Roughness=roughness)


def paint(name, colour, roughness=0.5, **more):
    return principled(name, Base_Color=(*colour, 1), Roughness=roughness, **more)


def glow(name, colour, strength):
    return principled(name, Base_Color=(0, 0, 0, 1), Specular=0.0, Emission=(*colour, 1),
                      Emission_Strength=strength)


def volume_group():
    """The node group by which the glTF exporter learns that a body has a thickness."""
    name = "glTF Material Output"
    group = bpy.data.node_groups.get(name)
    if group is None:
        group = bpy.data.node_groups.new(name, "ShaderNodeTree")
        group.inputs.new("NodeSocketFloat", "Thickness")
        group.nodes.new("NodeGroupInput")
    return group


def glass(name, ior, catalogue_name=None, colour=None, depth=None):
    """A body of glass. `catalogue_name` is a custom property of the material, which Dewbow takes for
    its dispersion; `colour` is what white light becomes after `depth` metres."""
    material = principled(name, Base_Color=(1, 1, 1, 1), Transmission=1.0, IOR=ior, Roughness=0.0)
    nodes, links = material.node_tree.nodes, material.node_tree.links
    thickness = nodes.new("ShaderNodeGroup")
    thickness.node_tree = volume_group()
    thickness.inputs["Thickness"].default_value = 1.0
    if colour:
        absorption = nodes.new("ShaderNodeVolumeAbsorption")
        absorption.inputs["Color"].default_value = (*colour, 1)
        absorption.inputs["Density"].default_value = 1.0 / depth
        links.new(absorption.outputs[0], nodes["Material Output"].inputs["Volume"])
    if catalogue_name:
        material["glass"] = catalogue_name
    return material


def picture(name, width, height, colour_at, alpha=False):
    """An image whose pixel (x, y), from the lower left, is colour_at(x / width, y / height)."""
    image = bpy.data.images.new(name, width, height, alpha=alpha)
    pixels = []
    for y in range(height):
        for x in range(width):
            colour = colour_at((x + 0.5) / width, (y + 0.5) / height)
            pixels.extend(colour if len(colour) == 4 else (*colour, 1.0))
    image.pixels = pixels
    image.file_format = "PNG"
    image.pack()
    return image


def textured(name, image, roughness=0.5, blend=None):
    """A surface that shows `image`; `blend` is CLIP or BLEND where its alpha counts."""
    material = principled(name, Roughness=roughness)
    nodes, links = material.node_tree.nodes, material.node_tree.links
    texture = nodes.new("ShaderNodeTexImage")
    texture.image = image
    shader = nodes["Principled BSDF"]
    links.new(texture.outputs["Color"], shader.inputs["Base Color"])
    if blend:
        links.new(texture.outputs["Alpha"], shader.inputs["Alpha"])
        material.blend_method = blend
    return material


# ---- shapes -------------------------------------------------------------------------------------


def mesh(name, vertices, faces, material, smooth=False, uv=None):
    """`uv`, if given, is a function of a vertex' index."""
    data = bpy.data.meshes.new(name)
    data.from_pydata(vertices, [], faces)
    data.validate()
    data.materials.append(material)
    if smooth:
        for polygon in data.polygons:
            polygon.use_smooth = True
    if uv:
        layer = data.uv_layers.new()
        for loop in data.loops:
            layer.data[loop.index].uv = uv(loop.vertex_index)
    thing = bpy.data.objects.new(name, data)
    bpy.context.collection.objects.link(thing)
    return thing


def lathe(name, outline, material, sides=96, smooth=True):
    """The body that a closed outline of (radius, height) makes when it turns about z. Points on the
    axis are shared."""
    vertices, rings = [], []
    for radius, height in outline:
        if radius == 0.0:
            rings.append([len(vertices)] * sides)
            vertices.append((0.0, 0.0, height))
            continue
        rings.append([len(vertices) + k for k in range(sides)])
        for k in range(sides):
            azimuth = 2 * math.pi * k / sides
            vertices.append((radius * math.cos(azimuth), radius * math.sin(azimuth), height))
    faces = []
    pairs = list(zip(rings, rings[1:]))
    if outline[0][0] != 0.0 or outline[-1][0] != 0.0:
        pairs.append((rings[-1], rings[0]))
    for lower, upper in pairs:
        for k in range(sides):
            following = (k + 1) % sides
            corners = [lower[k], lower[following], upper[following], upper[k]]
            face = [c for i, c in enumerate(corners) if c != corners[i - 1]]
            if len(face) >= 3:
                faces.append(face)
    return mesh(name, vertices, faces, material, smooth)


def plane(name, size, material, location=(0, 0, 0), rotation=(0, 0, 0)):
    bpy.ops.mesh.primitive_plane_add(size=1, location=location,
                                     rotation=[math.radians(a) for a in rotation])
    thing = bpy.context.object
    thing.name = name
    thing.scale = (size[0], size[1], 1)
    thing.data.materials.append(material)
    return thing


def camera(location, target, focal_length_mm=50.0):
    from mathutils import Vector

    data = bpy.data.cameras.new("Camera")
    data.lens = focal_length_mm
    thing = bpy.data.objects.new("Camera", data)
    thing.location = location
    thing.rotation_euler = (Vector(target) - Vector(location)).to_track_quat("-Z", "Y").to_euler()
    bpy.context.collection.objects.link(thing)
    bpy.context.scene.camera = thing
    return thing
