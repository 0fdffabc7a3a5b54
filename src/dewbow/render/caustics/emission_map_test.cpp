// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/emission_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/base/random.h"
#include "dewbow/math/sampling.h"
#include "dewbow/render/caustics/emission_scenes.h"

namespace dewbow::caustics {
namespace {

constexpr double kPi = std::numbers::pi;
/// place() computes again by inverses what ray() computed: some hundred roundings, made larger
/// where a lamp looks at a box nearly along its face.
constexpr double kRounding = 1e-7;

using Numbers = std::array<double, 4>;

/// Stratified over i.
Numbers numbers(int i, std::uint32_t which = 0) {
    const SampleKey key(stream_key(11, which, 0), std::uint32_t(i));
    const auto a = key.two(0, Purpose::test);
    return {a[0], a[1], key.third(0, Purpose::test), key.fourth(0, Purpose::test)};
}
/// Independent of each other.
Numbers independent(int i, std::uint32_t which) {
    const SampleKey key(stream_key(12, which, std::uint32_t(i)), 0);
    const auto a = key.two(0, Purpose::test), b = key.two(1, Purpose::test);
    return {a[0], a[1], b[0], b[1]};
}

double density(const EmissionMap& map, const Ray& ray) {
    const auto place = map.place(ray);
    return place ? place->pdf : 0.0;
}

/// Each ray finds back the numbers that gave it, with their density; whatever it finds gives it
/// again.
TEST(EmissionMap, PlacesInvertRays) {
    for (const LitScene& lit : all_lamps()) {
        const Ready ready(lit.scene);
        ASSERT_EQ(ready.maps.size(), 1);
        const EmissionMap& map = ready.maps[0];
        int found = 0;
        for (int i = 0; i < 1000; ++i) {
            const Numbers u = numbers(i);
            const auto ray = map.ray(u);
            if (!ray) continue;
            ++found;
            const auto place = map.place(ray->ray);
            ASSERT_TRUE(place) << lit.name << " " << i;
            for (std::size_t k = 0; k < (ray->without_extent ? 2u : 4u); ++k)
                ASSERT_NEAR(place->u[k], u[k], kRounding) << lit.name << " " << i;
            ASSERT_NEAR(place->pdf / ray->pdf, 1.0, kRounding) << lit.name << " " << i;
            const auto again = map.ray(place->u);
            ASSERT_TRUE(again) << lit.name << " " << i;
            ASSERT_NEAR(length(again->ray.direction - ray->ray.direction), 0.0, kRounding)
                << lit.name << " " << i;
            ASSERT_NEAR(again->pdf / place->pdf, 1.0, kRounding) << lit.name << " " << i;
        }
        EXPECT_GT(found, 100) << lit.name;
        EXPECT_GT(map.power(), 0.0) << lit.name;
    }
}

// ---- densities against rays that know nothing of them -------------------------------------------

/// A ray of a lamp, and the density with which the search below finds it: alike in cones from a
/// ball around the lamp to the balls around the casters, or alike over discs as wide as those.
struct FoundRay {
    Ray ray;
    double pdf;
};

class Search {
public:
    explicit Search(const LitScene& lit, const PreparedScene& prepared)
        : targets_(lit.targets), prepared_(prepared) {
        if (!lit.scene.lights.empty()) light_ = &lit.scene.lights[0];
        if (!light_) {
            const Bounds box = bounds_of(lit.scene.shapes.back());
            lamp_ = {box.centre(), box.radius()};
        } else if (const auto* beam = std::get_if<BeamLight>(light_)) {
            lamp_ = {beam->position.v, 1.1 * beam->radius.to(unit::m)};
        }
        if (const auto* spot = light_ ? std::get_if<SpotLight>(light_) : nullptr) {
            cones_.push_back({spot->direction, one_minus_cos(1.2 * spot->outer)});
        } else if (const auto* distant = light_ ? std::get_if<DistantLight>(light_) : nullptr) {
            cones_.push_back({distant->direction, one_minus_cos(1.2 * distant->angular_radius)});
        } else if (light_ && InfiniteLight::holds(*light_)) {
            cones_.push_back({{{0, 0, 1}}, 2.0});
        } else {
            for (const Ball& target : targets_) cones_.push_back(cone_to(target));
        }
    }

