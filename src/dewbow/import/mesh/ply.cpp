// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/mesh/ply.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "dewbow/import/mesh/clean.h"
#include "dewbow/import/mesh/ply_body.h"
#include "dewbow/spectrum/display.h"

namespace dewbow {
namespace {

using ply::Body;
using ply::Element;
using ply::Header;
using ply::Property;
using ply::Scalar;

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

/// What a vertex may have, by the names of its properties.
enum Slot { kX, kY, kZ, kNx, kNy, kNz, kRed, kGreen, kBlue, kAlpha, kU, kV, kSlots };
struct SlotName {
    const char* name;
    Slot slot;
};
constexpr SlotName kSlotNames[] = {
    {"x", kX},       {"y", kY},         {"z", kZ},         {"nx", kNx},
    {"ny", kNy},     {"nz", kNz},       {"red", kRed},     {"green", kGreen},
    {"blue", kBlue}, {"alpha", kAlpha}, {"s", kU},         {"t", kV},
    {"u", kU},       {"v", kV},         {"texture_u", kU}, {"texture_v", kV},
};

class VertexReader {
public:
    VertexReader(const Element& element, Body& body, Mesh& mesh)
        : element_(element), body_(body), mesh_(mesh), slots_(element.properties.size(), kSlots) {
        for (const SlotName& row : kSlotNames) {
            const auto found = element.find(row.name);
            if (!found || element.properties[*found].list_count || has_[row.slot]) continue;
            slots_[*found] = row.slot;
            has_[row.slot] = true;
            types_[row.slot] = element.properties[*found].type;
        }
        for (const Slot slot : {kX, kY, kZ})
            if (!has_[slot])
                throw InputError(body.place(), fmt::format("vertices have no property {}",
                                                           kSlotNames[slot].name));
    }

    /// The number of colour values that were out of range.
    std::uint64_t read() {
        const bool normals = has_[kNx] && has_[kNy] && has_[kNz];
        const bool colours = has_[kRed] && has_[kGreen] && has_[kBlue];
        const bool texcoords = has_[kU] && has_[kV];
        mesh_.vertices.reserve(element_.count);
        for (std::uint64_t i = 0; i < element_.count; ++i) {
            read_values();
            mesh_.vertices.push_back({{v_[kX], v_[kY], v_[kZ]}});
            if (normals) mesh_.normals.push_back({{v_[kNx], v_[kNy], v_[kNz]}});
            if (colours)
                mesh_.colours.push_back(
                    {colour(kRed), colour(kGreen), colour(kBlue), has_[kAlpha] ? alpha() : 1.0f});
            if (texcoords) mesh_.texcoords[0].push_back({float(v_[kU]), float(1.0 - v_[kV])});
        }
        return out_of_range_;
    }

private:
    void read_values() {
        for (std::size_t p = 0; p < slots_.size(); ++p) {
            if (slots_[p] == kSlots) {
                skip(element_.properties[p], body_);
            } else {
                v_[slots_[p]] = body_.number(element_.properties[p].type);
            }
        }
    }
    bool is_float(Slot slot) const { return types_[slot] >= Scalar::float32; }
    /// The value of `slot` as a part of the largest number of its type.
    double share(Slot slot) {
        constexpr double kLargest[] = {127.0, 255.0, 32767.0, 65535.0, 2147483647.0, 4294967295.0};
        const double value = is_float(slot) ? v_[slot] : v_[slot] / kLargest[int(types_[slot])];
        if (value >= 0.0 && value <= 1.0) return value;
        ++out_of_range_;
        return value > 1.0 ? 1.0 : 0.0;  // NaN is 0
    }
    float colour(Slot slot) {
        const double value = share(slot);
        return float(is_float(slot) ? value : srgb_decode(value));
    }
    float alpha() { return float(share(kAlpha)); }

    const Element& element_;
    Body& body_;
    Mesh& mesh_;
    std::vector<Slot> slots_;  ///< by property; kSlots = none
    std::array<bool, kSlots> has_{};
    std::array<Scalar, kSlots> types_{};
    std::array<double, kSlots> v_{};
    std::uint64_t out_of_range_ = 0;
};

void read_vertices(const Element& element, Body& body, Mesh& mesh, Diagnostics& diagnostics) {
    if (element.count > std::numeric_limits<std::uint32_t>::max()) {
        throw InputError(body.place(), "there are more vertices than a mesh can hold (4294967295)");
    }
    const SourcePlace place = body.place();
    if (const std::uint64_t count = VertexReader(element, body, mesh).read(); count > 0)
        diagnostics.push_back(
            {place,
             fmt::format("{} colour values of vertices are outside 0 to 1: held there", count)});
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

Mesh parse_ply(const std::string& file, std::string_view bytes, Diagnostics& diagnostics) {
    const Header header = ply::parse_header(file, bytes);
    const auto body = ply::make_body(file, bytes, header);
    Mesh mesh;
    bool has_vertices = false, has_faces = false;
    for (const Element& element : header.elements) {
        check_count(element, *body);
        if (element.name == "vertex" && !has_vertices) {
            has_vertices = true;
            read_vertices(element, *body, mesh, diagnostics);
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
