// SPDX-License-Identifier: Apache-2.0
#pragma once

// Which media a path is inside of, and their indices at the wavelengths of its packet.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "dewbow/scene/scene.h"

namespace dewbow {

/// The media that a point lies in, as up to eight ids of one byte, the strongest lowest. Id 0 means
/// none: beneath all of them lie the surroundings. The interior is the medium of highest priority.
/// [Schmidt & Budge, "Simple Nested Dielectrics in Ray Traced Images", 2002]
class MediaStack {
public:
    constexpr int interior() const { return int(ids_ & 0xff); }
    constexpr bool operator==(const MediaStack&) const = default;

    /// With `id` added. A ninth medium is dropped: the weakest.
    MediaStack entered(int id) const;
    /// With one `id` taken out, if it is there.
    MediaStack left(int id) const;
    bool holds(int id) const;

private:
    std::uint64_t ids_ = 0;  // sorted, descending from the lowest byte
};

/// All media of a scene, numbered from 1 by ascending priority; 0 are the surroundings.
class MediaTable {
public:
    explicit MediaTable(const Scene& scene);

    int size() const { return int(media_.size()); }
    const Medium& medium(int id) const { return *media_[std::size_t(id)]; }
    /// Whether any of them does.
    bool scatters() const;
    /// Id of what is inside shapes of this material, or −1 if it is no body.
    int interior_of(int material) const { return interior_[std::size_t(material)]; }

private:
    std::vector<MediumPtr> media_;
    std::vector<int> interior_;
};

/// Index, extinction and scattering of each medium at the wavelengths of one packet, computed when
/// first asked for.
class PacketMedia {
public:
    explicit PacketMedia(const MediaTable& table)
        : table_(table), entries_(std::size_t(table.size())) {}

    /// Forgets everything: a new packet begins.
    void begin(const WavelengthPacket& packet);

    /// Absolute index of medium `id` at each lane of the packet.
    const std::array<double, kMaxLanes>& index(int id) { return entry(id).index; }
    /// Extinction coefficient, absorption and scattering together, in m⁻¹ at each lane; nullptr if
    /// the medium is clear.
    const std::array<double, kMaxLanes>* extinction(int id) {
        Entry& e = entry(id);
        return e.dims ? &e.extinction : nullptr;
    }
    /// Scattering coefficient in m⁻¹ at each lane; nullptr if the medium scatters nothing.
    const std::array<double, kMaxLanes>* scattering(int id) {
        Entry& e = entry(id);
        return e.scatters ? &e.scattering : nullptr;
    }

private:
    struct Entry {
        std::uint64_t generation = 0;
        bool dims = false, scatters = false;
        alignas(64) std::array<double, kMaxLanes> index;
        alignas(64) std::array<double, kMaxLanes> extinction;
        alignas(64) std::array<double, kMaxLanes> scattering;
    };
    Entry& entry(int id) {
        Entry& e = entries_[std::size_t(id)];
        if (e.generation != generation_) fill(e, id);
        return e;
    }
    void fill(Entry& e, int id);

    const MediaTable& table_;
    std::vector<Entry> entries_;
    WavelengthPacket packet_;
    std::uint64_t generation_ = 0;
};

/// One boundary between media, as a ray meets it.
struct Boundary {
    MediaStack before, after;
    bool none = false;  ///< the same medium on both sides
};
/// @param media  what the ray lies in.   @param front  whether it enters the body of medium `id`.
Boundary boundary_at(MediaStack media, bool front, int id);

class Accelerator;
/// The media that `point` lies in, found by rays to the outside.
MediaStack media_at(Vec3 point, const Scene& scene, const MediaTable& media,
                    const Accelerator& accelerator);

/// One a shape: whether it is not there for light, and shadow rays go through it: its boundary
/// neither bends nor dims anything against the surroundings, which are clear too, and no body that
/// bends light comes near it.
std::vector<bool> see_through_shapes(const Scene& scene);

}  // namespace dewbow