    /// All rays of the lamp along one line.
    std::vector<FoundRay> find(const Numbers& u) const {
        if (light_ && std::holds_alternative<BeamLight>(*light_)) {
            const Vec3 d = std::get<BeamLight>(*light_).direction.v;
            return with_pdf({point_in_disc(lamp_, d, u[0], u[1]), d, {}});
        }
        const double choice = u[0] * double(cones_.size());
        const auto& [axis, width] = cones_[std::size_t(choice)];
        const Vec3 d =
            around(axis, sample_uniform_cone(width, choice - std::floor(choice), u[1])).v;
        if (!light_) return along_line(point_in_disc(lamp_, d, u[2], u[3]), d);
        if (!InfiniteLight::holds(*light_)) return with_pdf({{}, d, {}});
        const double chosen = u[2] * double(targets_.size());
        const Ball& target = targets_[std::size_t(chosen)];
        return with_pdf({point_in_disc(target, d, chosen - std::floor(chosen), u[3]), d, {}});
    }

    /// 0 for a ray that it does not find.
    double pdf(const Ray& ray) const {
        if (!light_) return direction_pdf(ray.direction) * disc_pdf(lamp_);
        if (std::holds_alternative<BeamLight>(*light_)) return disc_pdf(lamp_);
        if (!InfiniteLight::holds(*light_)) return direction_pdf(ray.direction);
        double place = 0.0;
        for (const Ball& target : targets_)
            if (CasterBounds(target).entry_of(ray.origin, ray.direction))
                place += disc_pdf(target) / double(targets_.size());
        const auto* distant = std::get_if<DistantLight>(light_);
        const bool parallel = distant && distant->angular_radius.to(unit::rad) == 0.0;
        return place * (parallel ? 1.0 : direction_pdf(ray.direction));
    }

private:
    struct Cone {
        Dir<World> axis;
        double width;
    };
    Cone cone_to(const Ball& target) const {
        const Vec3 between = target.centre - lamp_.centre;
        const double sine = (target.radius + lamp_.radius) / length(between);
        if (!(sine < 1.0)) return {{{0, 0, 1}}, 2.0};
        return {{normalised(between)}, 1.0 - std::sqrt(1.0 - sine * sine)};
    }
    double direction_pdf(Vec3 d) const {
        double sum = 0.0;
        for (const Cone& cone : cones_)
            if (0.5 * dot(d - cone.axis.v, d - cone.axis.v) <= cone.width)
                sum += pdf_uniform_cone(cone.width) / double(cones_.size());
        return sum;
    }
    static double disc_pdf(const Ball& ball) { return 1.0 / (kPi * ball.radius * ball.radius); }
    static Vec3 point_in_disc(const Ball& ball, Vec3 d, double u0, double u1) {
        const DiscPoint p = sample_concentric_disc(u0, u1);
        const Tangents across = tangents_of(d);
        return ball.centre + (across.t * p.x + across.b * p.y) * ball.radius;
    }
    std::vector<FoundRay> with_pdf(const Ray& ray) const { return {{ray, pdf(ray)}}; }

    /// Wherever the line meets a side of the lamp that glows.
    std::vector<FoundRay> along_line(Vec3 through, Vec3 d) const {
        std::vector<FoundRay> found;
        Ray back{through + d * lamp_.radius, -d, {}};
        for (double left = 2.0 * lamp_.radius; left > 0.0;) {
            const Hit hit = prepared_.accelerator.intersect(back);
            if (!hit || hit.t > left) break;
            const Vec3 at = back.origin + back.direction * hit.t;
            const bool inward = dot(d, hit.normal) < 0.0;
            if (prepared_.lights.emits(hit, -d)) {
                const Ray ray{at, d, {hit.shape, hit.primitive, inward}};
                found.push_back({ray, pdf(ray)});
            }
            back = {at, -d, {hit.shape, hit.primitive, !inward}};
            left -= hit.t;
        }
        return found;
    }

