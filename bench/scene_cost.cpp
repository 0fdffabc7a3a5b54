// SPDX-License-Identifier: Apache-2.0

// What do large scenes cost? Time to read and to prepare, memory, and rays a second, of meshes of
// 10³ to 10⁷ triangles, of 10³ to 10⁶ shapes that share a mesh of 1000 triangles, of 10³ and 10⁴
// that have such a mesh of their own, and of 10³ to 10⁶ spheres.
//
//     bench_scene_cost [--most 10000000] [--rays 1000000] [--cases mesh,shared,own,sphere]
//
// Each case runs in a process of its own, whose peak memory is the case's. Times are the
// processor's, of all threads together; rays are traced by one thread. The table is Markdown.

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "dewbow/base/random.h"
#include "dewbow/import/import.h"
#include "dewbow/math/sampling.h"
#include "dewbow/render/path/path.h"

namespace dewbow::bench {
namespace {

struct Options {
    std::size_t most = 10'000'000, rays = 1'000'000;
    std::string cases = "mesh,shared,own,sphere";
};

double cpu_s() { return double(std::clock()) / CLOCKS_PER_SEC; }
double peak_gib() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return double(usage.ru_maxrss) / (1024.0 * 1024.0);
}

std::array<double, 3> numbers(std::uint64_t stream, std::size_t i, std::uint32_t which) {
    const SampleKey key(stream_key(stream, std::uint32_t(i), which), 0);
    const auto a = key.two(0, Purpose::test);
    return {a[0], a[1], key.one(1, Purpose::test)};
}

/// Hills of about `triangles` triangles over a square of side 2, as a binary PLY file.
void write_hills(const std::filesystem::path& path, std::size_t triangles) {
    const auto n = std::uint32_t(std::lround(std::sqrt(double(triangles) / 2.0)));
    std::ofstream out(path, std::ios::binary);
    out << "ply\nformat binary_little_endian 1.0\nelement vertex " << (n + 1) * (n + 1)
        << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << 2 * n * n
        << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (std::uint32_t row = 0; row <= n; ++row)
        for (std::uint32_t column = 0; column <= n; ++column) {
            const double x = 2.0 * column / n - 1.0, z = 2.0 * row / n - 1.0;
            const double y = 0.1 * std::sin(9.0 * x) * std::cos(7.0 * z) +
                             0.01 * std::sin(61.0 * x + 3.0) * std::sin(53.0 * z);
            const std::array<float, 3> v{float(x), float(y), float(z)};
            out.write(reinterpret_cast<const char*>(v.data()), sizeof v);
        }
    const auto write_triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const std::array<std::uint32_t, 3> corners{a, b, c};
        out.put(3);
        out.write(reinterpret_cast<const char*>(corners.data()), sizeof corners);
    };
    for (std::uint32_t row = 0; row < n; ++row)
        for (std::uint32_t column = 0; column < n; ++column) {
            const std::uint32_t a = row * (n + 1) + column, b = a + n + 1;
            write_triangle(a, b, a + 1);
            write_triangle(a + 1, b, b + 1);
        }
}

