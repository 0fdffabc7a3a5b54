// SPDX-License-Identifier: Apache-2.0

// Each of the other renderers is told a scene of a wedge of glass and six lamps, and its picture is
// compared with the same lamps followed by Snell's and Fresnel's laws: the proof that camera,
// handedness, index, sides of lamps and exposure are what we said. A contestant whose program is
// not here is skipped.

#include "languages.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>

#include "child_process.h"
#include "dewbow/optics/dispersion.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/illuminant.h"
#include "dewbow/spectrum/rgb.h"
#include "scratch_folder.h"

namespace dewbow::bench {
namespace {

using Rgb = Colour<LinearSrgb>;

constexpr double kIndex = 1.5;
DispersionPtr constant_index(double n) {
    return make_dispersion({"constant", {n}, IndexReference::vacuum});
}

/// Of the film's white where it is an illuminant times 1.
const double kFilmFromXyz = 1.0 / cie_y_integral();

PlainLamp lamp(LampShape shape, Vec3 centre, Vec3 towards, double half_u, double half_v,
               const char* illuminant, double scale) {
    PlainLamp made;
    made.shape = shape;
    made.centre = centre;
    made.normal = normalised(towards - centre);
    const Tangents axes = tangents_of(made.normal);
    made.half_u = axes.t * half_u;
    made.half_v = axes.b * half_v;
    made.radiance = make_scaled(find_illuminant(illuminant), scale);
    made.colour = rgb_from_xyz<LinearSrgb>(xyz_from_spectrum(*made.radiance) * kFilmFromXyz);
    return made;
}

PlainCamera camera_at(Vec3 eye, Vec3 target, int width, int height) {
    const Affine view = looking_at(eye, target, normalised(Vec3{0.2, 1.0, 0.1}));
    PlainCamera camera;
    camera.eye = eye;
    camera.right = view.apply_linear({1, 0, 0});
    camera.up = view.apply_linear({0, 1, 0});
    camera.forward = view.apply_linear({0, 0, -1});
    camera.tan_half_vertical_fov = std::tan(0.5 * 24.0 / 180.0 * 3.14159265358979);
    camera.width = width;
    camera.height = height;
    return camera;
}

/// A box whose front face leans: the deviation is some 8°.
PlainBody wedge(double index) {
    PlainBody body;
    for (const int corner : {0, 1, 2, 3, 4, 5, 6, 7}) {
        const double x = corner & 1 ? 0.7 : -0.7, y = corner & 2 ? 0.6 : -0.6;
        body.vertices.push_back({x, y, corner & 4 ? 0.35 + 0.3 * x : -0.1});
    }
    body.triangles = {{0, 6, 4}, {0, 2, 6}, {1, 7, 3}, {1, 5, 7}, {0, 5, 1}, {0, 4, 5},
                      {2, 7, 6}, {2, 3, 7}, {0, 3, 2}, {0, 1, 3}, {4, 7, 5}, {4, 6, 7}};
    for (auto& t : body.triangles) std::swap(t[1], t[2]);
    body.index = constant_index(index);
    return body;
}

PlainScene wedge_and_lamps() {
    PlainScene scene;
    scene.camera = camera_at({0.3, 0.25, 4.0}, {0.1, 0.0, 0.0}, 48, 36);
    scene.bodies = {wedge(kIndex)};
    scene.surrounding_index = vacuum();
    const Vec3 eye = scene.camera.eye;
    scene.lamps = {
        lamp(LampShape::rectangle, {0.2, 0.3, -3.0}, eye, 0.25, 0.1, "A", 1.0),
        lamp(LampShape::disc, {-0.7, -0.4, -2.5}, {0.0, 0.0, 2.0}, 0.22, 0.22, "D65", 0.5),
        lamp(LampShape::rectangle, {0.75, -0.5, 0.9}, eye, 0.06, 0.12, "A", 0.8),
        // Away from the camera: the first is dark, the second glows on both sides.
        lamp(LampShape::rectangle, {0.4, -0.35, -2.0}, {0.5, -0.5, -9.0}, 0.2, 0.2, "D65", 1.0),
        lamp(LampShape::disc, {-0.9, 0.6, 0.4}, {-1.2, 0.7, -9.0}, 0.1, 0.1, "D65", 0.7),
        // Behind the camera, seen in the front face.
        lamp(LampShape::disc, {-1.35, 0.0, 3.3}, {0.0, 0.0, 0.3}, 0.4, 0.4, "D65", 3.0)};
    scene.lamps[4].two_sided = true;
    scene.film_from_xyz = kFilmFromXyz;
    return scene;
}

// ---- the same by Snell and Fresnel
// ---------------------------------------------------------------

struct Ray {
    Vec3 from, along;  ///< unit direction
};

/// Light of the nearest lamp that the ray meets before `limit`; nothing if it meets none.
std::optional<Rgb> lamp_light(const PlainScene& scene, const Ray& ray, double limit) {
    std::optional<Rgb> found;
    for (const PlainLamp& l : scene.lamps) {
        const double facing = dot(l.normal, ray.along);
        const double t = dot(l.normal, l.centre - ray.from) / facing;
        if (!(t > 1e-9) || t >= limit) continue;
        const Vec3 p = ray.from + ray.along * t - l.centre;
        const double u = dot(p, l.half_u) / dot(l.half_u, l.half_u);
        const double v = dot(p, l.half_v) / dot(l.half_v, l.half_v);
        const bool inside = l.shape == LampShape::disc ? u * u + v * v < 1.0
                                                       : std::abs(u) < 1.0 && std::abs(v) < 1.0;
        if (!inside) continue;
        limit = t;
        found = facing < 0.0 || l.two_sided ? l.colour : Rgb{};
    }
    return found;
}

struct Crossing {
    double t = 1e300;
    Vec3 normal;  ///< outwards
};

/// Where the ray meets the planes of the body last from outside, and first from inside.
std::optional<std::array<Crossing, 2>> crossings(const PlainBody& body, const Ray& ray) {
    Crossing in{-1e300, {}}, out;
    for (const auto& t : body.triangles) {
        const Vec3 a = body.vertices[t[0]], b = body.vertices[t[1]], c = body.vertices[t[2]];
        const Vec3 n = normalised(cross(b - a, c - a));
        const double facing = dot(n, ray.along), at = dot(n, a - ray.from) / facing;
        if (facing < 0.0 && at > in.t) in = {at, n};
        if (facing > 0.0 && at < out.t) out = {at, n};
    }
    if (in.t >= out.t) return std::nullopt;
    return std::array{in, out};
}

/// By Snell's law with n_i / n_t = `ratio`; the normal is against the ray. Nothing at total
/// reflection.
std::optional<Vec3> refracted(Vec3 along, Vec3 normal, double ratio) {
    const double cos_i = -dot(along, normal), k = 1.0 - ratio * ratio * (1.0 - cos_i * cos_i);
    if (k < 0.0) return std::nullopt;
    return along * ratio + normal * (ratio * cos_i - std::sqrt(k));
}

Vec3 mirrored(Vec3 along, Vec3 normal) { return along - normal * (2.0 * dot(along, normal)); }

double reflectance(double cos_i, double cos_t, double n_i, double n_t) {
    const double s = (n_i * cos_i - n_t * cos_t) / (n_i * cos_i + n_t * cos_t);
    const double p = (n_t * cos_i - n_i * cos_t) / (n_t * cos_i + n_i * cos_t);
    return 0.5 * (s * s + p * p);
}

/// Light along a ray that comes to the body from outside, with what is reflected within it. The
/// body's index is taken to be constant.
Rgb light_along(const PlainScene& scene, const Ray& ray) {
    const double n = (*scene.bodies[0].index)(550.0 * unit::nm).value;
    constexpr int kReflections = 12;
    constexpr double kFar = 1e300, kStep = 1e-9;
    const auto c = crossings(scene.bodies[0], ray);
    const bool meets = c && (*c)[0].t > 0.0;
    if (const auto direct = lamp_light(scene, ray, meets ? (*c)[0].t : kFar)) return *direct;
    if (!meets) return {};
    const Crossing& in = (*c)[0];
    Vec3 at = ray.from + ray.along * in.t, along = *refracted(ray.along, in.normal, 1.0 / n);
    const double r_in = reflectance(-dot(ray.along, in.normal), -dot(along, in.normal), 1.0, n);
    Rgb light =
        r_in * lamp_light(scene, {at, mirrored(ray.along, in.normal)}, kFar).value_or(Rgb{});
    double weight = 1.0 - r_in;
    for (int k = 0; k < kReflections; ++k) {
        const auto within = crossings(scene.bodies[0], {at + along * kStep, along});
        if (!within) break;
        const Crossing& out = (*within)[1];
        at += along * out.t;
        if (const auto away = refracted(along, -out.normal, n)) {
            const double r = reflectance(dot(along, out.normal), dot(*away, out.normal), n, 1.0);
            light =
                light + weight * (1.0 - r) * lamp_light(scene, {at, *away}, kFar).value_or(Rgb{});
            weight *= r;
        }
        along = mirrored(along, out.normal);
    }
    return light;
}

/// With 8 × 8 rays a pixel.
Picture exact_picture(const PlainScene& scene) {
    constexpr int kGrid = 8;
    Picture picture{scene.camera.width, scene.camera.height, {}};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            Rgb sum;
            for (int k = 0; k < kGrid * kGrid; ++k)
                sum = sum +
                      light_along(scene, {scene.camera.eye, normalised(scene.camera.direction(
                                                                x + (k % kGrid + 0.5) / kGrid,
                                                                y + (k / kGrid + 0.5) / kGrid))});
            picture.pixels.push_back(sum * (1.0 / (kGrid * kGrid)));
        }
    return picture;
}

// ---- running and comparing
// -----------------------------------------------------------------------

/// Of the light in one ninth of a picture.
struct Moments {
    Rgb mean;
    double x = 0.0, y = 0.0;  ///< centre of gravity, pixels
};

Moments moments(const Picture& picture, int third_x, int third_y) {
    const int w = picture.width / 3, h = picture.height / 3;
    Moments m;
    double weight = 0.0;
    for (int y = third_y * h; y < (third_y + 1) * h; ++y)
        for (int x = third_x * w; x < (third_x + 1) * w; ++x) {
            const Rgb& pixel = picture.pixels[std::size_t(y * picture.width + x)];
            const double value = pixel[0] + pixel[1] + pixel[2];
            m.mean = m.mean + pixel * (1.0 / (w * h));
            m.x += value * (x + 0.5);
            m.y += value * (y + 0.5);
            weight += value;
        }
    if (weight > 0.0) m.x /= weight, m.y /= weight;
    return m;
}

Picture picture_of_contestant(const Contestant& contestant, const PlainScene& plain, Knobs knobs) {
    const ScratchFolder folder;
    const BenchScene scene{"test", "", make_empty_scene(), plain};
    const Order order{scene, knobs, 1, folder.path()};
    EXPECT_EQ(run_child(contestant.write(order), folder.path()).exit_code, 0)
        << log_tail(folder.path());
    return contestant.read(order);
}

using Finder = std::unique_ptr<Contestant> (*)(const Programs&);

struct Language {
    const char* name;
    Finder find;
    int samples;            ///< a pixel
    double mean_tolerance;  ///< of the light in a ninth of the picture: some 4 standard errors
    /// Where one lamp is seen: an index wrong by 0.01 moves it by 0.25.
    double centroid_tolerance_px;
};
void PrintTo(const Language& language, std::ostream* out) { *out << language.name; }

class LanguagesTest : public testing::TestWithParam<Language> {
protected:
    void SetUp() override {
        contestant_ = GetParam().find(Programs({}));
        if (!contestant_) GTEST_SKIP() << GetParam().name << " is not on the PATH";
    }

