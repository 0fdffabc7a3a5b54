// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/media.h"

#include <algorithm>
#include <cmath>

#include "dewbow/base/error.h"
#include "dewbow/render/accelerator.h"
#include "dewbow/render/bounds_index.h"

namespace dewbow {

namespace {

constexpr int kMaxNested = 8;

/// Where two media must agree for a boundary to be none: the ends and the middle of the visible
/// range decide for every smooth dispersion.
constexpr std::array<double, 5> kProbe_nm{360.0, 450.0, 550.0, 680.0, 830.0};
/// Differences of index below this bend no ray by more than a rounding of its direction.
constexpr double kSameIndex = 1e-12;

const Dielectric* dielectric_of(const Material& material) {
    return std::get_if<Dielectric>(&material.surface);
}

/// Whether shapes of this material are bodies with an inside, for some paths at least.
bool may_be_body(const Scene& scene, const Material& material) {
    const auto* mix = std::get_if<Mix>(&material.surface);
    if (!mix) return dielectric_of(material) != nullptr;
    return may_be_body(scene, scene.materials[std::size_t(mix->first)]) ||
           may_be_body(scene, scene.materials[std::size_t(mix->second)]);
}

bool is_clear(const Medium& medium) { return !medium.absorption && !medium.scattering; }

bool same_index(const Dispersion& a, const Dispersion& b) {
    std::array<double, kProbe_nm.size()> n_a, n_b;
    a.eval_lanes(kProbe_nm, n_a);
    b.eval_lanes(kProbe_nm, n_b);
    for (std::size_t i = 0; i < n_a.size(); ++i)
        if (std::abs(n_a[i] - n_b[i]) > kSameIndex) return false;
    return true;
}

/// How often a ray leaves bodies of each medium more often than it enters them, on its way to
/// infinity.
std::vector<int> bodies_left_along(Ray ray, const Scene& scene, const MediaTable& media,
                                   const Accelerator& accelerator) {
    std::vector<int> balance(std::size_t(media.size()), 0);
    constexpr int kMostSurfaces = 10000;
    for (int i = 0; i < kMostSurfaces; ++i) {
        const Hit hit = accelerator.intersect(ray);
        if (!hit) break;
        const bool inward = dot(ray.direction, hit.normal) < 0.0;
        const int id = media.interior_of(scene.shapes[std::size_t(hit.shape)].material);
        if (id > 0) balance[std::size_t(id)] += inward ? -1 : 1;
        ray.origin += ray.direction * hit.t;
        ray.from = {hit.shape, hit.primitive, inward};
    }
    return balance;
}

}  // namespace

MediaStack MediaStack::entered(int id) const {
    MediaStack result;
    std::uint64_t rest = ids_;
    int shift = 0;
    bool placed = false;
    while ((rest != 0 || !placed) && shift < 8 * kMaxNested) {
        const int top = int(rest & 0xff);
        const bool take_new = !placed && id >= top;
        result.ids_ |= std::uint64_t(take_new ? id : top) << shift;
        if (take_new)
            placed = true;
        else
            rest >>= 8;
        shift += 8;
    }
    return result;
}

MediaStack MediaStack::left(int id) const {
    MediaStack result;
    int shift = 0;
    bool removed = false;
    for (std::uint64_t rest = ids_; rest != 0; rest >>= 8) {
        const int top = int(rest & 0xff);
        if (top == id && !removed) {
            removed = true;
            continue;
        }
        result.ids_ |= std::uint64_t(top) << shift;
        shift += 8;
    }
    return result;
}

bool MediaStack::holds(int id) const {
    for (std::uint64_t rest = ids_; rest != 0; rest >>= 8)
        if (int(rest & 0xff) == id) return true;
    return false;
}

Boundary boundary_at(MediaStack media, bool front, int id) {
    Boundary b;
    // A ray that leaves a body which it never entered (an open mesh) was inside after all.
    b.before = !front && !media.holds(id) ? media.entered(id) : media;
    b.after = front ? b.before.entered(id) : b.before.left(id);
    b.none = b.before.interior() == b.after.interior();
    return b;
}

MediaTable::MediaTable(const Scene& scene) : interior_(scene.materials.size(), -1) {
    std::vector<MediumPtr> bodies;
    for (const Material& material : scene.materials) {
        const Dielectric* dielectric = dielectric_of(material);
        if (dielectric &&
            std::find(bodies.begin(), bodies.end(), dielectric->interior) == bodies.end())
            bodies.push_back(dielectric->interior);
    }
    constexpr std::size_t kMostMedia = 255;
    if (bodies.size() > kMostMedia)
        throw InputError("the scene has " + std::to_string(bodies.size()) +
                         " different glasses; at most 255 are possible");
    std::stable_sort(bodies.begin(), bodies.end(),
                     [](const auto& a, const auto& b) { return a->priority < b->priority; });
    media_.push_back(scene.surroundings);
    media_.insert(media_.end(), bodies.begin(), bodies.end());
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const Dielectric* dielectric = dielectric_of(scene.materials[i]);
        if (!dielectric) continue;
        const auto found = std::find(bodies.begin(), bodies.end(), dielectric->interior);
        interior_[i] = 1 + int(found - bodies.begin());
    }
}

