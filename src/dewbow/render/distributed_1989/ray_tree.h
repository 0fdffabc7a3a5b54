// SPDX-License-Identifier: Apache-2.0
#pragma once

// One sample of a pixel: the tree of rays that it grows.
//
// A ray from the camera has no wavelength. At mirrors and glass both what is reflected and what is
// refracted are followed, as far as they count [Whitted 1980; Hall & Greenberg 1983]. At its first
// boundary with dispersion what is refracted is split into N rays of one wavelength each, which
// never split again; what is reflected stays white [Musgrave 1989, 4.1]. Where a ray meets
// something rough it takes light from a point of a lamp, by one shadow ray [Cook, Porter &
// Carpenter 1984]. Of what rough surfaces give each other there is nothing but one ray from glossy
// ones.
//
// ray_tree.cpp follows rays, boundary.cpp has what glass does to them, lamps.cpp the light,
// fog.cpp the rainbow.

#include <optional>

#include "dewbow/base/random.h"
#include "dewbow/render/distributed_1989/method.h"
#include "dewbow/render/surface/local_frame.h"
#include "dewbow/render/surface/scattering_surface.h"
#include "dewbow/render/vertex.h"

namespace dewbow::distributed_1989 {

struct TracedRay {
    Ray ray;
    MediaStack media;
    BandValues beta;  ///< throughput
    int depth = 0;
    std::uint32_t branch = 0;  ///< tells the random numbers of branches apart
    int passed = 0;            ///< boundaries that are none since the last that was one
    bool sees_lamps = true;    ///< false: a shadow ray has counted them
};

/// Rays of one kind, without wavelength or of one sample, and what they have in common.
struct RayFamily {
    bool white;
    Bands bands;
    PacketMedia bend;  ///< indices at the wavelength by which they are refracted
    std::vector<TracedRay> pending{};
};

/// Memory that one thread needs for its trees, kept between samples.
struct Workspace {
    explicit Workspace(const Method& method);

    const std::uint64_t serial;  ///< of the prepared scene that it belongs to
    RayFamily white, sample;
    std::vector<double> offsets;
    std::vector<SpectralSample> samples;
};

/// A ray at a surface.
struct Meeting {
    TracedRay& ray;
    RayFamily& family;
    const Vertex& vertex;
    MonitorRgb& sum;  ///< what it brings home goes here
};

/// A boundary with dispersion or without, where a ray meets it: all of it if smooth, else the facet
/// that was drawn.
struct Interface {
    const Dielectric& glass;
    Boundary boundary;
    Vec3 normal;  ///< to the side that the ray comes from
    double cos_i;
    double alpha = 0.0;  ///< GGX; 0 = smooth
};

class RayTree {
public:
    RayTree(const Method& method, const SampleKey& key, Workspace& workspace)
        : method_(method), prepared_(method.prepared()), key_(key), workspace_(workspace) {}

    /// The sample of the key at pixel (x, y).
    PixelSample grow(int x, int y);
    /// What arrives along `ray`, which starts in `media`.
    PixelSample grow(const Ray& ray, MediaStack media);

private:
    // Following.
    PixelSample through_lens(int x, int y, const Ray& first);
    PixelSample finish(MonitorRgb sum);
    MonitorRgb follow(const TracedRay& first, RayFamily& family);
    void trace(TracedRay ray, RayFamily& family, MonitorRgb& sum);
    bool interact(const Meeting& at, const Material& material, int interior);
    bool reflect(const Meeting& at) const;
    bool metal(const Meeting& at, const Conductor& conductor) const;
    bool pane(const Meeting& at, const ThinDielectric& pane);

    // Glass.
    bool glass(const Meeting& at, const Dielectric& glass, int interior);
    std::optional<Interface> facet(const Meeting& at, Interface smooth) const;
    void refract(const Meeting& at, const Interface& face, const BandValues& reflectance);
    void split(const Meeting& at, const Interface& face);
    void draw_samples(std::uint32_t vertex);
    void start_sample(const SpectralSample& sample);
    MonitorRgb limited(MonitorRgb total, MonitorRgb white) const;
    static double eta(PacketMedia& media, const Boundary& boundary);
    double nominal_reflectance(const Interface& face);
    BandValues reflectance(RayFamily& family, const Interface& face);

    // Light.
    void look_through_fog(TracedRay& ray, RayFamily& family, const Hit& hit, MonitorRgb& sum) const;
    void fog_in_channels(TracedRay& ray, RayFamily& family, const PaperFog::Share& share,
                         MonitorRgb& sum) const;
    void add_lamp(const TracedRay& ray, RayFamily& family, const Hit& hit, MonitorRgb& sum) const;
    void add_infinite(const TracedRay& ray, RayFamily& family, MonitorRgb& sum) const;
    bool scatter(const Meeting& at, const Material& material) const;
    void direct_light(const Meeting& at, const LocalFrame& frame, const Material& material) const;
    bool gloss(const Meeting& at, const LocalFrame& frame, const Material& material) const;

    // Helpers.
    bool stops_shadows(int shape) const { return !prepared_.see_through[std::size_t(shape)]; }
    bool too_weak(const BandValues& beta) const;
    static void absorb(RayFamily& family, BandValues& beta, MediaStack media, double distance);
    static void tint(RayFamily& family, const ColourInput& tint, const Vertex& vertex,
                     BandValues& beta);
    static std::uint32_t vertex_key(const TracedRay& ray) {
        // 2³² / golden ratio: far apart.
        return std::uint32_t(ray.depth) + ray.branch * 0x9e3779b9u;
    }

    const Method& method_;
    const PreparedScene& prepared_;
    const SampleKey key_;
    Workspace& workspace_;
    PixelSample result_;
    std::uint32_t branches_ = 0;
};

/// Of a medium's index where there is one wavelength.
WavelengthPacket packet_of_one(double lambda_nm);

}  // namespace dewbow::distributed_1989
