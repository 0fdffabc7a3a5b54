// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/draco.h"

#include <draco/compression/decode.h>
#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace dewbow::gltf {
namespace {

/// Triangles a byte of stream: encoders need one to four bits for one in large regular meshes.
constexpr std::uint64_t kMostTrianglesPerByte = 64;
/// Triangles that any stream may claim, however short.
constexpr std::uint64_t kFreeTriangles = 1 << 16;
constexpr std::uint64_t kMaxAttributeId = 0xffffffff;

/// Reads the first bytes of a stream.  [Draco bitstream 2.2, "Draco Decoder"]
class Header {
public:
    explicit Header(std::string_view bytes) : bytes_(bytes) {}

    /// Why Draco must not see the stream, or nothing.
    std::optional<std::string> objection() {
        if (!bytes_.starts_with("DRACO")) return "it does not begin with \"DRACO\"";
        at_ = 5;
        const unsigned major = byte(), minor = byte(), geometry = byte(), method = byte();
        const unsigned flags = byte() | byte() << 8;
        if (major != 2 || minor != 2)
            return fmt::format("it is of Draco's version {}.{}; glTF's is 2.2", major, minor);
        if (geometry != 1) return "it holds no mesh";
        if ((flags & 0x8000) != 0) return "it holds metadata";
        if (method == 1) byte();  // how edges are walked
        const std::uint64_t first = number(), second = number();
        const std::uint64_t triangles = method == 1 ? second : first;
        const std::uint64_t vertices = method == 1 ? first : second;
        const std::uint64_t most = kFreeTriangles + kMostTrianglesPerByte * bytes_.size();
        if (triangles > most || vertices > 3 * most) {
            return fmt::format("{} bytes cannot hold {} triangles and {} vertices", bytes_.size(),
                               triangles, vertices);
        }
        return std::nullopt;
    }

private:
    unsigned byte() { return at_ < bytes_.size() ? static_cast<unsigned char>(bytes_[at_++]) : 0u; }
    /// Seven bits a byte, the lowest first; the eighth says that more follow.
    std::uint64_t number() {
        std::uint64_t value = 0;
        for (int shift = 0; shift < 63; shift += 7) {
            const unsigned b = byte();
            value |= std::uint64_t(b & 0x7f) << shift;
            if ((b & 0x80) == 0) break;
        }
        return value;
    }

    std::string_view bytes_;
    std::size_t at_ = 0;
};

std::unique_ptr<draco::Mesh> decode(const Json& compression, std::string_view packed) {
    if (const auto objection = Header(packed).objection())
        compression.fail("its Draco stream cannot be read: " + *objection);
    draco::DecoderBuffer buffer;
    buffer.Init(packed.data(), packed.size());
    try {
        auto result = draco::Decoder().DecodeMeshFromBuffer(&buffer);
        if (result.ok()) return std::move(result).value();
        compression.fail("its Draco stream is damaged: " + result.status().error_msg_string());
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {
    }
    compression.fail("its Draco stream is damaged: it asks for too much memory");
}

/// The largest value of a whole number of that type; 1 for others.
double largest_of(draco::DataType type) {
    switch (type) {
        case draco::DT_INT8:
            return 127.0;
        case draco::DT_UINT8:
            return 255.0;
        case draco::DT_INT16:
            return 32767.0;
        case draco::DT_UINT16:
            return 65535.0;
        default:
            return 1.0;
    }
}

class AttributeReader {
public:
    AttributeReader(const Json& place, const draco::PointAttribute& attribute)
        : place_(place), attribute_(attribute) {}

    /// Of `vertices` vertices. Colours are shares of what their type holds.
    DracoMesh::Values read(std::uint64_t vertices, bool is_colour) const {
        const int components = attribute_.num_components();
        if (components < 1 || components > 4)
            place_.fail(fmt::format("has {} components; 1 to 4 are read", components));
        check_bytes();
        std::vector<float> values(vertices * std::uint64_t(components));
        for (std::uint64_t i = 0; i < vertices; ++i) {
            const auto index = attribute_.mapped_index(draco::PointIndex(std::uint32_t(i)));
            if (index.value() >= attribute_.size()) damaged();
            if (!attribute_.ConvertValue<float>(index, std::int8_t(components),
                                                &values[i * std::uint64_t(components)]))
                damaged();
        }
        if (is_colour && !attribute_.normalized()) {
            const double most = largest_of(attribute_.data_type());
            for (float& value : values) value = float(double(value) / most);
        }
        return {components, std::make_shared<const std::vector<float>>(std::move(values))};
    }

private:
    [[noreturn]] void damaged() const { place_.fail("its Draco stream is damaged"); }

    void check_bytes() const {
        const auto* buffer = attribute_.buffer();
        const std::int64_t needed =
            attribute_.byte_offset() + attribute_.byte_stride() * std::int64_t(attribute_.size());
        if (!buffer || std::int64_t(buffer->data_size()) < needed) damaged();
    }

    const Json& place_;
    const draco::PointAttribute& attribute_;
};

std::vector<std::uint32_t> indices_of(const Json& compression, const draco::Mesh& mesh) {
    std::vector<std::uint32_t> indices;
    indices.reserve(3 * std::size_t(mesh.num_faces()));
    for (std::uint32_t i = 0; i < mesh.num_faces(); ++i) {
        for (const draco::PointIndex& corner : mesh.face(draco::FaceIndex(i))) {
            if (corner.value() >= mesh.num_points())
                compression.fail("its Draco stream is damaged: a triangle has no such vertex");
            indices.push_back(corner.value());
        }
    }
    return indices;
}

}  // namespace

DracoMesh unpack_draco(const Json& compression, std::string_view packed) {
    const std::unique_ptr<draco::Mesh> mesh = decode(compression, packed);
    DracoMesh result;
    result.vertices = mesh->num_points();
    result.indices = indices_of(compression, *mesh);
    const Json attributes = compression.require("attributes");
    for (const std::string& name : attributes.keys()) {
        const Json id = attributes.require(name);
        const auto* attribute =
            mesh->GetAttributeByUniqueId(std::uint32_t(id.whole(kMaxAttributeId)));
        if (!attribute) id.fail("the Draco stream has no attribute of that number");
        result.attributes.emplace(
            name,
            AttributeReader(id, *attribute).read(result.vertices, name.starts_with("COLOR_")));
    }
    return result;
}

}  // namespace dewbow::gltf
