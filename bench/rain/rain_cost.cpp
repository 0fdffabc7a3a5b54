// SPDX-License-Identifier: Apache-2.0

// What does rain cost, and what is its law worth? In three landscapes: processor time of a sample
// without rain, with it, and with it where drops are found by next-event estimation at sampled
// distances instead; and the error of both at equal time.
//
//     bench_rain_cost [--width 96] [--height 54] [--samples 16] [--repeats 8] [--reference 4096]
//                     [--json FILE]
//
// Each pixel is one ray, so that the edges of things make no noise. One thread; time is the
// processor's, the least of all repeats, and the methods take turns. The reference is half by one
// method and half by the other, each of --reference samples a pixel: that both agree is printed as
// the bias of the mean in standard errors. MSE is of linear sRGB and of Y, the mean of all repeats,
// each with a seed of its own, less the reference's own.

#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "../micro/cpu_time.h"
#include "../picture_error.h"
#include "dewbow/base/parallel.h"
#include "dewbow/render/path/path.h"
#include "dewbow/spectrum/cie.h"
#include "next_event_walk.h"
#include "rain_scenes.h"

namespace dewbow::bench {
namespace {

struct Options {
    int width = 96, height = 54, samples = 16, repeats = 8, reference = 4096;
    std::string json;
};

enum class Method { law, next_event };

Colour<Xyz> sample(const PreparedScene& prepared, Method method, int x, int y, int index,
                   std::uint64_t seed) {
    const SampleKey key(stream_key(seed, std::uint32_t(x), std::uint32_t(y)), std::uint32_t(index));
    const RenderSettings& settings = prepared.scene.render;
    const WavelengthPacket packet =
        sample_wavelengths(settings.wavelengths, settings.packet,
                           key.third(0, Purpose::pixel_filter) / settings.packet);
    const Ray ray = prepared.camera.ray_through(x + 0.5, y + 0.5);
    const PixelSample result =
        method == Method::law
            ? trace_sample(prepared, ray, prepared.camera_media, packet, key)
            : NextEventWalk(prepared, packet, key, prepared.camera_media).run(ray);
    return xyz_from_lanes(packet, std::span(result.radiance).first(std::size_t(packet.count))) *
           (1.0 / cie_y_integral());
}

void render_row(const PreparedScene& prepared, Method method, int y, int samples,
                std::uint64_t seed, Picture& picture) {
    const int width = prepared.scene.film.width;
    for (int x = 0; x < width; ++x) {
        Colour<Xyz> sum{};
        for (int i = 0; i < samples; ++i) sum = sum + sample(prepared, method, x, y, i, seed);
        picture[std::size_t(y * width + x)] = sum * (1.0 / samples);
    }
}

struct Timed {
    Picture picture;
    double cpu_s;
};
Timed render(const PreparedScene& prepared, Method method, int samples, std::uint64_t seed) {
    const Film& film = prepared.scene.film;
    Timed timed{Picture(std::size_t(film.width * film.height)), cpu_seconds()};
    for (int y = 0; y < film.height; ++y)
        render_row(prepared, method, y, samples, seed, timed.picture);
    timed.cpu_s = cpu_seconds() - timed.cpu_s;
    return timed;
}

/// By all threads.
Picture render_patiently(const PreparedScene& prepared, Method method, int samples,
                         std::uint64_t seed) {
    const Film& film = prepared.scene.film;
    Picture picture(std::size_t(film.width * film.height));
    parallel_for(std::size_t(film.height), [&](std::size_t y) {
        render_row(prepared, method, int(y), samples, seed, picture);
    });
    return picture;
}

double mean_y(const Picture& picture) {
    double sum = 0.0;
    for (const Colour<Xyz>& pixel : picture) sum += pixel[1] / double(picture.size());
    return sum;
}

struct Measured {
    double sample_us = 0.0;  ///< least CPU time of a sample
    int samples = 0;
    double srgb = 0.0, y = 0.0;  ///< MSE
};
struct Report {
    std::string name, what;
    double dry_us;  ///< a sample without rain
    Measured law, next_event;
    double bias = 0.0;  ///< of the references' means, in standard errors
};

double us_of(double cpu_s, const PreparedScene& prepared, int samples) {
    return cpu_s * 1e6 / (double(prepared.scene.film.width) * prepared.scene.film.height * samples);
}

/// MSE of `samples` a pixel, the mean of all repeats.
void measure_error(const PreparedScene& prepared, Method method, const Reference& reference,
                   int repeats, Measured& measured) {
    for (int i = 0; i < repeats; ++i) {
        const Timed timed = render(prepared, method, measured.samples, 100 + std::uint64_t(i));
        const PictureError error = error_against(reference, timed.picture);
        measured.srgb += error.srgb / repeats, measured.y += error.y / repeats;
    }
}

Report measure(const RainScene& wet, const Options& options) {
    Scene dry = wet.scene;
    dry.rains.clear();
    const PreparedScene prepared(wet.scene), without(dry);
    constexpr double kForever = 1e300;
    Report report{wet.name, wet.what, kForever, {kForever}, {kForever}};
    const auto time = [&](const PreparedScene& scene, Method method, double& least) {
        least = std::min(
            least, us_of(render(scene, method, options.samples, 1).cpu_s, scene, options.samples));
    };
    for (int i = 0; i < options.repeats; ++i) {
        time(without, Method::law, report.dry_us);
        time(prepared, Method::law, report.law.sample_us);
        time(prepared, Method::next_event, report.next_event.sample_us);
    }
    const Picture by_law = render_patiently(prepared, Method::law, options.reference, 2),
                  by_next_event =
                      render_patiently(prepared, Method::next_event, options.reference, 3);
    const Reference reference = make_reference(by_law, by_next_event);
    const double error = std::sqrt(4.0 * reference.own.y / double(by_law.size()));
    report.bias = (mean_y(by_law) - mean_y(by_next_event)) / error;
    report.law.samples = options.samples;
    report.next_event.samples = std::max(
        1, int(std::lround(options.samples * report.law.sample_us / report.next_event.sample_us)));
    measure_error(prepared, Method::law, reference, options.repeats, report.law);
    measure_error(prepared, Method::next_event, reference, options.repeats, report.next_event);
    return report;
}

/// The law's MSE over that of next-event estimation, at equal time: samples are whole numbers, and
/// what they miss of it is made good, as errors go with their inverse.
double ratio(const Report& report, double Measured::*error) {
    const double law = report.law.*error * report.law.samples * report.law.sample_us;
    const double next_event =
        report.next_event.*error * report.next_event.samples * report.next_event.sample_us;
    return law / next_event;
}

void print(const Report& r) {
    std::printf("%s: %s\n", r.name.c_str(), r.what.c_str());
    std::printf(
        "    a sample costs %.2f us without rain, %.2f with it (%.2f times), %.2f by next "
        "event\n",
        r.dry_us, r.law.sample_us, r.law.sample_us / r.dry_us, r.next_event.sample_us);
    std::printf(
        "    MSE of sRGB %.3g (%d samples), by next event %.3g (%d samples): %.3f at equal "
        "time\n",
        r.law.srgb, r.law.samples, r.next_event.srgb, r.next_event.samples,
        ratio(r, &Measured::srgb));
    std::printf("    MSE of Y    %.3g, by next event %.3g: %.3f at equal time\n", r.law.y,
                r.next_event.y, ratio(r, &Measured::y));
    std::printf("    means differ by %+.2f standard errors\n", r.bias);
    std::fflush(stdout);
}

std::string json_of(const Measured& m) {
    char text[200];
    std::snprintf(text, sizeof text,
                  "{\"sample_us\": %.6g, \"samples\": %d, \"mse_srgb\": %.6g, \"mse_y\": %.6g}",
                  m.sample_us, m.samples, m.srgb, m.y);
    return text;
}
std::string json_of(const Report& r) {
    char text[300];
    std::snprintf(text, sizeof text,
                  "\"without_rain_us\": %.6g, \"equal_time_mse_srgb\": %.6g, \"equal_time_mse_y\": "
                  "%.6g, \"bias_in_standard_errors\": %.3g",
                  r.dry_us, ratio(r, &Measured::srgb), ratio(r, &Measured::y), r.bias);
    return "{\"scene\": \"" + r.name + "\", \"what\": \"" + r.what + "\", " + text +
           ", \"law\": " + json_of(r.law) + ", \"next_event\": " + json_of(r.next_event) + "}";
}

void run(const Options& options) {
    std::string json;
    for (const RainScene& scene : make_rain_scenes(options.width, options.height)) {
        const Report report = measure(scene, options);
        print(report);
        json += (json.empty() ? "[" : ",\n ") + json_of(report);
    }
    if (options.json.empty()) return;
    std::ofstream file(options.json);
    file << json << "]\n";
    if (!file.flush()) throw std::runtime_error("cannot write " + options.json);
}

Options read_options(const std::vector<std::string>& words) {
    Options options;
    const std::vector<std::pair<std::string, int*>> numbers = {{"--width", &options.width},
                                                               {"--height", &options.height},
                                                               {"--samples", &options.samples},
                                                               {"--repeats", &options.repeats},
                                                               {"--reference", &options.reference}};
    for (std::size_t i = 0; i < words.size(); i += 2) {
        if (i + 1 == words.size()) throw std::invalid_argument(words[i] + " wants a value");
        if (words[i] == "--json") {
            options.json = words[i + 1];
            continue;
        }
        const auto row = std::find_if(numbers.begin(), numbers.end(),
                                      [&](const auto& n) { return n.first == words[i]; });
        if (row == numbers.end()) throw std::invalid_argument("cannot make sense of " + words[i]);
        *row->second = std::stoi(words[i + 1]);
        if (*row->second < 1) throw std::invalid_argument(words[i] + " must be at least 1");
    }
    return options;
}

}  // namespace
}  // namespace dewbow::bench

int main(int argc, char** argv) {
    try {
        dewbow::bench::run(dewbow::bench::read_options({argv + 1, argv + argc}));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_rain_cost: %s\n", error.what());
        return 1;
    }
}
