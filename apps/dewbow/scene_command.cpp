// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "command.h"
#include "console.h"
#include "dewbow/import/import.h"
#include "scene_report.h"

namespace dewbow {

namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json json_of(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json json_of(Vec3 v) { return {v.x, v.y, v.z}; }

Json json_of(const MaterialFacts& m) {
    return {{"name", m.name},
            {"type", m.kind},
            {"shapes", m.shapes},
            {"glows", m.glows},
            {"glass", m.glass.empty() ? Json(nullptr) : Json(m.glass)},
            {"n_d", json_of(m.n_d)},
            {"v_d", json_of(m.v_d)},
            {"roughness", json_of(m.roughness)}};
}

Json json_of(const SceneReport& report, const ImportedScene& imported) {
    const Scene& scene = imported.scene;
    Json materials = Json::array(), textures = Json::array(), cameras = Json::array(),
         ignored = Json::array(), costs = Json::array(), skies = Json::array(),
         distant = Json::array(), rains = Json::array();
    for (const MaterialFacts& m : report.materials) materials.push_back(json_of(m));
    for (const TextureFacts& t : report.textures)
        textures.push_back({{"name", t.name},
                            {"width", t.width},
                            {"height", t.height},
                            {"bits", t.bits},
                            {"bytes", t.bytes}});
    for (const SkyFacts& s : report.skies)
        skies.push_back(
            {{"illuminance_lx", s.illuminance_lx}, {"zenith_luminance_cd_m2", s.zenith_cd_m2}});
    for (const DistantFacts& d : report.distant)
        distant.push_back({{"altitude_deg", d.altitude_deg},
                           {"azimuth_deg", d.azimuth_deg},
                           {"illuminance_lx", d.illuminance_lx}});
    for (const RainFacts& r : report.rains)
        rains.push_back({{"name", r.name},
                         {"region", r.region},
                         {"drops_per_m3", r.drops_per_m3},
                         {"rate_mm_per_h", r.mm_per_h},
                         {"extinction_per_km", r.extinction_per_km},
                         {"optical_depth", json_of(r.optical_depth)}});
    for (const CameraView& camera : scene.cameras) cameras.push_back(camera.name);
    for (const Diagnostic& d : imported.diagnostics)
        ignored.push_back({{"place", to_string(d.place)}, {"text", d.text}});
    for (const Cost& c : report.costs) costs.push_back({{"what", c.what}, {"why", c.why}});
    Json bounds = nullptr;
    if (!report.bounds.empty())
        bounds = {{"low_m", json_of(report.bounds.low)}, {"high_m", json_of(report.bounds.high)}};
    return {{"shapes", report.shapes},
            {"meshes", report.meshes},
            {"triangles", report.triangles},
            {"placed_triangles", report.placed_triangles},
            {"bounds", bounds},
            {"materials", materials},
            {"textures", textures},
            {"lights", report.lights},
            {"skies", skies},
            {"distant_lights", distant},
            {"rains", rains},
            {"cameras", cameras},
            {"camera", scene.camera.name},
            {"film", {{"width", scene.film.width}, {"height", scene.film.height}}},
            {"bytes", report.bytes()},
            {"ignored", ignored},
            {"costs", costs}};
}

/// "3 mesh, 1 sphere", or "none".
std::string counts_text(const std::map<std::string, std::size_t>& counts) {
    std::string text;
    for (const auto& [name, count] : counts)
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name);
    return text.empty() ? "none" : text;
}

std::string material_text(const MaterialFacts& m) {
    std::string text = fmt::format("  {}: {}", m.name, m.kind);
    if (m.n_d)
        text += fmt::format(", {}n_d {:.5f}, {}", m.glass.empty() ? "" : m.glass + ", ", *m.n_d,
                            m.v_d ? fmt::format("V_d {:.2f}", *m.v_d) : "no dispersion");
    if (m.roughness.value_or(0.0) > 0.0) text += fmt::format(", roughness {}", *m.roughness);
    if (m.glows) text += ", glows";
    return text + fmt::format(" ({} {})\n", m.shapes, m.shapes == 1 ? "shape" : "shapes");
}

std::string size_text(const Bounds& bounds) {
    if (bounds.empty()) return "nothing that has an end";
    const Vec3 size = bounds.high - bounds.low;
    return fmt::format(
        "{:.4g} x {:.4g} x {:.4g} m, from ({:.4g}, {:.4g}, {:.4g}) to ({:.4g}, {:.4g}, {:.4g})",
        size.x, size.y, size.z, bounds.low.x, bounds.low.y, bounds.low.z, bounds.high.x,
        bounds.high.y, bounds.high.z);
}

std::string memory_text(std::uint64_t bytes) {
    return fmt::format("{:.1f} MiB", double(bytes) / double(1 << 20));
}

/// Scenes may have very many materials; a page shows this many.
constexpr std::size_t kMostListed = 100;

template <class Rows, class Text>
std::string list_text(const char* title, const Rows& rows, Text text_of) {
    std::string text = fmt::format("{} ({})\n", title, rows.size());
    for (std::size_t i = 0; i < std::min(rows.size(), kMostListed); ++i) text += text_of(rows[i]);
    if (rows.size() > kMostListed) text += fmt::format("  … {} more\n", rows.size() - kMostListed);
    return text;
}

std::string text_of(const std::string& file, const SceneReport& report,
                    const ImportedScene& imported) {
    const Scene& scene = imported.scene;
    std::string text = fmt::format("{}\n", file);
    text += fmt::format("shapes     {}\n", counts_text(report.shapes));
    if (report.meshes > 0)
        text += fmt::format("triangles  {} in {} meshes; {} as placed\n", report.triangles,
                            report.meshes, report.placed_triangles);
    text += fmt::format("size       {}\n", size_text(report.bounds));
    text += fmt::format("lights     {}\n", counts_text(report.lights));
    for (const SkyFacts& s : report.skies)
        text += fmt::format("sky        {:.4g} lx on level ground, {:.4g} cd/m² overhead\n",
                            s.illuminance_lx, s.zenith_cd_m2);
    for (const DistantFacts& d : report.distant)
        text += fmt::format("distant    {:.4g} lx, {:.2f}° above the horizon, azimuth {:.2f}°\n",
                            d.illuminance_lx, d.altitude_deg, d.azimuth_deg);
    for (const RainFacts& r : report.rains) {
        text +=
            fmt::format("rain       {}: {:.4g} mm/h, {:.4g} drops/m³, extinction {:.4g} / km, {}",
                        r.name, r.mm_per_h, r.drops_per_m3, r.extinction_per_km, r.region);
        if (r.optical_depth) text += fmt::format(", optical depth {:.4g}", *r.optical_depth);
        text += "\n";
    }
    text += fmt::format("camera     {} (of {})\n", scene.camera.name, scene.cameras.size());
    text += fmt::format("film       {} x {} pixels\n", scene.film.width, scene.film.height);
    text +=
        fmt::format("memory     about {} for shapes and textures\n", memory_text(report.bytes()));
    text += list_text("materials", report.materials, material_text);
    if (!report.textures.empty())
        text += list_text("textures", report.textures, [](const TextureFacts& t) {
            return fmt::format("  {}: {} x {}, {} bits, {}\n", t.name, t.width, t.height, t.bits,
                               memory_text(t.bytes));
        });
    if (!imported.diagnostics.empty())
        text += list_text("not used, or changed", imported.diagnostics, [](const Diagnostic& d) {
            return fmt::format("  {}: {}\n", to_string(d.place), d.text);
        });
    if (!report.costs.empty())
        text += list_text("costs", report.costs,
                          [](const Cost& c) { return fmt::format("  {}: {}\n", c.what, c.why); });
    return text;
}

}  // namespace

int run_scene_check(const SceneCheckCommand& command) {
    const ImportedScene imported = load_scene(command.scene_file, command.load);
    const SceneReport report = report_of(imported.scene);
    if (command.json) {
        // Names in a file need not be UTF-8.
        print_data(json_of(report, imported)
                       .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) +
                   "\n");
    } else {
        print_data(text_of(command.scene_file, report, imported));
    }
    return kDone;
}

}  // namespace dewbow