    std::vector<Ball> targets_;
    const PreparedScene& prepared_;
    const Light* light_ = nullptr;
    Ball lamp_{{}, 0.0};
    std::vector<Cone> cones_;
};

/// Rays in classes by where they go and where they come from.
constexpr std::size_t kClasses = 8;
std::size_t class_of(const Ray& ray) {
    const Vec3 d = ray.direction;
    // Of lamps infinitely far only the line says where a ray comes from.
    const Vec3 at = ray.origin - d * dot(ray.origin, d);
    return std::size_t((d.x > 0.1) + 2 * (d.z > 0.05) + 4 * (at.x > 0.0));
}

/// Of the rays in a class that is compared.
constexpr double kLeastShare = 0.03;

struct Comparison {
    double worst = 0.0;  ///< difference in standard deviations
    double sum = 0.0;    ///< of the density over all that counts
};

/// Share of the numbers that give rays of each class, and the integral of the density over them.
/// @param planted  a factor on the density that should not be there.
template <class Planted>
Comparison compare(const LitScene& lit, const Planted& planted) {
    constexpr int kRays = 4096, kLines = 20000;
    const Ready ready(lit.scene);
    const EmissionMap& map = ready.maps[0];
    const Search search(lit, ready.prepared);
    // The last class is all of them.
    std::array<double, kClasses + 1> share{}, mean{}, square{};
    const auto add = [](auto& sums, const Ray& ray, double value) {
        sums[class_of(ray)] += value;
        sums[kClasses] += value;
    };
    for (int i = 0; i < kRays; ++i)
        if (const auto ray = map.ray(independent(i, 1)); ray && search.pdf(ray->ray) > 0.0)
            add(share, ray->ray, 1.0 / kRays);
    for (int i = 0; i < kLines; ++i) {
        std::array<double, kClasses + 1> here{};
        for (const FoundRay& found : search.find(independent(i, 2)))
            add(here, found.ray, density(map, found.ray) * planted(found.ray) / found.pdf);
        for (std::size_t c = 0; c < here.size(); ++c)
            mean[c] += here[c] / kLines, square[c] += here[c] * here[c] / kLines;
    }
    Comparison result;
    result.sum = mean[kClasses];
    for (std::size_t c = 0; c < share.size(); ++c) {
        // Classes that few lines find have scattered less than they do.
        if (share[c] < kLeastShare) continue;
        const double variance =
            share[c] * (1.0 - share[c]) / kRays + (square[c] - mean[c] * mean[c]) / kLines;
        result.worst = std::max(result.worst, std::abs(share[c] - mean[c]) / std::sqrt(variance));
    }
    return result;
}

/// Of some thousand comparisons one is beyond by chance in 2000 sets of keys.
constexpr double kSigmas = 5.0;

TEST(EmissionMap, DensitiesAreThoseOfTheRays) {
    for (const LitScene& lit : all_lamps()) {
        const Comparison true_density = compare(lit, [](const Ray&) { return 1.0; });
        EXPECT_LT(true_density.worst, kSigmas) << lit.name;
        EXPECT_GT(true_density.sum, 0.05) << lit.name;
    }
}

/// What the comparison sees: a factor of 1.5 on the density.
TEST(EmissionMap, WrongDensitiesAreSeen) {
    for (const LitScene& lit : lamps_before(things())) {
        EXPECT_GT(compare(lit, [](const Ray&) { return 1.5; }).worst, kSigmas) << lit.name;
    }
}

/// What stands between the sun and the casters is met first: a wall far off, a roof without end.
TEST(EmissionMap, RaysFromInfinitelyFarBeginBeforeEverything) {
    const int kNobody = -1;
    for (const bool endless : {false, true}) {
        Scene scene = make_empty_scene();
        add_things(scene);
        const int grey = scene.add({"grey", Diffuse{make_constant(0.5)}, {}});
        const Affine up = translation({0, 50, 0}) * rotation({1, 0, 0}, -90.0 * unit::deg);
        const int roof = int(scene.shapes.size());
        if (endless)
            add_shape(scene, Plane{}, up, grey);
        else
            add_shape(scene, Rectangle{30.0 * unit::m, 30.0 * unit::m}, up, grey);
        scene.lights.push_back(
            DistantLight{{normalised(Vec3{0.1, -1, 0})}, 0.2666 * unit::deg, make_constant(1.0)});
        const Ready ready(scene);
        for (int i = 0; i < 200; ++i) {
            const auto ray = ready.maps[0].ray(numbers(i));
            if (!ray) continue;
            const Hit hit = ready.prepared.accelerator.intersect(ray->ray);
            ASSERT_EQ(hit ? hit.shape : kNobody, roof);
        }
    }
}

// ---- what is aimed at, and what is not ----------------------------------------------------------

/// A ray of the lamp to a point, found from there as direct light is; nothing if that is dark.
std::optional<Ray> ray_to(const PreparedScene& prepared, Vec3 at, const SurfaceFrom& from,
                          const Numbers& u) {
    const auto sample = prepared.lights.sample({at}, u[0], {u[1], u[2]});
    if (!sample) return std::nullopt;
    const double distance = std::isinf(sample->distance) ? 0.0 : sample->distance;
    if (sample->source != LightSample::Source::shape)
        return Ray{at + sample->direction * distance, -sample->direction, {}};
    Ray back{at, sample->direction, from};
    const Hit hit = prepared.accelerator.intersect(back);
    if (!hit || !prepared.lights.emits(hit, back.direction)) return std::nullopt;
    return Ray{at + back.direction * hit.t,
               -back.direction,
               {hit.shape, hit.primitive, dot(back.direction, hit.normal) > 0.0}};
}

/// Whatever light reaches a caster from the lamp has a density. The same ray turned upwards, or
/// far aside, meets no caster and has none.
TEST(EmissionMap, StarvesNoCasterAndFeedsNothingElse) {
    for (const LitScene& lit : all_lamps()) {
        const Ready ready(lit.scene);
        const bool all_below = ready.casters.groups().size() > 1;
        int reached = 0;
        for (int i = 0; i < 1500; ++i) {
            const Numbers u = independent(i, 3), v = independent(i, 4);
            const Ball& target = lit.targets[std::size_t(i) % lit.targets.size()];
            const Vec3 d = sample_uniform_sphere<World>(u[0], u[1]).v;
            const DiscPoint p = sample_concentric_disc(u[2], u[3]);
            const Tangents across = tangents_of(d);
            const Vec3 start = target.centre + (across.t * p.x + across.b * p.y) * target.radius;
            const Ray line{start - d * (2.0 * target.radius), d, {}};
            const Hit hit = ready.prepared.accelerator.intersect(line);
            if (!hit) continue;
            const int material = lit.scene.shapes[std::size_t(hit.shape)].material;
            if (!is_caster(lit.scene, lit.scene.materials[std::size_t(material)])) continue;
            const Vec3 at = line.origin + d * hit.t;
            const auto ray = ray_to(ready.prepared, at,
                                    {hit.shape, hit.primitive, dot(-d, hit.normal) < 0.0}, v);
            if (!ray) continue;
            ++reached;
            ASSERT_GT(density(ready.maps[0], *ray), 0.0) << lit.name << " " << i;
            if (!all_below) continue;
            Ray away = *ray;
            if (ready.maps[0].source() == LightSample::Source::infinite)
                away.origin += Vec3{100.0, 0.0, 0.0} + away.direction * 3.0;
            else
                away.direction.y = std::abs(away.direction.y);
            if (ready.maps[0].source() == LightSample::Source::beam)
                away.origin += Vec3{100.0, 0.0, 0.0};
            ASSERT_EQ(density(ready.maps[0], away), 0.0) << lit.name << " " << i;
        }
        const bool narrow = lit.name.starts_with("narrow");  // meets nearly no point
        EXPECT_GE(reached, narrow ? 0 : 10) << lit.name;
    }
}

}  // namespace
}  // namespace dewbow::caustics
