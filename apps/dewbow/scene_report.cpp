// SPDX-License-Identifier: Apache-2.0
#include "scene_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "dewbow/optics/catalogue.h"
#include "dewbow/sky/cloud_bank.h"
#include "dewbow/sky/drop_cloud.h"
#include "dewbow/spectrum/cie.h"
#include "memory.h"

namespace dewbow {

namespace {

/// An estimate of the tree and of what hits are computed from, for a triangle of a mesh.
constexpr std::uint64_t kTriangleBytes = 200;
/// The same for a shape, beside the shape itself.
constexpr std::uint64_t kShapeBytes = sizeof(Shape) + 300;

constexpr const char* kShapeNames[] = {"mesh", "sphere", "disc", "rectangle",
                                       "box",  "prism",  "plane"};
constexpr const char* kSurfaceNames[] = {
    "black", "diffuse", "mirror", "glass", "thin-glass", "metal", "metallic-roughness", "mix"};

struct LightName {
    const char* operator()(const PointLight&) const { return "point"; }
    const char* operator()(const SpotLight&) const { return "spot"; }
    const char* operator()(const DistantLight&) const { return "distant"; }
    const char* operator()(const UniformEnvironment&) const { return "environment"; }
    const char* operator()(const std::shared_ptr<const ImageEnvironment>&) const {
        return "environment picture";
    }
    const char* operator()(const SkyDomePtr&) const { return "sky"; }
    template <class Other>
    const char* operator()(const Other&) const {
        return "other";
    }
};

/// Indices at the lines F, d and C.
std::array<double, 3> indices_of(const Dispersion& index) {
    return {index(kLineF).value, index(kLined).value, index(kLineC).value};
}

/// The first glass of the catalogue that has this index, or nothing.
std::string catalogue_name(const Dispersion& index) {
    using Row = std::pair<std::string, std::array<double, 3>>;
    static const std::vector<Row> rows = [] {
        std::vector<Row> all;
        for (const Glass& glass : glass_catalogue())
            all.emplace_back(glass.name, indices_of(*make_dispersion(glass.data)));
        return all;
    }();
    const auto own = indices_of(index);
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.second == own; });
    return found == rows.end() ? std::string() : found->first;
}

class Reporter {
public:
    explicit Reporter(const Scene& scene) : scene_(scene) {}

