// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/mesh/obj_scene.h"

#include <fmt/format.h>

#include "dewbow/base/file.h"
#include "dewbow/import/mesh/clean.h"
#include "dewbow/import/mesh/mtl_material.h"
#include "dewbow/import/mesh/obj.h"
#include "dewbow/import/mesh/words.h"
#include "dewbow/import/nested_error.h"

namespace dewbow {
namespace {

/// Reflectance of a surface that a file says nothing about: a photographer's mid to light grey.
constexpr double kNeutralGrey = 0.6;
/// Of one library; a scene's are a few kilobytes.
constexpr std::uint64_t kMaxLibraryBytes = std::uint64_t{64} << 20;

/// The materials of the libraries that an OBJ file names.
class Libraries {
public:
    Libraries(const std::filesystem::path& obj, Diagnostics& diagnostics)
        : obj_(obj), diagnostics_(diagnostics) {}

    void load(const ObjLibraries& libraries) {
        // One name with spaces, or several names between them.
        std::vector<std::string_view> names = {libraries.names};
        if (!find(libraries.names)) {
            names.clear();
            split_words(libraries.names, names);
        }
        for (const std::string_view name : names) load_one(std::string(name), libraries.line);
    }

    /// Whether there is a material of that name.
    bool has(const std::string& name) const { return materials_.contains(name); }
    /// The one of that name, which there is.
    Material make(const std::string& name) {
        const Entry& entry = materials_.at(name);
        return material_of(entry.material, *entry.pictures, diagnostics_);
    }
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const auto& [name, entry] : materials_) all.push_back(name);
        return all;
    }

private:
    struct Entry {
        MtlMaterial material;
        std::shared_ptr<MtlPictures> pictures;
    };

    std::optional<std::filesystem::path> find(const std::string& name) const {
        std::error_code error;
        try {
            const auto path = resolve_inside(folder(), name);
            if (std::filesystem::exists(path, error)) return path;
        } catch (const InputError&) {  // leads out of the folder
        }
        return std::nullopt;
    }
    std::filesystem::path folder() const {
        return obj_.has_parent_path() ? obj_.parent_path() : std::filesystem::path(".");
    }

    void load_one(const std::string& name, std::size_t line) {
        const SourcePlace place{obj_.string(), line, 0, {}};
        std::string text;
        try {
            text = read_file(resolve_inside(folder(), name), kMaxLibraryBytes);
        } catch (const InputError& error) {
            diagnostics_.push_back(
                {place, fmt::format("the material library \"{}\" is not read: {}", name,
                                    error.sentence())});
            return;
        }
        const std::filesystem::path path = folder() / name;
        const auto pictures = std::make_shared<MtlPictures>(path, pictures_, diagnostics_);
        for (MtlMaterial& material : parse_mtl(path.string(), text, diagnostics_))
            materials_.try_emplace(material.name, Entry{material, pictures});
    }

    std::filesystem::path obj_;
    Diagnostics& diagnostics_;
    std::shared_ptr<TexturePictures> pictures_ = std::make_shared<TexturePictures>();
    std::map<std::string, Entry> materials_;
};

/// Adds materials to a scene when they are first used.
class MaterialIndex {
public:
    MaterialIndex(Scene& scene, Libraries& libraries, const std::string& file,
                  Diagnostics& diagnostics)
        : scene_(scene), libraries_(libraries), file_(file), diagnostics_(diagnostics) {}

    int of(const ObjPart& part) {
        const auto found = index_of_.find(part.material);
        if (found != index_of_.end()) return found->second;
        const bool known = libraries_.has(part.material);
        if (!known && !part.material.empty()) note_missing(part);
        const int index =
            known ? scene_.add(libraries_.make(part.material)) : grey(!part.mesh.colours.empty());
        return index_of_[part.material] = index;
    }

private:
    int grey(bool vertex_colours) {
        if (!grey_) grey_ = scene_.add(default_material(vertex_colours));
        return *grey_;
    }
    void note_missing(const ObjPart& part) {
        const std::vector<std::string> names = libraries_.names();
        const std::string hint = hint_for(part.material, names);
        diagnostics_.push_back({{file_, part.material_line, 0, {}},
                                fmt::format("no library holds the material \"{}\": it is grey{}",
                                            part.material, hint.empty() ? "" : "; " + hint)});
    }

    Scene& scene_;
    Libraries& libraries_;
    const std::string& file_;
    Diagnostics& diagnostics_;
    std::map<std::string, int> index_of_;
    std::optional<int> grey_;
};

}  // namespace

Material default_material(bool vertex_colours) {
    Diffuse surface{make_constant(kNeutralGrey)};
    surface.reflectance.vertex_colour = vertex_colours;
    return {kDefaultMaterial, surface};
}

ParsedScene load_obj_scene(const std::filesystem::path& path) {
    ParsedScene parsed;
    parsed.scene = make_empty_scene();
    const std::string file = path.string();
    ObjModel model =
        parse_obj(file, read_file(path), ObjDivision::objects_and_materials, parsed.diagnostics);
    if (model.parts.empty()) throw InputError(SourcePlace{file, 0, 0, {}}, "holds no triangle");
    Libraries libraries(path, parsed.diagnostics);
    for (const ObjLibraries& library : model.libraries) libraries.load(library);
    MaterialIndex materials(parsed.scene, libraries, file, parsed.diagnostics);

    MeshRepairs repairs;
    for (ObjPart& part : model.parts) {
        repairs += clean(part.mesh);
        if (part.mesh.triangles.empty()) continue;
        Shape shape;
        shape.name = part.name.empty() ? path.stem().string() : part.name;
        shape.material = materials.of(part);
        part.mesh.name = shape.name;
        shape.geometry = std::make_shared<const Mesh>(std::move(part.mesh));
        parsed.scene.shapes.push_back(std::move(shape));
    }
    repairs.report({file, 0, 0, {}}, parsed.diagnostics);
    if (parsed.scene.shapes.empty())
        throw InputError(SourcePlace{file, 0, 0, {}}, repairs.sentence_of_nothing_left());
    return parsed;
}

}  // namespace dewbow
