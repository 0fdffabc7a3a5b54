// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common.h"
#include "dewbow/base/file.h"

// Blender's Cycles knows no dispersion: its spectra are three numbers. What artists do instead is a
// glass of three glasses, each of one primary and with an index of its own. It converges to three
// pictures, one over the other.

namespace dewbow::bench {
namespace {

/// Dominant wavelengths of sRGB's primaries against D65.
constexpr Wavelength kPrimaries[] = {611.4 * unit::nm, 549.1 * unit::nm, 464.2 * unit::nm};

/// Sides of the polygon that stands for a disc: its area is 1 − 1e-4 of the disc's.
constexpr int kDiscSides = 256;

/// Cycles' own greatest number of bounces.
constexpr int kMostBounces = 1024;

std::string list_of(const std::vector<Vec3>& points) {
    std::string text;
    for (const Vec3& p : points) text += fmt::format("({}), ", joined(p));
    return "[" + text + "]";
}

std::vector<Vec3> outline(const PlainLamp& lamp) {
    if (lamp.shape == LampShape::rectangle) {
        const auto c = corners(lamp);
        return {c.begin(), c.end()};
    }
    std::vector<Vec3> points;
    for (int i = 0; i < kDiscSides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kDiscSides;
        points.push_back(lamp.centre + lamp.half_u * std::cos(angle) +
                         lamp.half_v * std::sin(angle));
    }
    return points;
}

constexpr const char* kBegin = R"(import bpy, math, os
from mathutils import Matrix

for thing in list(bpy.data.objects):
    bpy.data.objects.remove(thing)
scene = bpy.context.scene


def shaders(name):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    material.node_tree.nodes.clear()
    return material, material.node_tree.nodes, material.node_tree.links


def add(name, vertices, faces, material):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, [], faces)
    mesh.materials.append(material)
    scene.collection.objects.link(bpy.data.objects.new(name, mesh))


def lamp(name, outline, colour, two_sided):
    material, nodes, links = shaders(name)
    emission = nodes.new('ShaderNodeEmission')
    emission.inputs['Color'].default_value = (*colour, 1)
    if not two_sided:
        geometry = nodes.new('ShaderNodeNewGeometry')
        front = nodes.new('ShaderNodeMath')
        front.operation = 'SUBTRACT'
        front.inputs[0].default_value = 1
        links.new(geometry.outputs['Backfacing'], front.inputs[1])
        links.new(front.outputs[0], emission.inputs['Strength'])
    output = nodes.new('ShaderNodeOutputMaterial')
    links.new(emission.outputs[0], output.inputs['Surface'])
    add(name, outline, [tuple(range(len(outline)))], material)


def glass(indices):
    material, nodes, links = shaders('glass')
    sum = None
    for channel, index in enumerate(indices):
        bsdf = nodes.new('ShaderNodeBsdfGlass')
        bsdf.distribution = 'SHARP'
        bsdf.inputs['Roughness'].default_value = 0
        bsdf.inputs['IOR'].default_value = index
        bsdf.inputs['Color'].default_value = [float(c == channel) for c in range(3)] + [1]
        if sum:
            both = nodes.new('ShaderNodeAddShader')
            links.new(sum, both.inputs[0])
            links.new(bsdf.outputs[0], both.inputs[1])
            sum = both.outputs[0]
        else:
            sum = bsdf.outputs[0]
    output = nodes.new('ShaderNodeOutputMaterial')
    links.new(sum, output.inputs['Surface'])
    return material


)";

constexpr const char* kSettings = R"(
scene.render.engine = 'CYCLES'
scene.render.resolution_percentage = 100
scene.render.threads_mode = 'FIXED'
scene.render.use_compositing = False
scene.render.use_sequencer = False
scene.render.image_settings.file_format = 'OPEN_EXR'
scene.render.image_settings.color_mode = 'RGB'
scene.render.image_settings.color_depth = '32'
scene.view_settings.view_transform = 'Standard'
cycles = scene.cycles
cycles.device = 'CPU'
cycles.use_adaptive_sampling = False
cycles.use_denoising = False
cycles.pixel_filter_type = 'BOX'
cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
cycles.blur_glossy = 0
cycles.light_sampling_threshold = 0
cycles.caustics_reflective = cycles.caustics_refractive = True
cycles.diffuse_bounces = cycles.glossy_bounces = cycles.transmission_bounces = cycles.max_bounces
bpy.ops.render.render(write_still=True)
)";

