// SPDX-License-Identifier: Apache-2.0
#pragma once

// Numbers in buffers.

#include <array>
#include <memory>
#include <unordered_map>

#include "dewbow/import/gltf/document.h"
#include "dewbow/import/gltf/slice.h"

namespace dewbow::gltf {

/// Most elements of an accessor that no bytes stand behind.
inline constexpr std::uint64_t kMaxVirtualElements = std::uint64_t{1} << 22;

/// What an accessor must be for its use.
struct AccessorUse {
    std::string_view what;  ///< "positions", for messages
    int least_components, most_components;
    /// Whole numbers stand for 0 to 1, or −1 to 1, whatever the accessor says.
    bool always_normalised = false;
};
inline constexpr AccessorUse kPositionUse{"positions", 3, 3};
inline constexpr AccessorUse kNormalUse{"normals", 3, 3};
inline constexpr AccessorUse kTangentUse{"tangents", 4, 4};
inline constexpr AccessorUse kTexcoordUse{"texture coordinates", 2, 2};
inline constexpr AccessorUse kColourUse{"colours", 3, 4, true};
inline constexpr AccessorUse kVectorUse{"displacements, places and scales", 3, 3};
inline constexpr AccessorUse kRotationUse{"rotations", 4, 4, true};
inline constexpr AccessorUse kScalarUse{"times and weights", 1, 1};

/// Vectors of one to four numbers: floats, or whole numbers of 8 or 16 bits as they are or
/// normalised.  [glTF 2.0, 3.6.2 and 3.11; KHR_mesh_quantization]
class Accessor {
public:
    using Element = std::array<double, 4>;  ///< components that it does not have are 0

    /// @param index  the reference to it, for instance of "POSITION". Throws InputError.
    Accessor(Document& document, const Json& index, const AccessorUse& use);
    /// One whose numbers were unpacked from elsewhere, `components` in a row.
    Accessor(std::shared_ptr<const std::vector<float>> values, int components);

    std::uint64_t count() const { return count_; }
    int components() const { return components_; }
    /// `i` < count().
    Element operator[](std::uint64_t i) const;

private:
    enum class Component { byte, unsigned_byte, short_, unsigned_short, float_ };

    void read_type(const Json& accessor, const AccessorUse& use);
    void read_component(const Json& accessor, const AccessorUse& use);
    void read_sparse(Document& document, const Json& sparse);
    std::uint64_t component_bytes() const;
    double component_at(const char* where) const;
    Element element_at(const Slice& slice, std::uint64_t i) const;

    std::uint64_t count_ = 0;
    int components_ = 0;
    Component component_ = Component::float_;
    bool normalised_ = false;
    std::optional<Slice> dense_;  ///< none: zeros
    std::unordered_map<std::uint64_t, Element> sparse_;
    std::shared_ptr<const std::vector<float>> owned_;
};

inline Vec3 vec3_of(const Accessor::Element& e) { return {e[0], e[1], e[2]}; }

/// An accessor of type SCALAR, unsigned byte, short or int. Throws InputError.
std::vector<std::uint32_t> read_indices(Document& document, const Json& index);

}  // namespace dewbow::gltf