    SceneReport make() {
        count_shapes();
        for (const Light& light : scene_.lights) ++report_.lights[std::visit(LightName{}, light)];
        describe_far_lights();
        for (const Rain& rain : scene_.rains) describe(rain);
        for (const Material& material : scene_.materials) describe(material);
        count_glowing();
        report_.bounds = bounds_of(scene_);
        find_costs();
        return std::move(report_);
    }

private:
    void count_shapes() {
        worn_.assign(scene_.materials.size(), 0);
        std::set<const Mesh*> meshes;
        for (const Shape& shape : scene_.shapes) {
            ++report_.shapes[kShapeNames[shape.geometry.index()]];
            ++worn_[std::size_t(shape.material)];
            const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&shape.geometry);
            if (!mesh) continue;
            report_.placed_triangles += (*mesh)->triangles.size();
            if (meshes.insert(mesh->get()).second) count_mesh(**mesh);
        }
        report_.meshes = meshes.size();
        report_.shape_bytes = scene_.shapes.size() * kShapeBytes;
    }

    void describe_far_lights() {
        for (const Light& light : scene_.lights) {
            if (const auto* sky = std::get_if<SkyDomePtr>(&light))
                report_.skies.push_back(
                    {illuminance_lx(**sky), (*sky)->luminance({{0.0, 1.0, 0.0}})});
            const auto* sun = std::get_if<DistantLight>(&light);
            if (!sun) continue;
            const Vec3 to = -sun->direction.v;
            const double azimuth = std::atan2(to.x, -to.z) / unit::deg.to(unit::rad);
            report_.distant.push_back(
                {std::asin(std::clamp(to.y, -1.0, 1.0)) / unit::deg.to(unit::rad),
                 azimuth < 0.0 ? azimuth + 360.0 : azimuth,
                 kLuminousEfficacy * xyz_from_spectrum(*sun->irradiance)[1]});
        }
    }

    void describe(const Rain& rain) {
        RainFacts facts;
        facts.name = rain.name;
        facts.drops_per_m3 = rain.drops->drops_per_m3();
        facts.mm_per_h = rain.drops->rain_rate_mm_per_h();
        const double lambda_nm = kExtinctionWavelength.to(unit::nm);
        double per_m = 0.0;
        rain.drops->extinction_lanes({&lambda_nm, 1}, {&per_m, 1});
        facts.extinction_per_km = 1e3 * per_m;
        facts.region = "inside of a mesh";
        if (const auto* region = std::get_if<ConvexRegion>(&rain.region)) {
            const std::optional<Length> thickness = region->thickness();
            facts.region = thickness ? fmt::format("{:.4g} m thick", thickness->to(unit::m))
                                     : std::string("without end");
            if (thickness) facts.optical_depth = per_m * thickness->to(unit::m);
        }
        report_.rains.push_back(std::move(facts));
    }

    void count_mesh(const Mesh& mesh) {
        report_.triangles += mesh.triangles.size();
        const auto bytes = [](const auto& values) { return values.size() * sizeof(values[0]); };
        report_.mesh_bytes += bytes(mesh.vertices) + bytes(mesh.normals) + bytes(mesh.triangles) +
                              bytes(mesh.texcoords[0]) + bytes(mesh.texcoords[1]) +
                              bytes(mesh.colours) + bytes(mesh.tangents) +
                              mesh.triangles.size() * kTriangleBytes;
    }

    void describe(const Material& material) {
        MaterialFacts facts;
        facts.name = material.name;
        facts.kind = kSurfaceNames[material.surface.index()];
        facts.shapes = worn_[report_.materials.size()];
        facts.glows = material.gives_light();
        if (const auto* glass = std::get_if<Dielectric>(&material.surface)) {
            describe_index(glass->interior->index, facts);
            facts.roughness = glass->roughness.value;
        } else if (const auto* pane = std::get_if<ThinDielectric>(&material.surface)) {
            describe_index(pane->index, facts);
            facts.roughness = pane->roughness.value;
        }
        report_.materials.push_back(std::move(facts));
        std::visit([&](const auto& surface) { add_textures(surface); }, material.surface);
        if (material.emission_texture) add(material.emission_texture->texture);
        if (material.coverage) add(material.coverage->alpha.texture);
        if (material.normal_map) add(material.normal_map->texture);
    }

    static void describe_index(const DispersionPtr& index, MaterialFacts& facts) {
        facts.glass = catalogue_name(*index);
        facts.n_d = (*index)(kLined).value / (*air())(kLined).value;
        if (index->is_constant()) return;  // against air it would have a little
        const double abbe = abbe_number(*index, *air());
        if (std::isfinite(abbe)) facts.v_d = abbe;
    }

    void add_textures(const Black&) {}
    void add_textures(const Diffuse& s) { add(s.reflectance.texture); }
    void add_textures(const Mirror& s) { add(s.reflectance.texture); }
    void add_textures(const Dielectric& s) { add(s.roughness.texture), add(s.tint.texture); }
    void add_textures(const ThinDielectric& s) { add(s.roughness.texture), add(s.tint.texture); }
    void add_textures(const Conductor& s) { add(s.roughness.texture); }
    void add_textures(const Mix& s) { add(s.second_share.texture); }
    void add_textures(const MetallicRoughness& s) {
        for (const ColourInput* input : {&s.base_colour, &s.specular_colour, &s.sheen_colour})
            add(input->texture);
        for (const NumberInput* input : {&s.metalness, &s.roughness, &s.specular, &s.clearcoat,
                                         &s.clearcoat_roughness, &s.sheen_roughness})
            add(input->texture);
    }

    void add(const TexturePtr& texture) {
        if (!texture || !images_.insert(texture->image.get()).second) return;
        const TextureImage& image = *texture->image;
        const std::uint64_t bytes = image.texels8.size() + 2 * image.texels16.size();
        report_.textures.push_back({image.name, image.width, image.height, image.bits, bytes});
        report_.texture_bytes += bytes;
    }

    void count_glowing() {
        for (const MaterialFacts& material : report_.materials)
            if (material.glows) glowing_ += material.shapes;
        if (glowing_ > 0) report_.lights["glowing shape"] = glowing_;
    }

    void find_costs();
    void cost(std::string what, std::string why) {
        report_.costs.push_back({std::move(what), std::move(why)});
    }

    const Scene& scene_;
    SceneReport report_;
    std::vector<std::size_t> worn_;  ///< shapes by material
    std::set<const TextureImage*> images_;
    std::size_t glowing_ = 0;
};