/// The hills as a scene file in a folder of its own, loaded as `dewbow render` does.
Scene load_hills(std::size_t triangles, double& read_s) {
    const auto folder =
        std::filesystem::temp_directory_path() / ("dewbow_scene_cost_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    write_hills(folder / "hills.ply", triangles);
    std::ofstream(folder / "scene.toml")
        << "[materials.grey]\ntype = \"diffuse\"\nreflectance = 0.5\n"
           "[[shapes]]\ntype = \"mesh\"\nmaterial = \"grey\"\n"
           "file = \"hills.ply\"\n"
           "[[lights]]\ntype = \"environment\"\nradiance = 1\n";
    const double start = cpu_s();
    Scene scene = load_scene(folder / "scene.toml").scene;
    read_s = cpu_s() - start;
    std::filesystem::remove_all(folder);
    return scene;
}

/// A ball of 1000 triangles: 20 × 25 quadrangles, those at the poles cut to nothing.
std::shared_ptr<const Mesh> ball_of_1000() {
    constexpr std::uint32_t kRows = 20, kColumns = 25;
    auto mesh = std::make_shared<Mesh>();
    for (std::uint32_t r = 0; r <= kRows; ++r)
        for (std::uint32_t c = 0; c < kColumns; ++c) {
            const double theta = std::numbers::pi * (r + 0.01) / (kRows + 0.02);
            const double phi = 2.0 * std::numbers::pi * c / kColumns;
            mesh->vertices.push_back({{std::sin(theta) * std::cos(phi), std::cos(theta),
                                       -std::sin(theta) * std::sin(phi)}});
        }
    for (std::uint32_t r = 0; r < kRows; ++r)
        for (std::uint32_t c = 0; c < kColumns; ++c) {
            const std::uint32_t a = r * kColumns + c, b = r * kColumns + (c + 1) % kColumns;
            mesh->triangles.push_back({a, a + kColumns, b});
            mesh->triangles.push_back({b, a + kColumns, b + kColumns});
        }
    return mesh;
}

/// Balls or spheres at random in the cube from −1 to 1, filling a tenth of it.
Scene scatter(const Geometry& unit_ball, std::size_t count) {
    Scene scene = make_empty_scene();
    scene.add({"grey", Diffuse{make_constant(0.5)}});
    scene.lights.push_back(UniformEnvironment{make_constant(1.0)});
    const double radius = std::cbrt(0.1 * 8.0 / (double(count) * 4.0 / 3.0 * std::numbers::pi));
    for (std::size_t i = 0; i < count; ++i) {
        const auto [x, y, z] = numbers(1, i, 0);
        const auto [a, b, turn] = numbers(1, i, 1);
        const Affine place =
            translation({2.0 * x - 1.0, 2.0 * y - 1.0, 2.0 * z - 1.0}) *
            rotation(sample_uniform_sphere<World>(a, b).v, turn * 360.0 * unit::deg) *
            scaling({radius, radius, radius});
        scene.shapes.push_back({"ball", unit_ball, Transform<World, Object>(place), 0});
    }
    return scene;
}

/// The same, each with a mesh of its own.
Scene scatter_own(std::size_t count) {
    Scene scene = scatter(ball_of_1000(), count);
    for (Shape& shape : scene.shapes) shape.geometry = std::shared_ptr<const Mesh>(ball_of_1000());
    return scene;
}

std::size_t most_of(const std::string& kind) {
    return kind == "mesh" ? 10'000'000 : kind == "own" ? 10'000 : 1'000'000;
}

/// Rays from a ball around the scene to points in its middle; the nearest hit of each.
double mega_rays_per_s(const PreparedScene& prepared, std::size_t rays) {
    std::size_t hits = 0;
    const double start = cpu_s();
    for (std::size_t i = 0; i < rays; ++i) {
        const auto [a, b, c] = numbers(2, i, 0);
        const auto [d, e, f] = numbers(2, i, 1);
        const Vec3 origin = 2.0 * sample_uniform_sphere<World>(a, b).v;
        const Vec3 target{2.0 * d - 1.0, 0.2 * (2.0 * e - 1.0), 2.0 * f - 1.0};
        hits += bool(prepared.accelerator.intersect({origin, normalised(target - origin), {}}));
    }
    const double seconds = cpu_s() - start;
    if (hits == 0) throw std::runtime_error("no ray hit anything");
    return double(rays) / seconds * 1e-6;
}

void measure(const std::string& kind, std::size_t count, const Options& options) {
    double read_s = 0.0;
    const double begin = cpu_s();
    const Scene scene = kind == "mesh"     ? load_hills(count, read_s)
                        : kind == "shared" ? scatter(ball_of_1000(), count)
                        : kind == "own"    ? scatter_own(count)
                                           : scatter(Sphere{1.0 * unit::m}, count);
    const double described_gib = peak_gib();
    if (kind != "mesh") read_s = cpu_s() - begin;
    const double start = cpu_s();
    const PreparedScene prepared(scene);
    const double prepare_s = cpu_s() - start;
    std::printf("| %s | %zu | %.2f | %.2f | %.2f | %.2f | %.2f |\n", kind.c_str(), count, read_s,
                prepare_s, described_gib, peak_gib(), mega_rays_per_s(prepared, options.rays));
    std::fflush(stdout);
}

void run(const Options& options) {
    std::printf(
        "| case | triangles or shapes | read, CPU s | prepare, CPU s | GiB when read | "
        "GiB at most | Mray / CPU s |\n|---|---|---|---|---|---|---|\n");
    std::fflush(stdout);
    for (const std::string kind : {"mesh", "shared", "own", "sphere"}) {
        if (options.cases.find(kind) == std::string::npos) continue;
        const std::size_t most = std::min(options.most, most_of(kind));
        for (std::size_t count = 1000; count <= most; count *= 10) {
            const pid_t child = fork();
            if (child == 0) {
                measure(kind, count, options);
                std::exit(0);
            }
            int status = 0;
            waitpid(child, &status, 0);
            if (status != 0) std::printf("| %s | %zu | failed |\n", kind.c_str(), count);
        }
    }
}

Options read_options(const std::vector<std::string>& words) {
    Options options;
    for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
        if (words[i] == "--most")
            options.most = std::stoul(words[i + 1]);
        else if (words[i] == "--rays")
            options.rays = std::stoul(words[i + 1]);
        else if (words[i] == "--cases")
            options.cases = words[i + 1];
        else
            throw std::invalid_argument("cannot make sense of " + words[i]);
    }
    if (words.size() % 2) throw std::invalid_argument(words.back() + " wants a value");
    return options;
}

}  // namespace
}  // namespace dewbow::bench

int main(int argc, char** argv) {
    try {
        dewbow::bench::run(dewbow::bench::read_options({argv + 1, argv + argc}));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_scene_cost: %s\n", error.what());
        return 1;
    }
}