    Picture render(const PlainScene& plain, Knobs knobs) {
        return picture_of_contestant(*contestant_, plain, knobs);
    }

    std::unique_ptr<Contestant> contestant_;
};

TEST_P(LanguagesTest, LampsAreWhereSnellAndFresnelPutThem) {
    const PlainScene scene = wedge_and_lamps();
    const Picture expected = exact_picture(scene);
    const Picture picture =
        render(scene, {.spectral_samples = 7, .samples_per_pixel = GetParam().samples});
    constexpr double kDark = 0.02;  // so little light that it is mostly noise
    for (int third_y = 0; third_y < 3; ++third_y)
        for (int third_x = 0; third_x < 3; ++third_x) {
            SCOPED_TRACE(testing::Message() << "ninth " << third_x << ", " << third_y);
            const Moments e = moments(expected, third_x, third_y);
            const Moments m = moments(picture, third_x, third_y);
            for (const std::size_t channel : {0, 1, 2})
                EXPECT_NEAR(m.mean[channel], e.mean[channel],
                            GetParam().mean_tolerance * std::max(e.mean[channel], kDark));
            if (e.mean[1] < kDark) continue;
            EXPECT_NEAR(m.x, e.x, GetParam().centroid_tolerance_px);
            EXPECT_NEAR(m.y, e.y, GetParam().centroid_tolerance_px);
        }
}

TEST_P(LanguagesTest, DispersiveGlassInWhiteSurroundingsIsWhite) {
    PlainScene scene = wedge_and_lamps();
    scene.lamps.clear();
    scene.surroundings = find_illuminant("D65");
    scene.surroundings_colour = {{1.0, 1.0, 1.0}};
    scene.bodies[0].index = make_dispersion(
        {"sellmeier",
         {1.73759695, 0.013188707, 0.313747346, 0.0623068142, 1.89878101, 155.23629}});  // SF11
    const Picture picture =
        render(scene, {.spectral_samples = 7, .samples_per_pixel = GetParam().samples / 4});
    for (const std::size_t channel : {0, 1, 2})
        EXPECT_NEAR(moments(picture, 1, 1).mean[channel], 1.0, GetParam().mean_tolerance);
}

// ---- what is written, whether the programs are here or not
// ----------------------------------------

/// The text after `key` in `text`, up to the next of " }\"".
std::string after(const std::string& text, const std::string& key) {
    const std::size_t at = text.find(key);
    if (at == std::string::npos) return "no " + key;
    const std::size_t begin = at + key.size();
    return text.substr(begin, text.find_first_of(" }\"", begin) - begin);
}

TEST(Languages, StateTheIndexAsEachUnderstandsIt) {
    PlainScene scene = wedge_and_lamps();
    // n = 1.6 + 0.01 µm²/λ², in air of 1.5: what counts is the ratio.
    scene.bodies[0].index = make_dispersion({"cauchy", {1.6, 0.01}, IndexReference::vacuum});
    scene.surrounding_index = constant_index(1.5);
    const SceneOrder order{scene, {.spectral_samples = 31}};
    const auto n = [](double um) { return (1.6 + 0.01 / (um * um)) / 1.5; };
    const std::string pov = pov_scene(order);
    EXPECT_DOUBLE_EQ(std::stod(after(pov, "{ ior ")), n(0.555));
    EXPECT_DOUBLE_EQ(std::stod(after(pov, "dispersion ")), n(0.380) / n(0.730));
    EXPECT_EQ(after(pov, "dispersion_samples "), "31");
    const std::string pbrt = pbrt_scene(order);
    EXPECT_DOUBLE_EQ(std::stod(after(pbrt.substr(pbrt.find("eta")), "\n550 ")), n(0.550));
    EXPECT_DOUBLE_EQ(std::stod(after(mitsuba_scene(order), "int_ior\" value=\"")), n(0.5875618));
    EXPECT_DOUBLE_EQ(std::stod(after(blender_script(order), "glass([")), n(0.6114));
}

TEST(Languages, PovRayWithoutSplittingHasOneIndex) {
    const PlainScene scene = wedge_and_lamps();
    EXPECT_EQ(pov_scene({scene, {.spectral_samples = 0}}).find("dispersion"), std::string::npos);
}

/// Blender's glasses have indices at the dominant wavelengths of sRGB's primaries: where the line
/// from white through a primary meets the spectral locus.
TEST(Languages, BlendersWavelengthsAreThoseOfThePrimaries) {
    const auto xy = [](Colour<Xyz> c) {
        const double sum = c[0] + c[1] + c[2];
        return std::array{c[0] / sum, c[1] / sum};
    };
    const auto white = xy(xyz_from_rgb(Rgb{{1, 1, 1}}));
    const double wavelengths_nm[] = {611.4, 549.1, 464.2};
    for (const std::size_t channel : {0, 1, 2}) {
        Rgb primary;
        primary[channel] = 1.0;
        const auto p = xy(xyz_from_rgb(primary));
        // The angle between the primary and the colour of a wavelength, as seen from white.
        const auto side = [&](double nm) {
            const auto s = xy({cie_xyz_bar(nm)});
            return (s[0] - white[0]) * (p[1] - white[1]) - (s[1] - white[1]) * (p[0] - white[0]);
        };
        constexpr double kRounding_nm = 0.15;
        EXPECT_LT(side(wavelengths_nm[channel] - kRounding_nm) *
                      side(wavelengths_nm[channel] + kRounding_nm),
                  0.0)
            << channel;
    }
}

/// Of two bands POV-Ray's first lies at 467.5 nm, and is all that is blue: a lamp's blue image is
/// where the index is n₀ D^(87.5/350).
TEST(Languages, PovRaysDispersionIsWhatWeTakeItFor) {
    const std::unique_ptr<Contestant> pov_ray = find_pov_ray(Programs({}));
    if (!pov_ray) GTEST_SKIP() << "povray is not on the PATH";
    PlainScene scene = wedge_and_lamps();
    scene.lamps.resize(1);
    scene.bodies[0].index = make_dispersion({"cauchy", {1.4, 0.04}, IndexReference::vacuum});
    const auto n = [](double um) { return 1.4 + 0.04 / (um * um); };
    const Picture picture = picture_of_contestant(*pov_ray, scene, {2, 256});
    const auto centre = [](const Picture& p) {
        double light = 0.0;
        Vec3 sum;
        for (int i = 0; i < p.width * p.height; ++i) {
            const double blue = p.pixels[std::size_t(i)][2];
            sum += Vec3{0.5 + i % p.width, 0.5 + i / p.width} * blue;
            light += blue;
        }
        return sum / light;
    };
    const auto centre_at = [&](double index) {
        scene.bodies[0].index = constant_index(index);
        return centre(exact_picture(scene));
    };
    const Vec3 band = centre_at(n(0.555) * std::pow(n(0.380) / n(0.730), 87.5 / 350.0));
    const Vec3 nominal = centre_at(n(0.555));
    constexpr double kTolerance_px = 0.1;
    EXPECT_LT(length(centre(picture) - band), kTolerance_px);
    EXPECT_GT(length(nominal - band), 10.0 * kTolerance_px);
}

INSTANTIATE_TEST_SUITE_P(Peers, LanguagesTest,
                         testing::Values(Language{"povray", find_pov_ray, 256, 0.015, 0.1},
                                         Language{"blender", find_blender, 1024, 0.12, 0.25},
                                         Language{"pbrt", find_pbrt, 1024, 0.1, 0.2},
                                         Language{"mitsuba", find_mitsuba, 1024, 0.05, 0.2}),
                         [](const auto& language) { return language.param.name; });

}  // namespace
}  // namespace dewbow::bench
