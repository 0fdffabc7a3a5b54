// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/convex_solid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "dewbow/base/simd.h"

#if defined(__x86_64__) && defined(__GNUC__)
#define DEWBOW_X86
#include <immintrin.h>
#endif

namespace dewbow {

namespace {

/// Facets whose normals differ by less, and corners that lie off a plane by less (relative to the
/// size of the coordinates), are flat: coordinates in files have seven to nine digits.
constexpr double kFlat = 1e-6;
/// A lane leaves by the facet that another lane found if its point lies within the facet, widened
/// by this share of the coordinates: rounding.
constexpr double kWithin = 1e-12;

constexpr int kBlock = 8;  ///< facets that are searched at a time

using Key = std::array<double, 3>;
Key key_of(Vec3 v) { return {v.x, v.y, v.z}; }

/// The facet of each triangle: triangles in one plane belong together.
std::vector<int> merge_facets(const std::vector<FacetPlane>& planes, double scale,
                              std::vector<FacetPlane>& facets) {
    std::vector<int> facet_of;
    for (const FacetPlane& plane : planes) {
        const auto same = std::find_if(facets.begin(), facets.end(), [&](const FacetPlane& f) {
            const Vec3 apart = f.normal - plane.normal;
            return dot(apart, apart) < kFlat * kFlat &&
                   std::abs(f.distance - plane.distance) < kFlat * scale;
        });
        facet_of.push_back(int(same - facets.begin()));
        if (same == facets.end()) facets.push_back(plane);
        if (facets.size() > ConvexSolid::kMostFacets) return {};
    }
    return facet_of;
}

struct FacetColumns {
    const float *nx, *ny, *nz, *d;
    int count;  ///< a multiple of kBlock
};
struct FloatRay {
    float ox, oy, oz, dx, dy, dz;
};

/// The index of the facet that a ray from inside meets first: least height / slope over slopes > 0.
int nearest_facet_plain(const FacetColumns& f, const FloatRay& ray) {
    float nearest = std::numeric_limits<float>::infinity();
    int best = 0;
    for (int i = 0; i < f.count; ++i) {
        const float slope = f.nx[i] * ray.dx + f.ny[i] * ray.dy + f.nz[i] * ray.dz;
        const float height = f.d[i] - (f.nx[i] * ray.ox + f.ny[i] * ray.oy + f.nz[i] * ray.oz);
        const float t = std::max(height, 0.0f) / slope;
        if (slope > 0.0f && t < nearest) nearest = t, best = i;
    }
    return best;
}

#ifdef DEWBOW_X86
// Without branches, whose outcome nobody can predict.
__attribute__((target("avx2"))) __m256 least_of_all(__m256 v) {
    v = _mm256_min_ps(v, _mm256_permute2f128_ps(v, v, 1));
    v = _mm256_min_ps(v, _mm256_permute_ps(v, _MM_SHUFFLE(1, 0, 3, 2)));
    return _mm256_min_ps(v, _mm256_permute_ps(v, _MM_SHUFFLE(2, 3, 0, 1)));
}
__attribute__((target("avx2"))) int least_of_all(__m256i v) {
    v = _mm256_min_epi32(v, _mm256_permute2x128_si256(v, v, 1));
    v = _mm256_min_epi32(v, _mm256_shuffle_epi32(v, _MM_SHUFFLE(1, 0, 3, 2)));
    v = _mm256_min_epi32(v, _mm256_shuffle_epi32(v, _MM_SHUFFLE(2, 3, 0, 1)));
    return _mm256_cvtsi256_si32(v);
}

/// The same, eight facets at a time. (The compiler keeps the running minimum in memory if left to
/// itself, which costs three times as much.)
__attribute__((target("avx2"))) int nearest_facet_avx2(const FacetColumns& f, const FloatRay& ray) {
    const __m256 dx = _mm256_set1_ps(ray.dx), dy = _mm256_set1_ps(ray.dy),
                 dz = _mm256_set1_ps(ray.dz);
    const __m256 ox = _mm256_set1_ps(ray.ox), oy = _mm256_set1_ps(ray.oy),
                 oz = _mm256_set1_ps(ray.oz);
    const __m256 zero = _mm256_setzero_ps();
    const __m256 infinite = _mm256_set1_ps(std::numeric_limits<float>::infinity());
    __m256 nearest = infinite;
    __m256i best = _mm256_setzero_si256();
    __m256i index = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    for (int i = 0; i < f.count; i += kBlock) {
        const __m256 x = _mm256_loadu_ps(f.nx + i), y = _mm256_loadu_ps(f.ny + i);
        const __m256 z = _mm256_loadu_ps(f.nz + i);
        const __m256 slope = _mm256_add_ps(
            _mm256_add_ps(_mm256_mul_ps(x, dx), _mm256_mul_ps(y, dy)), _mm256_mul_ps(z, dz));
        const __m256 inside = _mm256_add_ps(
            _mm256_add_ps(_mm256_mul_ps(x, ox), _mm256_mul_ps(y, oy)), _mm256_mul_ps(z, oz));
        const __m256 height = _mm256_max_ps(_mm256_sub_ps(_mm256_loadu_ps(f.d + i), inside), zero);
        // Infinite by the slope's sign bit; 0 / 0 is not nearer, and not the minimum.
        const __m256 t = _mm256_blendv_ps(_mm256_div_ps(height, slope), infinite, slope);
        const __m256i nearer = _mm256_castps_si256(_mm256_cmp_ps(t, nearest, _CMP_LT_OQ));
        nearest = _mm256_min_ps(t, nearest);
        best = _mm256_blendv_epi8(best, index, nearer);
        index = _mm256_add_epi32(index, _mm256_set1_epi32(kBlock));
    }
    const __m256 least = least_of_all(nearest);
    // Ties go to the lower index, as in the plain form.
    const __m256i candidates =
        _mm256_blendv_epi8(_mm256_set1_epi32(std::numeric_limits<int>::max()), best,
                           _mm256_castps_si256(_mm256_cmp_ps(nearest, least, _CMP_EQ_OQ)));
    return least_of_all(candidates);
}
#endif

int nearest_facet(const FacetColumns& facets, const FloatRay& ray) {
#ifdef DEWBOW_X86
    static const bool avx2 = __builtin_cpu_supports("avx2");
    if (avx2) return nearest_facet_avx2(facets, ray);
#endif
    return nearest_facet_plain(facets, ray);
}

/// Distances along the first `count` rays to a plane, and whether the points there lie within all
/// `neighbours`.
DEWBOW_SIMD void distances_to_facet(const FacetPlane& plane, const FacetPlane* neighbours,
                                    int neighbour_count, double margin, int count,
                                    const RayLanes& rays, double* t, double* within) {
    for (int k = 0; k < count; ++k) {
        const auto i = std::size_t(k);
        const double slope =
            plane.normal.x * rays.dx[i] + plane.normal.y * rays.dy[i] + plane.normal.z * rays.dz[i];
        const double height =
            plane.distance - (plane.normal.x * rays.ox[i] + plane.normal.y * rays.oy[i] +
                              plane.normal.z * rays.oz[i]);
        t[k] = height / slope;
        within[k] = slope > 0.0 && height >= 0.0 ? 1.0 : 0.0;
    }
    alignas(64) std::array<double, kMaxLanes> x, y, z;
    for (int k = 0; k < count; ++k) {
        const auto i = std::size_t(k);
        x[i] = rays.ox[i] + t[k] * rays.dx[i];
        y[i] = rays.oy[i] + t[k] * rays.dy[i];
        z[i] = rays.oz[i] + t[k] * rays.dz[i];
    }
    for (int j = 0; j < neighbour_count; ++j) {
        const Vec3 n = neighbours[j].normal;
        const double limit = neighbours[j].distance + margin;
        for (int k = 0; k < count; ++k) {
            const auto i = std::size_t(k);
            within[k] = n.x * x[i] + n.y * y[i] + n.z * z[i] <= limit ? within[k] : 0.0;
        }
    }
}

}  // namespace

std::optional<ConvexSolid> ConvexSolid::from_triangles(
    const std::vector<Vec3>& vertices, const std::vector<std::array<std::uint32_t, 3>>& triangles,
    const std::vector<FacetPlane>& planes, double contact) {
    double scale = 0.0;
    for (const Vec3& v : vertices) scale = std::max(scale, length(v));
    ConvexSolid solid;
    solid.contact_ = contact;
    solid.facet_of_triangle_ = merge_facets(planes, scale, solid.facets_);
    const std::vector<int>& facet_of = solid.facet_of_triangle_;
    if (facet_of.empty() || solid.facets_.size() < 4) return std::nullopt;
    for (const FacetPlane& f : solid.facets_)
        for (const auto& triangle : triangles)
            for (const std::uint32_t corner : triangle)
                if (dot(f.normal, vertices[corner]) > f.distance + kFlat * scale)
                    return std::nullopt;

    // Closed: each edge is met once in each direction. Corners are the same where they coincide.
    std::map<std::pair<Key, Key>, int> facet_of_edge;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (int corner = 0; corner < 3; ++corner) {
            const Key a = key_of(vertices[triangles[i][std::size_t(corner)]]);
            const Key b = key_of(vertices[triangles[i][std::size_t((corner + 1) % 3)]]);
            if (!facet_of_edge.insert({{a, b}, facet_of[i]}).second) return std::nullopt;
        }
    std::vector<std::set<int>> adjacent(solid.facets_.size());
    for (const auto& [edge, facet] : facet_of_edge) {
        const auto other = facet_of_edge.find({edge.second, edge.first});
        if (other == facet_of_edge.end()) return std::nullopt;
        if (other->second != facet) adjacent[std::size_t(facet)].insert(other->second);
    }

    for (std::size_t f = 0; f < solid.facets_.size(); ++f) {
        solid.triangle_of_facet_.push_back(
            int(std::find(facet_of.begin(), facet_of.end(), int(f)) - facet_of.begin()));
        std::vector<FacetPlane>& neighbours = solid.neighbours_.emplace_back();
        for (const int a : adjacent[f]) neighbours.push_back(solid.facets_[std::size_t(a)]);
    }
    for (const FacetPlane& f : solid.facets_) {
        solid.nx_.push_back(float(f.normal.x)), solid.ny_.push_back(float(f.normal.y));
        solid.nz_.push_back(float(f.normal.z)), solid.d_.push_back(float(f.distance));
    }
    while (solid.nx_.size() % kBlock) {  // planes that no ray meets
        for (auto* column : {&solid.nx_, &solid.ny_, &solid.nz_}) column->push_back(0.0f);
        solid.d_.push_back(1.0f);
    }
    return solid;
}

std::vector<int> ConvexSolid::facet_triangles(int triangle) const {
    std::vector<int> result;
    for (std::size_t i = 0; i < facet_of_triangle_.size(); ++i)
        if (facet_of_triangle_[i] == facet_of_triangle_[std::size_t(triangle)])
            result.push_back(int(i));
    return result;
}

int ConvexSolid::search(Vec3 o, Vec3 d) const {
    return nearest_facet({nx_.data(), ny_.data(), nz_.data(), d_.data(), int(nx_.size())},
                         {float(o.x), float(o.y), float(o.z), float(d.x), float(d.y), float(d.z)});
}

void ConvexSolid::set_hit(int facet, const RayLanes& rays, int lane, Hit& hit) const {
    const FacetPlane& plane = facets_[std::size_t(facet)];
    const double slope = dot(plane.normal, rays.direction(lane));
    const double height = plane.distance - dot(plane.normal, rays.origin(lane));
    hit.t = slope > 0.0 ? std::max(0.0, height / slope - contact_) : 0.0;
    hit.primitive = triangle_of_facet_[std::size_t(facet)];
    hit.normal = plane.normal;
    hit.u = hit.v = 0.0;
}

LaneMask ConvexSolid::try_facet(int facet, const RayLanes& rays, LaneMask mask,
                                std::span<Hit> hits) const {
    const FacetPlane& plane = facets_[std::size_t(facet)];
    const std::vector<FacetPlane>& neighbours = neighbours_[std::size_t(facet)];
    alignas(64) std::array<double, kMaxLanes> t, within;
    distances_to_facet(plane, neighbours.data(), int(neighbours.size()),
                       kWithin * std::abs(plane.distance), rays.count, rays, t.data(),
                       within.data());
    LaneMask left = 0;
    for (LaneMask rest = mask; rest; rest &= rest - 1) {
        const auto k = std::size_t(std::countr_zero(rest));
        if (within[k] == 0.0) {
            left |= 1u << k;
            continue;
        }
        Hit& hit = hits[k];
        hit.t = std::max(0.0, t[k] - contact_);
        hit.primitive = triangle_of_facet_[std::size_t(facet)];
        hit.normal = plane.normal;
        hit.u = hit.v = 0.0;
    }
    return left;
}

void ConvexSolid::leave(const RayLanes& rays, LaneMask mask, std::span<Hit> hits) const {
    while (mask) {
        const int lane = std::countr_zero(mask);
        const LaneMask this_lane = 1u << lane;
        const int facet = search(rays.origin(lane), rays.direction(lane));
        const LaneMask left = mask == this_lane ? mask : try_facet(facet, rays, mask, hits);
        if (left & this_lane) set_hit(facet, rays, lane, hits[std::size_t(lane)]);
        mask = left & ~this_lane;
    }
}

}  // namespace dewbow
