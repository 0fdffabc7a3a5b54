// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/mesh/ply.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "dewbow/import/mesh/clean.h"
#include "dewbow/import/mesh/ply_body.h"

namespace dewbow {
namespace {

using ply::Body;
using ply::Element;
using ply::Header;
using ply::Property;

/// Refuses `count` elements that the bytes left cannot hold.
void check_count(const Element& element, const Body& body) {
    std::uint64_t least = 0;
    for (const Property& property : element.properties) {
        least += body.least_bytes(property.list_count.value_or(property.type));
    }
    if (least == 0 || element.count <= body.left() / least) return;
    throw InputError(body.place(),
                     fmt::format("there cannot be {} elements \"{}\": {} bytes are left",
                                 element.count, element.name, body.left()));
}

std::uint64_t read_list_length(const Property& property, Body& body) {
    const double length = body.number(*property.list_count);
    const double most = double(body.left()) / double(body.least_bytes(property.type));
    if (!(length >= 0.0 && length <= most) || length != std::floor(length)) {
        throw InputError(body.place(),
                         fmt::format("a list of {} numbers does not fit in the {} bytes "
                                     "that are left",
                                     length, body.left()));
    }
    return std::uint64_t(length);
}

void skip(const Property& property, Body& body) {
    const std::uint64_t count = property.list_count ? read_list_length(property, body) : 1;
    for (std::uint64_t i = 0; i < count; ++i) body.number(property.type);
}

void skip(const Element& element, Body& body) {
    if (element.properties.empty()) return;
    for (std::uint64_t i = 0; i < element.count; ++i) {
        for (const Property& property : element.properties) skip(property, body);
    }
}

/// Which of x, y, z, nx, ny, nz each property is; -1 = none of them.
std::vector<int> slots_of(const Element& element, const Body& body) {
    constexpr const char* kNames[] = {"x", "y", "z", "nx", "ny", "nz"};
    std::vector<int> slots(element.properties.size(), -1);
    for (int i = 0; i < 6; ++i) {
        const auto found = element.find(kNames[i]);
        if (found && !element.properties[*found].list_count) {
            slots[*found] = i;
        } else if (i < 3) {
            throw InputError(body.place(), fmt::format("vertices have no property {}", kNames[i]));
        }
    }
    return slots;
}

void read_vertices(const Element& element, Body& body, Mesh& mesh) {
    if (element.count > std::numeric_limits<std::uint32_t>::max()) {
        throw InputError(body.place(), "there are more vertices than a mesh can hold (4294967295)");
    }
    const std::vector<int> slots = slots_of(element, body);
    const bool normals = element.find("nx") && element.find("ny") && element.find("nz");
    mesh.vertices.reserve(element.count);
    if (normals) mesh.normals.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
        std::array<double, 6> v{};
        for (std::size_t p = 0; p < slots.size(); ++p) {
            if (slots[p] < 0) {
                skip(element.properties[p], body);
            } else {
                v[std::size_t(slots[p])] = body.number(element.properties[p].type);
            }
        }
        mesh.vertices.push_back({{v[0], v[1], v[2]}});
        if (normals) mesh.normals.push_back({{v[3], v[4], v[5]}});
    }
}

/// The indices of one face into `corners`.
void read_corners(const Property& property, Body& body, std::uint64_t face, const Mesh& mesh,
                  std::vector<std::uint32_t>& corners) {
    corners.clear();
    const std::uint64_t count = read_list_length(property, body);
    for (std::uint64_t i = 0; i < count; ++i) {
        const double index = body.number(property.type);
        if (!(index >= 0.0 && index < double(mesh.vertices.size())) || index != std::floor(index)) {
            throw InputError(body.place(),
                             fmt::format("face {} uses vertex {}; there are {}, from 0", face + 1,
                                         index, mesh.vertices.size()));
        }
        corners.push_back(std::uint32_t(index));
    }
}

void read_faces(const Element& element, Body& body, Mesh& mesh) {
    auto list = element.find("vertex_indices");
    if (!list) list = element.find("vertex_index");
    if (!list || !element.properties[*list].list_count) {
        throw InputError(body.place(), "faces have no list vertex_indices");
    }
    std::vector<std::uint32_t> corners;
    for (std::uint64_t face = 0; face < element.count; ++face) {
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            if (p == *list) {
                read_corners(element.properties[p], body, face, mesh, corners);
                add_polygon(mesh, corners);
            } else {
                skip(element.properties[p], body);
            }
        }
    }
}

}  // namespace

Mesh parse_ply(const std::string& file, std::string_view bytes) {
    const Header header = ply::parse_header(file, bytes);
    const auto body = ply::make_body(file, bytes, header);
    Mesh mesh;
    bool has_vertices = false, has_faces = false;
    for (const Element& element : header.elements) {
        check_count(element, *body);
        if (element.name == "vertex" && !has_vertices) {
            has_vertices = true;
            read_vertices(element, *body, mesh);
        } else if (element.name == "face" && !has_faces) {
            has_faces = true;
            if (!has_vertices) throw InputError(body->place(), "faces stand before vertices");
            read_faces(element, *body, mesh);
        } else {
            skip(element, *body);
        }
    }
    if (!has_vertices || !has_faces) {
        throw InputError(
            SourcePlace{file, 0, 0, {}},
            has_vertices ? "has no faces: point clouds are not shown" : "has no vertices");
    }
    return mesh;
}

}  // namespace dewbow
