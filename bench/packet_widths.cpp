// SPDX-License-Identifier: Apache-2.0

// How many wavelengths should one path carry? Error × processor time of packets of 1, 4, 8 and 16.
//
//     bench_packet_widths [--packets 1,4,8,16] [--spp 16,64] [--repeats 3] [--reference-spp 512]
//                         [--size 160x120] [--threads 1] [--references FOLDER] scene…
//
// The packets take turns, so that whatever else the machine does falls on all of them. Time is the
// processor's, not the wall's. References are two independent renders with packet 16 of
// --reference-spp samples each; --references keeps them in FOLDER for the next run (empty it when a
// scene changes; --repeats 0 renders them alone). JSON lines come first, then a table in Markdown:
// ratios of 1 / (MSE × CPU s) to the first packet.

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "dewbow/base/parallel.h"
#include "dewbow/import/import.h"
#include "dewbow/render/session.h"
#include "picture_error.h"

namespace dewbow::bench {
namespace {

constexpr int kReferencePacket = 16;
/// References and contestants share no seed.
constexpr std::uint64_t kReferenceSeed = 1'000'001;

struct Options {
    std::vector<int> packets = {1, 4, 8, 16}, spp = {16, 64};
    int repeats = 3, reference_spp = 512, width = 160, height = 120, threads = 1;
    std::filesystem::path references;
    std::vector<std::filesystem::path> scenes;
};

struct Timed {
    Picture picture;
    double cpu_s = 0.0;
};

Timed render(Scene& scene, int packet, int spp, std::uint64_t seed) {
    scene.render.packet = packet;
    scene.render.samples_per_pixel = spp;
    scene.render.seed = seed;
    const auto estimator = estimators().front().make(scene);
    FilmSums film = make_film(scene, {});
    const std::clock_t start = std::clock();
    run_session(scene, *estimator, {}, film);
    Timed timed;
    timed.cpu_s = double(std::clock() - start) / CLOCKS_PER_SEC;
    for (int y = 0; y < film.height(); ++y)
        for (int x = 0; x < film.width(); ++x) timed.picture.push_back(film.xyz(x, y));
    return timed;
}

/// A half of the reference, from the folder if it is there.
Picture reference_half(const Options& options, const std::string& name, Scene& scene, int half) {
    std::ostringstream file;
    file << name << '_' << options.width << 'x' << options.height << '_' << options.reference_spp
         << '_' << half << ".xyz";
    const std::filesystem::path path = options.references / file.str();
    Picture picture(std::size_t(options.width) * std::size_t(options.height));
    const auto bytes = std::streamsize(picture.size() * sizeof(picture[0]));
    if (!options.references.empty()) {
        std::ifstream in(path, std::ios::binary);
        if (in.read(reinterpret_cast<char*>(picture.data()), bytes)) return picture;
    }
    picture =
        render(scene, kReferencePacket, options.reference_spp, kReferenceSeed + std::uint64_t(half))
            .picture;
    if (!options.references.empty()) {
        std::filesystem::create_directories(options.references);
        std::ofstream(path, std::ios::binary)
            .write(reinterpret_cast<const char*>(picture.data()), bytes);
    }
    return picture;
}

/// One packet width at one number of samples, over all repeats.
struct Runs {
    std::vector<double> cpu_s;
    std::vector<PictureError> errors;

