// SPDX-License-Identifier: Apache-2.0
#pragma once

// Small glTF documents for tests: one triangle (0,0,0) (1,0,0) (0,1,0) in a data URI, and what is
// put around it.

#include <cstring>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "dewbow/import/gltf/gltf.h"

namespace dewbow::gltf_test {

inline std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned bits = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            bits =
                bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += i + k <= bytes.size() ? kDigits[(bits >> (18 - 6 * k)) & 63] : '=';
        }
    }
    return text;
}

template <class T>
std::string bytes_of(std::initializer_list<T> values) {
    std::string bytes;
    for (const T value : values) {
        char raw[sizeof(T)];
        std::memcpy(raw, &value, sizeof raw);
        bytes.append(raw, sizeof raw);
    }
    return bytes;
}

/// The parts of a document that tests vary. Buffer: 36 bytes of positions, then 3 indices of 2
/// bytes, 2 bytes of nothing.
struct Parts {
    std::string nodes = R"([{"mesh": 0}])";
    std::string roots = "[0]";
    std::string materials = R"([{"name": "m"}])";
    std::string primitive = R"({"attributes": {"POSITION": 0}, "indices": 1, "material": 0})";
    std::string accessors =
        R"([{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                                {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}])";
    std::string views =
        R"([{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 8}])";
    std::string bytes =
        bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) + bytes_of<std::uint16_t>({0, 1, 2, 0});
    std::string uri;   ///< empty: `bytes` as a data URI
    std::string rest;  ///< more members of the root, each with a comma before it
};

inline std::string text_of(const Parts& p) {
    const std::string uri =
        p.uri.empty() ? "data:application/octet-stream;base64," + base64(p.bytes) : p.uri;
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": )" + p.roots +
           R"(}], "nodes": )" + p.nodes + R"(, "materials": )" + p.materials +
           R"(, "meshes": [{"primitives": [)" + p.primitive + R"(]}], "accessors": )" +
           p.accessors + R"(, "bufferViews": )" + p.views + R"(, "buffers": [{"byteLength": )" +
           std::to_string(p.bytes.size()) + R"(, "uri": ")" + uri + R"("}])" + p.rest + "}";
}

inline ParsedScene parse(const Parts& parts, std::optional<double> time_s = {}) {
    return parse_gltf("test.gltf", text_of(parts), time_s);
}

inline const Mesh& mesh_of(const Shape& shape) {
    return *std::get<std::shared_ptr<const Mesh>>(shape.geometry);
}

/// The message of the InputError that reading `parts` throws; empty if it throws none.
inline std::string error_of(const Parts& parts, std::optional<double> time_s = {}) {
    try {
        parse(parts, time_s);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

/// A buffer that grows, with its views and accessors. Accessor 0 is the triangle's positions.
class Buffer {
public:
    Buffer() { add(bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}), "5126", 3, "VEC3"); }

    /// @param more  further members, each with a comma before it. Returns the view's index.
    int view(const std::string& bytes, const std::string& more = "") {
        views_ += (views_.empty() ? "" : ",") +
                  (R"({"buffer": 0, "byteOffset": )" + std::to_string(bytes_.size())) +
                  R"(, "byteLength": )" + std::to_string(bytes.size()) + more + "}";
        bytes_ += bytes;
        bytes_.resize((bytes_.size() + 3) / 4 * 4);
        return view_count_++;
    }
    /// Returns the accessor's index.
    int add(const std::string& bytes, const char* component_type, int count, const char* type,
            const std::string& more = "", const std::string& view_more = "") {
        const int where = view(bytes, view_more);
        accessors_ += (accessors_.empty() ? "" : ",") +
                      (R"({"bufferView": )" + std::to_string(where)) + R"(, "componentType": )" +
                      component_type + R"(, "count": )" + std::to_string(count) + R"(, "type": ")" +
                      type + "\"" + more + "}";
        return accessor_count_++;
    }
    /// The document with a primitive of those attributes: `"POSITION": 0`.
    Parts parts(const std::string& attributes, const std::string& primitive_more = "") const {
        Parts parts;
        parts.bytes = bytes_;
        parts.views = "[" + views_ + "]";
        parts.accessors = "[" + accessors_ + "]";
        parts.primitive =
            R"({"attributes": {)" + attributes + R"(}, "material": 0)" + primitive_more + "}";
        return parts;
    }

private:
    std::string bytes_, views_, accessors_;
    int view_count_ = 0, accessor_count_ = 0;
};

inline std::string data_uri(const std::string& bytes) {
    return "data:application/octet-stream;base64," + base64(bytes);
}

}  // namespace dewbow::gltf_test
