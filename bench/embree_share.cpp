// SPDX-License-Identifier: Apache-2.0

// How much of Embree's speed is left when rays go through our accelerator, and when paths do?
//
//     bench_embree_share [--triangles 1000000] [--size 256] [--repeats 5]
//
// `path` renders a bumpy ball once while every ray that it hands to Embree is recorded: of a grey
// ball single rays from the camera, from surface to surface, and to lights; of a glass one also
// packets of eight. The same rays then go, in turn and by one thread, through Embree alone (a scene
// with the flags of ours, and one with Embree's own defaults; no filter, the start 1e-4 away from
// the surface instead of by name) and through our Accelerator; and the picture is rendered again.
// Times are the processor's, medians of the repeats; the table is Markdown.

#include <dlfcn.h>
#include <embree3/rtcore.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "ball_mesh.h"
#include "dewbow/optics/catalogue.h"
#include "dewbow/optics/dispersion.h"
#include "dewbow/render/accelerator_tree.h"
#include "dewbow/render/path/path.h"

namespace dewbow::bench {
namespace {

// ---- recording ----------------------------------------------------------------------------------

enum Kind { from_camera, between_surfaces, to_lights, packets_of_8, kKinds };
constexpr std::array<const char*, kKinds> kKindNames{"camera", "surface to surface", "shadow",
                                                     "packets of 8"};

struct RecordedRay {
    Ray ray;
    double limit;
};
struct RecordedPacket {
    RayLanes rays;
    LaneMask mask;
};

struct Records {
    std::array<std::vector<RecordedRay>, packets_of_8> single;
    std::vector<RecordedPacket> packets;

    std::size_t rays(Kind kind) const {
        if (kind != packets_of_8) return single[kind].size();
        std::size_t sum = 0;
        for (const RecordedPacket& p : packets) sum += std::size_t(std::popcount(p.mask));
        return sum;
    }
};

Records* recording = nullptr;  ///< where rays are noted, or nullptr

const Query& query_behind(RTCIntersectContext* context) {
    return reinterpret_cast<QueryContext<RTCIntersectContext>*>(context)->query;
}

/// What our accelerator asks a second time, beside an edge, is no ray of the path's.
bool is_new(const Query& query) { return recording && !query.back && !query.way_out; }

void record(RTCIntersectContext* context, unsigned lane, bool shadow) {
    const Query& query = query_behind(context);
    if (!is_new(query)) return;
    const Ray ray = query.rays->ray(int(lane));
    const Kind kind = shadow ? to_lights : ray.from.shape < 0 ? from_camera : between_surfaces;
    recording->single[kind].push_back({ray, query.t[lane]});
}

template <class Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace
}  // namespace dewbow::bench

// The linker prefers these to Embree's own, which they call.
RTC_API_EXTERN_C void rtcIntersect1(RTCScene scene, RTCIntersectContext* context,
                                    RTCRayHit* rayhit) {
    static const auto embree = dewbow::bench::next<decltype(&rtcIntersect1)>("rtcIntersect1");
    if (dewbow::bench::recording) dewbow::bench::record(context, rayhit->ray.id, false);
    embree(scene, context, rayhit);
}
RTC_API_EXTERN_C void rtcOccluded1(RTCScene scene, RTCIntersectContext* context, RTCRay* ray) {
    static const auto embree = dewbow::bench::next<decltype(&rtcOccluded1)>("rtcOccluded1");
    if (dewbow::bench::recording) dewbow::bench::record(context, ray->id, true);
    embree(scene, context, ray);
}
RTC_API_EXTERN_C void rtcIntersect8(const int* valid, RTCScene scene, RTCIntersectContext* context,
                                    RTCRayHit8* rayhit) {
    static const auto embree = dewbow::bench::next<decltype(&rtcIntersect8)>("rtcIntersect8");
    if (dewbow::bench::recording) {
        dewbow::LaneMask mask = 0;
        for (unsigned k = 0; k < 8; ++k) mask |= dewbow::LaneMask(valid[k] == -1) << k;
        dewbow::bench::recording->packets.push_back(
            {*dewbow::bench::query_behind(context).rays, mask});
    }
    embree(valid, scene, context, rayhit);
}

namespace dewbow::bench {
namespace {

// ---- the scene ----------------------------------------------------------------------------------

/// With bumps, of about `triangles` triangles.
std::shared_ptr<const Mesh> bumpy_ball(std::size_t triangles) {
    return ball_mesh(std::uint32_t(std::lround(std::sqrt(double(triangles) / 2.0))), 0.1);
}

Scene make_scene(const Material& material, const std::shared_ptr<const Mesh>& mesh, int size) {
    Scene scene = make_empty_scene();
    scene.add(material);
    scene.shapes.push_back({"ball", mesh, Transform<World, Object>(), 0});
    scene.lights.push_back(UniformEnvironment{make_constant(1.0)});
    scene.film.width = scene.film.height = size;
    scene.render.packet = 8;
    static_cast<CameraView&>(scene.camera) = frame_bounds(bounds_of(scene), 1.0);
    return scene;
}

void render(const PreparedScene& prepared) {
    for (int y = 0; y < prepared.scene.film.height; ++y)
        for (int x = 0; x < prepared.scene.film.width; ++x) trace_pixel_sample(prepared, x, y, 0);
}

// ---- Embree alone -------------------------------------------------------------------------------

class EmbreeAlone {
public:
    EmbreeAlone(const Mesh& mesh, bool as_ours) : device_(rtcNewDevice("isa=avx2")) {
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    3 * sizeof(float), mesh.vertices.size()));
        auto* indices = static_cast<std::uint32_t*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    3 * sizeof(std::uint32_t), mesh.triangles.size()));
        for (const auto& vertex : mesh.vertices)
            for (int axis = 0; axis < 3; ++axis) *vertices++ = float(vertex.v[axis]);
        for (const auto& triangle : mesh.triangles)
            indices = std::copy(triangle.begin(), triangle.end(), indices);
        rtcCommitGeometry(geometry);
        scene_ = rtcNewScene(device_);
        if (as_ours) {
            rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
            rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
        }
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    ~EmbreeAlone() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreeAlone(const EmbreeAlone&) = delete;
    EmbreeAlone& operator=(const EmbreeAlone&) = delete;

