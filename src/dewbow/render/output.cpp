// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/output.h"

#include <algorithm>
#include <array>
#include <functional>

#include "dewbow/base/error.h"
#include "dewbow/base/file.h"
#include "dewbow/base/parallel.h"
#include "dewbow/image/exr.h"
#include "dewbow/image/png.h"
#include "dewbow/image/spectral_exr.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/rgb.h"
#include "dewbow/spectrum/spectrum.h"

namespace dewbow {

namespace {

/// What the film's Y is multiplied with, so that 1 is the luminance of white.
double scale_to_white(const Film& settings) {
    return kLuminousEfficacy * cie_y_integral() / settings.white_luminance;
}

std::size_t pixels_of(const PixelRect& crop) {
    return static_cast<std::size_t>(crop.width()) * static_cast<std::size_t>(crop.height());
}

/// Calls body(x, y, index) for each pixel of the crop, row by row and many rows at once.
void for_each_pixel(const PixelRect& crop, const std::function<void(int, int, std::size_t)>& body) {
    parallel_for(static_cast<std::size_t>(crop.height()), [&](std::size_t row) {
        std::size_t index = row * static_cast<std::size_t>(crop.width());
        for (int x = crop.x0; x < crop.x1; ++x) body(x, crop.y0 + static_cast<int>(row), index++);
    });
}

std::string bin_name(int bin, int bins) {
    const double width = (kLambdaMax_nm - kLambdaMin_nm) / bins;
    return emissive_channel_name((kLambdaMin_nm + (bin + 0.5) * width) * unit::nm);
}

using Encoder = std::string (*)(const FilmSums&, const Scene&, const DisplaySettings&,
                                Attributes facts);

std::string encode_film_as_exr(const FilmSums& film, const Scene& scene, const DisplaySettings&,
                               Attributes facts) {
    if (film.spectral_bins() > 0)
        for (Attribute& fact : spectral_attributes()) facts.push_back(std::move(fact));
    ExrOptions options;
    options.white_luminance = scene.film.white_luminance;
    return encode_exr(image_from_film(film, scene.film), facts, options);
}

std::string encode_film_as_png(const FilmSums& film, const Scene& scene,
                               const DisplaySettings& display, Attributes facts) {
    return encode_png(display_from_film(film, scene.film, display), facts);
}

struct Format {
    std::string extension;
    Encoder encode;
};
const std::vector<Format>& formats() {
    static const std::vector<Format> rows{
        {".exr", encode_film_as_exr},
        {".png", encode_film_as_png},
    };
    return rows;
}

std::string lower_case(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

const Format& format_of(const std::filesystem::path& path) {
    const std::string extension = path.extension().string();
    for (const Format& format : formats())
        if (format.extension == lower_case(extension)) return format;
    const std::string what =
        extension.empty() ? "a picture's name ends in the format's extension, and this one has none"
                          : "pictures are not written as " + extension;
    throw InputError({path.string(), 0, 0, {}}, what, {},
                     hint_for(extension, picture_extensions()));
}

std::string size_text(int width, int height) {
    return std::to_string(width) + "x" + std::to_string(height);
}

std::string hexadecimal(std::uint64_t value) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text(16, '0');
    for (std::size_t i = 16; i-- > 0; value >>= 4) text[i] = kDigits[value & 15];
    return text;
}

}  // namespace

Image image_from_film(const FilmSums& film, const Film& settings) {
    const PixelRect& crop = film.crop();
    Image image{crop.width(), crop.height(), {}};
    constexpr std::size_t kPlanes = 11;
    constexpr std::array<const char*, kPlanes> kNames{
        "R",        "G",        "B",        "A",        "albedo.R", "albedo.G",
        "albedo.B", "normal.X", "normal.Y", "normal.Z", "Z"};
    for (const char* name : kNames)
        image.channels.push_back({name, std::vector<float>(pixels_of(crop))});
    for (int bin = 0; bin < film.spectral_bins(); ++bin)
        image.channels.push_back(
            {bin_name(bin, film.spectral_bins()), std::vector<float>(pixels_of(crop))});
    const std::size_t caustics = image.channels.size();
    constexpr std::array<const char*, 3> kCaustics{"caustics.R", "caustics.G", "caustics.B"};
    const bool has_caustics = film.light_paths() > 0;
    for (std::size_t c = 0; has_caustics && c < kCaustics.size(); ++c)
        image.channels.push_back({kCaustics[c], std::vector<float>(pixels_of(crop))});

    const double scale = scale_to_white(settings);
    for_each_pixel(crop, [&](int x, int y, std::size_t index) {
        const Colour<LinearSrgb> rgb = rgb_from_xyz<LinearSrgb>(film.xyz(x, y) * scale);
        const Colour<LinearSrgb> albedo = rgb_from_xyz<LinearSrgb>(film.albedo(x, y));
        const Vec3 normal = film.normal(x, y);
        const std::array<double, kPlanes> values{
            rgb[0],   rgb[1],   rgb[2],   film.coverage(x, y), albedo[0], albedo[1], albedo[2],
            normal.x, normal.y, normal.z, film.depth(x, y)};
        for (std::size_t c = 0; c < kPlanes; ++c)
            image.channels[c].values[index] = static_cast<float>(values[c]);
        for (int bin = 0; bin < film.spectral_bins(); ++bin)
            image.channels[kPlanes + static_cast<std::size_t>(bin)].values[index] =
                static_cast<float>(film.bin(x, y, bin));
        if (!has_caustics) return;
        const auto part = rgb_from_xyz<LinearSrgb>(film.caustics(x, y) * scale);
        for (std::size_t c = 0; c < kCaustics.size(); ++c)
            image.channels[caustics + c].values[index] = static_cast<float>(part[c]);
    });
    return image;
}

Image8 display_from_film(const FilmSums& film, const Film& settings,
                         const DisplaySettings& display) {
    const PixelRect& crop = film.crop();
    Image8 image{crop.width(), crop.height(), std::vector<std::uint8_t>(3 * pixels_of(crop))};
    const double scale = scale_to_white(settings);
    for_each_pixel(crop, [&](int x, int y, std::size_t index) {
        const auto rgb = srgb8_from_xyz(film.xyz(x, y) * scale, display, x, y);
        std::copy(rgb.begin(), rgb.end(), &image.rgb[3 * index]);
    });
    return image;
}

Attributes render_facts(const Scene& scene, const RenderIdentity& identity,
                        const SessionResult& result, const std::string& scene_file) {
    const PixelRect& crop = result.crop;
    const auto count = [](auto n) { return static_cast<std::int64_t>(n); };
    Attributes facts{
        {"software", std::string("dewbow " DEWBOW_VERSION)},
        {"dewbow:fingerprint", fingerprint()},
        {"dewbow:scene", scene_file},
        {"dewbow:estimator", identity.estimator},
        {"dewbow:settings", identity.settings},
        {"dewbow:seed", std::to_string(scene.render.seed)},
        {"dewbow:samplesPerPixel", result.samples_per_pixel},
        {"dewbow:packet", count(scene.render.packet)},
        {"dewbow:size", size_text(scene.film.width, scene.film.height)},
        {"dewbow:crop", std::to_string(crop.x0) + "," + std::to_string(crop.y0) + "," +
                            size_text(crop.width(), crop.height())},
        {"dewbow:complete",
         std::string(result.reason == StopReason::interrupted ? "false" : "true")},
        {"dewbow:stopReason", to_string(result.reason)},
        {"dewbow:invalidSamples", result.invalid_samples},
        {"dewbow:filmHash", hexadecimal(result.film_hash)},
        {"dewbow:seconds", result.seconds},
        {"dewbow:whiteLuminance", scene.film.white_luminance},
        // The layout's emissiveUnits leaves open whether a bin holds a sum or a density.
        {"dewbow:spectralDensity", std::string("W.m^-2.sr^-1.nm^-1")},
    };
    if (result.light_paths > 0) facts.push_back({"dewbow:lightPaths", count(result.light_paths)});
    return facts;
}

void write_picture(const std::filesystem::path& path, const FilmSums& film, const Scene& scene,
                   const DisplaySettings& display, const Attributes& facts) {
    write_file_atomically(path, format_of(path).encode(film, scene, display, facts));
}

const std::vector<std::string>& picture_extensions() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> extensions;
        for (const Format& format : formats()) extensions.push_back(format.extension);
        return extensions;
    }();
    return names;
}

void check_picture_path(const std::filesystem::path& path) {
    format_of(path);
    check_writable(path);
}

}  // namespace dewbow