std::string camera_text(const PlainCamera& camera) {
    std::string rows;
    for (const int axis : {0, 1, 2})
        rows += fmt::format("({}, {}, {}, {}), ", camera.right[axis], camera.up[axis],
                            -camera.forward[axis], camera.eye[axis]);
    return fmt::format(R"(
camera = bpy.data.cameras.new('camera')
camera.sensor_fit = 'VERTICAL'
camera.sensor_height = {} * camera.lens
camera.clip_start, camera.clip_end = 1e-4, 1e6
view = bpy.data.objects.new('camera', camera)
view.matrix_world = Matrix([{}(0, 0, 0, 1)])
scene.collection.objects.link(view)
scene.camera = view
scene.render.resolution_x, scene.render.resolution_y = {}, {}
)",
                       2.0 * camera.tan_half_vertical_fov, rows, camera.width, camera.height);
}

std::string world_text(const Colour<LinearSrgb>& colour) {
    return fmt::format(R"(
world = bpy.data.worlds.new('surroundings')
world.use_nodes = True
world.node_tree.nodes['Background'].inputs['Color'].default_value = ({}, 1)
scene.world = world
)",
                       joined(colour));
}

class Blender : public Contestant {
public:
    explicit Blender(std::filesystem::path program)
        : program_(std::move(program)), version_(version_line(program_, "--version", "Blender ")) {}
    std::string name() const override { return "blender-rgb"; }
    std::string version() const override { return version_ + ", Cycles"; }
    bool splits_spectrum() const override { return false; }
    bool converges_to_truth() const override { return false; }

    std::vector<std::string> write(const Order& order) const override {
        const std::filesystem::path script =
            order.folder / "scene.py";  // Blender asks PWD where it is
        write_file_atomically(script, blender_script(scene_order(order)));
        return {program_.string(), "--background", "--factory-startup", "--python-exit-code", "1",
                "--python",        script.string()};
    }
    Picture read(const Order& order) const override { return read_left_picture(order); }

private:
    std::filesystem::path program_;
    std::string version_;
};

}  // namespace

std::string blender_script(const SceneOrder& order) {
    const PlainScene& scene = order.scene;
    std::string text = kBegin;
    for (std::size_t i = 0; i < scene.lamps.size(); ++i)
        text +=
            fmt::format("lamp('lamp {}', {}, ({}), {})\n", i, list_of(outline(scene.lamps[i])),
                        joined(scene.lamps[i].colour), scene.lamps[i].two_sided ? "True" : "False");
    std::string indices, faces;
    for (const Wavelength primary : kPrimaries)
        indices += fmt::format("{}, ", relative_index(scene, primary));
    for (const auto& t : scene.bodies[0].triangles)
        faces += fmt::format("({}, {}, {}), ", t[0], t[1], t[2]);
    text += fmt::format("add('body', {}, [{}], glass([{}]))\n", list_of(scene.bodies[0].vertices),
                        faces, indices);
    text += world_text(scene.surroundings_colour) + camera_text(scene.camera);
    text += fmt::format(
        "scene.render.threads = {}\nscene.cycles.samples = {}\nscene.cycles.seed = {}\n"
        "scene.cycles.max_bounces = {}\nscene.render.filepath = "
        "os.path.join(os.path.dirname(__file__), '{}')\n",
        order.threads, order.knobs.samples_per_pixel, order.knobs.seed & 0x7fffffffu,
        std::min(order.max_depth, kMostBounces), kPictureFile);
    return text + kSettings;
}

std::unique_ptr<Contestant> find_blender(const Programs& programs) {
    const auto program = programs.find("blender");
    if (!program) return nullptr;
    return std::make_unique<Blender>(*program);
}

}  // namespace dewbow::bench