    /// The triangle that is hit, or −1; of a shadow ray 0 if it is stopped.
    int trace(const RecordedRay& recorded, bool shadow) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit hit;
        const Ray& ray = recorded.ray;
        hit.ray.org_x = float(ray.origin.x), hit.ray.dir_x = float(ray.direction.x);
        hit.ray.org_y = float(ray.origin.y), hit.ray.dir_y = float(ray.direction.y);
        hit.ray.org_z = float(ray.origin.z), hit.ray.dir_z = float(ray.direction.z);
        hit.ray.tnear = start_of(ray.from), hit.ray.tfar = float(recorded.limit);
        hit.ray.time = 0.0f, hit.ray.mask = ~0u, hit.ray.flags = 0;
        if (shadow) {
            rtcOccluded1(scene_, &context, &hit.ray);
            return hit.ray.tfar < 0.0f ? 0 : -1;
        }
        hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &context, &hit);
        return hit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? -1 : int(hit.hit.primID);
    }

    void trace(const RecordedPacket& packet, std::array<int, 8>& triangles) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        alignas(32) std::array<int, 8> valid;
        RTCRayHit8 hit;
        for (std::size_t k = 0; k < 8; ++k) {
            valid[k] = packet.mask >> k & 1u ? -1 : 0;
            hit.ray.org_x[k] = float(packet.rays.ox[k]),
            hit.ray.dir_x[k] = float(packet.rays.dx[k]);
            hit.ray.org_y[k] = float(packet.rays.oy[k]),
            hit.ray.dir_y[k] = float(packet.rays.dy[k]);
            hit.ray.org_z[k] = float(packet.rays.oz[k]),
            hit.ray.dir_z[k] = float(packet.rays.dz[k]);
            hit.ray.tnear[k] = start_of(packet.rays.from[k]);
            hit.ray.tfar[k] = std::numeric_limits<float>::infinity();
            hit.ray.time[k] = 0.0f, hit.ray.mask[k] = ~0u, hit.ray.flags[k] = 0;
            hit.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
        }
        rtcIntersect8(valid.data(), scene_, &context, &hit);
        for (std::size_t k = 0; k < 8; ++k)
            triangles[k] =
                hit.hit.geomID[k] == RTC_INVALID_GEOMETRY_ID ? -1 : int(hit.hit.primID[k]);
    }

private:
    static float start_of(const SurfaceFrom& from) { return from.shape < 0 ? 0.0f : 1e-4f; }

    RTCDevice device_;
    RTCScene scene_ = nullptr;
};

/// The same through our accelerator.
struct Ours {
    const Accelerator& accelerator;

    int trace(const RecordedRay& recorded, bool shadow) const {
        if (shadow) return accelerator.occluded(recorded.ray, recorded.limit) ? 0 : -1;
        return triangle_of(accelerator.intersect(recorded.ray));
    }
    void trace(const RecordedPacket& packet, std::array<int, 8>& triangles) const {
        HitLanes hits;
        accelerator.intersect(packet.rays, packet.mask, hits);
        for (std::size_t k = 0; k < 8; ++k) triangles[k] = triangle_of(hits[k]);
    }

private:
    static int triangle_of(const Hit& hit) { return hit ? hit.primitive : -1; }
};

// ---- measuring ----------------------------------------------------------------------------------

double cpu_s() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}
double time_of(const std::function<void()>& work) {
    const double start = cpu_s();
    work();
    return cpu_s() - start;
}
double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + long(values.size() / 2), values.end());
    return values[values.size() / 2];
}

