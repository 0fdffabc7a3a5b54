// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/import.h"

#include <algorithm>

#include "dewbow/import/extension.h"
#include "dewbow/import/gltf/gltf.h"
#include "dewbow/import/mesh/mesh_file.h"
#include "dewbow/import/one_line.h"
#include "dewbow/import/overrides.h"
#include "dewbow/import/parsed_scene.h"
#include "dewbow/import/toml/scene_toml.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {
namespace {

using Path = std::filesystem::path;

struct SceneFormat {
    std::string extension;
    ParsedScene (*load)(const Path&, const LoadOptions&);
};

ParsedScene load_scene_file(const Path& path, const LoadOptions& options) {
    return load_toml(path, options.settings);
}
ParsedScene load_gltf_file(const Path& path, const LoadOptions& options) {
    if (!options.frame) return load_gltf(path);
    return load_gltf(path, *options.frame / options.frames_per_second);
}
ParsedScene load_mesh_file(const Path& path, const LoadOptions&) { return load_mesh_scene(path); }

const std::vector<SceneFormat>& scene_formats() {
    static const std::vector<SceneFormat> formats = {
        {".toml", load_scene_file}, {".gltf", load_gltf_file}, {".glb", load_gltf_file},
        {".obj", load_mesh_file},   {".ply", load_mesh_file},  {".stl", load_mesh_file},
    };
    return formats;
}

const SceneFormat& format_of(const std::filesystem::path& path) {
    const std::string extension = extension_of(path);
    for (const SceneFormat& format : scene_formats()) {
        if (format.extension == extension) return format;
    }
    if (std::error_code error; std::filesystem::is_directory(path, error))
        throw InputError(SourcePlace{path.string(), 0, 0, {}},
                         "this is a folder; a scene is a file");
    throw InputError({path.string(), 0, 0, {}},
                     extension.empty() ? std::string("a scene file needs an extension")
                                       : "\"" + extension + "\" is no scene format that is read",
                     {}, "expected one of .toml, .gltf, .glb, .obj, .ply, .stl");
}

ParsedScene parse(const Path& path, const LoadOptions& options) {
    const SceneFormat& format = format_of(path);
    if (options.frame && format.load != load_gltf_file) {
        throw UsageError("--frame shows the animations of a .gltf or .glb file",
                         "this is " + path.string());
    }
    ParsedScene parsed = format.load(path, options);
    if (options.settings.empty() || format.extension == ".toml") return parsed;
    return with_settings(path, std::move(parsed), options.settings);
}

/// The studio as bright as suits the film's white.
void add_studio(Scene& scene) {
    auto studio = std::make_shared<ImageEnvironment>(*make_studio_environment());
    studio->scale = environment_scale_of_white(scene.film);
    scene.lights.push_back(std::shared_ptr<const ImageEnvironment>(studio));
}

/// A note lists the names of this many cameras.
constexpr std::size_t kMostNamesListed = 8;

/// The camera that takes the picture.
void choose_camera(const SourcePlace& file, const std::string& wish, ParsedScene& parsed) {
    Scene& scene = parsed.scene;
    std::vector<std::string> names;
    for (const CameraView& camera : scene.cameras) {
        names.push_back(camera.name);
        if (camera.name != wish) continue;
        scene.camera = camera;
        return;
    }
    if (!wish.empty()) {
        throw UsageError(
            one_line("--camera " + wish + ": there is no camera \"" + wish + "\""),
            names.empty() ? "the scene has no camera" : one_line(hint_for(wish, names)));
    }
    if (names.empty()) {
        scene.camera = frame_bounds(bounds_of(scene), double(scene.film.width) / scene.film.height);
        return;
    }
    scene.camera = scene.cameras.front();
    if (parsed.camera_stated || names.size() == 1) return;
    std::string others;
    for (std::size_t i = 1; i < std::min(names.size(), kMostNamesListed); ++i)
        others += (i == 1 ? "" : ", ") + one_line(names[i]);
    if (names.size() > kMostNamesListed) others += ", …";
    parsed.diagnostics.push_back(
        {file, "camera \"" + one_line(names.front()) +
                   "\" takes the picture; --camera NAME picks another: " + others});
}

void complete(const SourcePlace& file, const LoadOptions& options, ParsedScene& parsed) {
    Scene& scene = parsed.scene;
    choose_camera(file, options.camera, parsed);
    if (!brings_light(scene, parsed.least_lamp_luminance)) add_studio(scene);
}

}  // namespace

const std::vector<std::string>& scene_extensions() {
    static const std::vector<std::string> extensions = [] {
        std::vector<std::string> all;
        for (const SceneFormat& format : scene_formats()) all.push_back(format.extension);
        return all;
    }();
    return extensions;
}

ImportedScene load_scene(const std::filesystem::path& path, const LoadOptions& options) {
    ParsedScene parsed = parse(path, options);
    override_glasses(parsed.scene, options.glasses, parsed.diagnostics);
    if (!options.environment.empty())
        override_environment(parsed.scene, options.environment, parsed.diagnostics);
    if (options.width > 0) parsed.scene.film.width = options.width;
    if (options.height > 0) parsed.scene.film.height = options.height;
    complete({path.string(), 0, 0, {}}, options, parsed);
    try {
        validate(parsed.scene);
    } catch (const InputError& error) {  // it knows what is wrong, and not in which file
        throw InputError({path.string(), 0, 0, {}}, one_line(error.sentence()), {},
                         one_line(error.hint()));
    }
    return {std::move(parsed.scene), std::move(parsed.diagnostics)};
}

}  // namespace dewbow