bool MediaTable::scatters() const {
    return std::any_of(media_.begin(), media_.end(),
                       [](const MediumPtr& medium) { return medium->scattering != nullptr; });
}

void PacketMedia::begin(const WavelengthPacket& packet) {
    packet_ = packet;
    ++generation_;
}

void PacketMedia::fill(Entry& e, int id) {
    e.generation = generation_;
    const Medium& medium = table_.medium(id);
    const auto lambdas = packet_.lambdas();
    medium.index->eval_lanes(lambdas, std::span(e.index).first(lambdas.size()));
    e.dims = !is_clear(medium);
    e.scatters = medium.scattering != nullptr;
    if (!e.dims) return;
    const auto extinction = std::span(e.extinction).first(lambdas.size());
    if (medium.absorption)
        medium.absorption->eval_lanes(lambdas, extinction);
    else
        std::fill(extinction.begin(), extinction.end(), 0.0);
    if (!e.scatters) return;
    medium.scattering->eval_lanes(lambdas, std::span(e.scattering).first(lambdas.size()));
    for (std::size_t k = 0; k < lambdas.size(); ++k) extinction[k] += e.scattering[k];
}

MediaStack media_at(Vec3 point, const Scene& scene, const MediaTable& media,
                    const Accelerator& accelerator) {
    // Directions parallel to no edge of a scene made by people. For closed bodies one would do; of
    // three the middle answer also holds where an open sheet of glass stands in one of them.
    constexpr std::array<Vec3, 3> kDirections{
        {{0.557, 0.743, 0.371}, {-0.811, -0.303, 0.500}, {0.193, -0.604, -0.773}}};
    std::array<std::vector<int>, 3> entered;
    for (std::size_t i = 0; i < 3; ++i)
        entered[i] =
            bodies_left_along({point, normalised(kDirections[i]), {}}, scene, media, accelerator);
    MediaStack stack;
    for (std::size_t id = 1; id < std::size_t(media.size()); ++id) {
        std::array<int, 3> counts{entered[0][id], entered[1][id], entered[2][id]};
        std::sort(counts.begin(), counts.end());
        for (int n = 0; n < counts[1]; ++n) stack = stack.entered(int(id));
    }
    return stack;
}

std::vector<bool> see_through_shapes(const Scene& scene) {
    std::vector<bool> clear, bends;  // one a material
    for (const Material& material : scene.materials) {
        const Dielectric* d = dielectric_of(material);
        clear.push_back(d && !material.gives_light() && !d->tint && is_clear(*d->interior) &&
                        is_clear(*scene.surroundings) &&
                        same_index(*d->interior->index, *scene.surroundings->index));
        bends.push_back(!clear.back() && may_be_body(scene, material));
    }
    std::vector<bool> result;
    for (const Shape& shape : scene.shapes) result.push_back(clear[std::size_t(shape.material)]);
    if (std::find(result.begin(), result.end(), true) == result.end()) return result;

    constexpr double kFar = 1e300;
    std::vector<Bounds> all = bounds_of_shapes(scene), bending(scene.shapes.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (std::holds_alternative<Plane>(scene.shapes[i].geometry))
            all[i] = {{-kFar, -kFar, -kFar}, {kFar, kFar, kFar}};
        if (bends[std::size_t(scene.shapes[i].material)]) bending[i] = all[i];
    }
    const BoundsIndex index(std::move(bending));
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = result[i] && !index.any(all[i], [](std::size_t) { return true; });
    return result;
}

}  // namespace dewbow