/// What every ray of a kind hits.
template <class Tracer>
std::vector<int> trace_all(const Tracer& tracer, const Records& records, Kind kind) {
    std::vector<int> found;
    found.reserve(records.rays(kind));
    if (kind != packets_of_8) {
        for (const RecordedRay& ray : records.single[kind])
            found.push_back(tracer.trace(ray, kind == to_lights));
        return found;
    }
    std::array<int, 8> triangles{};
    for (const RecordedPacket& packet : records.packets) {
        tracer.trace(packet, triangles);
        for (LaneMask rest = packet.mask; rest; rest &= rest - 1)
            found.push_back(triangles[std::size_t(std::countr_zero(rest))]);
    }
    return found;
}

double agreement(const std::vector<int>& a, const std::vector<int>& b) {
    std::size_t same = 0;
    for (std::size_t i = 0; i < a.size(); ++i) same += a[i] == b[i];
    return double(same) / double(a.size());
}

struct Options {
    std::size_t triangles = 1'000'000;
    int size = 256, repeats = 5;
};

struct Times {
    std::vector<double> as_ours, defaults, ours;
};

void print_row(const std::string& ball, const char* kind, std::size_t rays, double as_ours_s,
               double defaults_s, double ours_s, const char* same) {
    const auto mega = [&](double seconds) { return double(rays) / seconds * 1e-6; };
    std::printf("| %s | %s | %zu | %.2f | %.2f | %.2f | %.0f %% | %.0f %% | %s |\n", ball.c_str(),
                kind, rays, mega(as_ours_s), mega(defaults_s), mega(ours_s),
                100.0 * as_ours_s / ours_s, 100.0 * defaults_s / ours_s, same);
    std::fflush(stdout);
}

void measure(const Material& material, const std::shared_ptr<const Mesh>& mesh,
             const Options& options) {
    const Scene scene = make_scene(material, mesh, options.size);
    const PreparedScene prepared(scene);
    Records records;
    recording = &records;
    render(prepared);
    recording = nullptr;
    const EmbreeAlone as_ours(*mesh, true), defaults(*mesh, false);
    const Ours ours{prepared.accelerator};
    std::array<Times, kKinds> times;
    std::vector<double> path_s;
    for (int repeat = 0; repeat < options.repeats; ++repeat) {
        for (int k = 0; k < kKinds; ++k) {
            const auto kind = Kind(k);
            Times& t = times[std::size_t(k)];
            t.as_ours.push_back(time_of([&] { trace_all(as_ours, records, kind); }));
            t.ours.push_back(time_of([&] { trace_all(ours, records, kind); }));
            t.defaults.push_back(time_of([&] { trace_all(defaults, records, kind); }));
        }
        path_s.push_back(time_of([&] { render(prepared); }));
    }
    double as_ours_s = 0.0, defaults_s = 0.0, ours_s = 0.0;
    std::size_t rays = 0;
    for (int k = 0; k < kKinds; ++k) {
        const auto kind = Kind(k);
        if (records.rays(kind) == 0) continue;
        const Times& t = times[std::size_t(k)];
        char same[16];
        std::snprintf(
            same, sizeof same, "%.3f %%",
            100.0 * agreement(trace_all(as_ours, records, kind), trace_all(ours, records, kind)));
        print_row(material.name, kKindNames[std::size_t(k)], records.rays(kind), median(t.as_ours),
                  median(t.defaults), median(t.ours), same);
        rays += records.rays(kind);
        as_ours_s += median(t.as_ours);
        defaults_s += median(t.defaults);
        ours_s += median(t.ours);
    }
    print_row(material.name, "all", rays, as_ours_s, defaults_s, ours_s, "");
    print_row(material.name, "all, within `path`", rays, as_ours_s, defaults_s, median(path_s), "");
}

Options read_options(const std::vector<std::string>& words) {
    Options options;
    for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
        if (words[i] == "--triangles")
            options.triangles = std::stoul(words[i + 1]);
        else if (words[i] == "--size")
            options.size = std::stoi(words[i + 1]);
        else if (words[i] == "--repeats")
            options.repeats = std::stoi(words[i + 1]);
        else
            throw std::invalid_argument("cannot make sense of " + words[i]);
    }
    if (words.size() % 2) throw std::invalid_argument(words.back() + " wants a value");
    return options;
}

void run(const Options& options) {
    const auto mesh = bumpy_ball(options.triangles);
    std::printf(
        "%zu triangles; Mray / CPU s; shares of Embree with our flags, and of Embree's "
        "defaults; rays that hit the same\n\n"
        "| ball | rays | number | Embree, our flags | Embree, defaults | ours | of the first "
        "| of the second | same |\n|---|---|---|---|---|---|---|---|---|\n",
        mesh->triangles.size());
    measure({"grey", Diffuse{make_constant(0.5)}}, mesh, options);
    const auto flint = std::make_shared<Medium>(
        Medium{"flint", make_dispersion(find_glass("schott/SF11").data), nullptr, 0});
    measure({"glass", Dielectric{flint}}, mesh, options);
}

}  // namespace
}  // namespace dewbow::bench

int main(int argc, char** argv) {
    try {
        dewbow::bench::run(dewbow::bench::read_options({argv + 1, argv + argc}));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_embree_share: %s\n", error.what());
        return 1;
    }
}