bool is_small(const Light& light) {
    if (const auto* sun = std::get_if<DistantLight>(&light))
        return sun->angular_radius < 5.0 * unit::deg;
    return std::holds_alternative<PointLight>(light) || std::holds_alternative<SpotLight>(light);
}

void Reporter::find_costs() {
    bool has_body = false, has_matt = false, has_small_light = false;
    std::size_t bodies = 0;
    for (const MaterialFacts& material : report_.materials) {
        if (material.shapes == 0) continue;
        const bool is_body = material.kind == "glass";
        bodies += is_body;
        has_body |= is_body;
        has_matt |= material.kind == "diffuse" || material.kind == "metallic-roughness";
        if (material.roughness.value_or(0.0) > 0.0)
            cost(fmt::format("rough glass \"{}\"", material.name),
                 "light behind it is found by chance at each of its surfaces: expect noise");
    }
    for (const Light& light : scene_.lights) has_small_light |= is_small(light);
    if (has_body && has_matt && has_small_light)
        cost(
            "a small light, glass, and something matt",
            "what the light sends through the glass (a caustic) is found by light paths, which "
            "--estimator auto adds where they pay; what is seen of it through glass or in a mirror "
            "is found by chance alone, and of a light without extent not at all");
    constexpr std::size_t kManyLights = 100;
    const std::size_t lights = scene_.lights.size() + glowing_;
    if (lights > kManyLights)
        cost(fmt::format("{} lights", lights),
             "each meeting with a surface looks at one of them, so that each is looked at seldom");
    constexpr std::size_t kStackedMedia = 8;
    if (bodies > kStackedMedia)
        cost(fmt::format("{} materials of glass", bodies),
             "where more than 8 bodies lie within each other, the weakest are forgotten");
    constexpr std::uint64_t kHugeTexture = std::uint64_t{256} << 20;
    for (const TextureFacts& texture : report_.textures)
        if (texture.bytes >= kHugeTexture)
            cost(fmt::format("texture \"{}\" of {} x {}", texture.name, texture.width,
                             texture.height),
                 fmt::format("takes {} MiB of memory", texture.bytes >> 20));
    if (report_.bytes() > available_memory() / 2)
        cost(fmt::format("about {} MiB for shapes and textures", report_.bytes() >> 20),
             fmt::format("{} MiB are free", available_memory() >> 20));
    constexpr double kLarge = 1000.0, kSmall = 1e-3;  // m
    const double across = 2.0 * report_.bounds.radius();
    if (!report_.bounds.empty() && (across > kLarge || across < kSmall))
        cost(fmt::format("a scene {:.3g} m across", across),
             "lengths are metres, and absorption goes by them: was the file written in another "
             "unit? --set imports.1.scale=0.001 makes millimetres of them");
}

}  // namespace

SceneReport report_of(const Scene& scene) { return Reporter(scene).make(); }

}  // namespace dewbow