    double cpu() const { return median(cpu_s); }
    double error(double PictureError::*value) const {
        std::vector<double> all;
        for (const PictureError& e : errors) all.push_back(e.*value);
        return median(all);
    }
};

void print_json(const std::string& scene, int spp, int packet, const Runs& runs) {
    std::printf("{\"scene\": \"%s\", \"spp\": %d, \"packet\": %d, \"cpu_s\": %.4g", scene.c_str(),
                spp, packet, runs.cpu());
    for (const ErrorColumn& column : error_columns())
        std::printf(", \"mse_%s\": %.4g", column.name.c_str(), runs.error(column.value));
    std::printf("}\n");
    std::fflush(stdout);
}

std::string table_row(const std::string& scene, int spp, int packet, const Runs& runs,
                      const Runs& first) {
    char text[160];
    std::snprintf(text, sizeof text, "| %s | %d | %d | %.3g | %.2f | %.3g |", scene.c_str(), spp,
                  packet, runs.cpu(), runs.cpu() / first.cpu(), runs.error(&PictureError::srgb));
    std::string row = text;
    for (const ErrorColumn& column : error_columns()) {
        const double cost = runs.error(column.value) * runs.cpu();
        std::snprintf(text, sizeof text, " %.2f |", first.error(column.value) * first.cpu() / cost);
        row += text;
    }
    return row + '\n';
}

/// Rows of the table for one scene.
std::string measure(const Options& options, const std::filesystem::path& path) {
    const std::string name = path.stem().string();
    Scene scene = load_scene(path).scene;
    scene.film.width = options.width;
    scene.film.height = options.height;
    const Reference reference = make_reference(reference_half(options, name, scene, 0),
                                               reference_half(options, name, scene, 1));
    std::printf("{\"scene\": \"%s\", \"reference_own_mse_sRGB\": %.4g, \"trimmed\": %.4g}\n",
                name.c_str(), reference.own.srgb, reference.own.trimmed);
    std::string rows;
    if (options.repeats == 0) return rows;
    for (const int spp : options.spp) {
        std::map<int, Runs> runs;
        for (int repeat = 0; repeat < options.repeats; ++repeat) {
            for (const int packet : options.packets) {
                const Timed timed = render(scene, packet, spp, std::uint64_t(repeat));
                runs[packet].cpu_s.push_back(timed.cpu_s);
                runs[packet].errors.push_back(error_against(reference, timed.picture));
            }
        }
        for (const int packet : options.packets) {
            print_json(name, spp, packet, runs[packet]);
            rows += table_row(name, spp, packet, runs[packet], runs[options.packets.front()]);
        }
    }
    return rows;
}

std::vector<int> numbers(const std::string& text) {
    std::vector<int> values;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, ',');) values.push_back(std::stoi(part));
    return values;
}

Options read_options(const std::vector<std::string>& words) {
    Options options;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (word.rfind("--", 0) != 0) {
            options.scenes.emplace_back(word);
            continue;
        }
        if (i + 1 == words.size()) throw std::invalid_argument(word + " wants a value");
        const std::string& value = words[++i];
        if (word == "--packets")
            options.packets = numbers(value);
        else if (word == "--spp")
            options.spp = numbers(value);
        else if (word == "--repeats")
            options.repeats = std::stoi(value);
        else if (word == "--reference-spp")
            options.reference_spp = std::stoi(value);
        else if (word == "--threads")
            options.threads = std::stoi(value);
        else if (word == "--references")
            options.references = value;
        else if (word != "--size" ||
                 std::sscanf(value.c_str(), "%dx%d", &options.width, &options.height) != 2)
            throw std::invalid_argument("cannot make sense of " + word + ' ' + value);
    }
    if (options.scenes.empty() || options.packets.empty())
        throw std::invalid_argument("no scene, or no packet, is named");
    return options;
}

void run(const Options& options) {
    set_thread_count(options.threads);
    std::string rows;
    for (const auto& scene : options.scenes) rows += measure(options, scene);
    std::printf("\n| scene | spp | packet | CPU s | CPU ratio | MSE sRGB |");
    for (const ErrorColumn& column : error_columns()) std::printf(" %s |", column.name.c_str());
    std::printf("\n|---|---|---|---|---|---|");
    for (std::size_t i = 0; i < error_columns().size(); ++i) std::printf("---|");
    std::printf("\n%s", rows.c_str());
}

}  // namespace
}  // namespace dewbow::bench

int main(int argc, char** argv) {
    try {
        dewbow::bench::run(dewbow::bench::read_options({argv + 1, argv + argc}));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_packet_widths: %s\n", error.what());
        return 1;
    }
}
