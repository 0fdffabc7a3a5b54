// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a PLY file says that it holds.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dewbow::ply {

enum class Format { ascii, little_endian, big_endian };
/// The types of numbers, whole ones first.
enum class Scalar { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t size_of(Scalar scalar);

struct Property {
    std::string name;
    Scalar type = Scalar::float32;
    std::optional<Scalar> list_count;  ///< the type of a list's length, if it is a list
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;

    /// Where the property of that name stands; nothing if there is none.
    std::optional<std::size_t> find(std::string_view property) const;
};

struct Header {
    Format format = Format::ascii;
    std::vector<Element> elements;
    std::size_t body_offset = 0;  ///< in bytes
    std::size_t body_line = 0;    ///< from 1
};

/// Throws InputError with line and excerpt.
Header parse_header(const std::string& file, std::string_view bytes);

}  // namespace dewbow::ply
