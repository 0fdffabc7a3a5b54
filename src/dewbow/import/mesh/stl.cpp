// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/mesh/stl.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <limits>
#include <unordered_map>

#include "dewbow/base/parse_number.h"
#include "dewbow/import/mesh/words.h"

namespace dewbow {
namespace {

/// A binary file: 80 bytes of anything, the number of triangles, then for each of them a normal and
/// three corners as floats, and two bytes of anything; all little-endian.
constexpr std::size_t kHeadBytes = 80, kStartBytes = 84, kTriangleBytes = 50, kNormalBytes = 12;

template <class T>
T little_endian(const char* bytes) {
    static_assert(std::endian::native == std::endian::little);
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
}

/// Makes one vertex of all corners at one place.
class Welder {
public:
    explicit Welder(Mesh& mesh) : mesh_(mesh) {}

    std::uint32_t vertex_at(Vec3 p) {
        const auto [found, is_new] = index_of_.try_emplace(Key{bits(p.x), bits(p.y), bits(p.z)},
                                                           std::uint32_t(mesh_.vertices.size()));
        if (is_new) mesh_.vertices.push_back({p});
        return found->second;
    }

private:
    using Key = std::array<std::uint64_t, 3>;
    struct Hash {
        std::size_t operator()(const Key& key) const {
            std::uint64_t hash = 0;
            for (const std::uint64_t part : key)  // Knuth's multiplier, golden ratio · 2⁶⁴
                hash = (std::rotl(hash, 23) ^ part) * 0x9e3779b97f4a7c15u;
            return hash ^ (hash >> 32);
        }
    };
    static std::uint64_t bits(double x) {
        return std::bit_cast<std::uint64_t>(x == 0.0 ? 0.0 : x);  // −0 is 0
    }

    Mesh& mesh_;
    std::unordered_map<Key, std::uint32_t, Hash> index_of_;
};

class TextReader {
public:
    TextReader(const std::string& file, std::string_view text) : file_(file), text_(text) {}

    Mesh read() {
        LineReader lines(text_);
        bool in_solid = false;
        while (lines.next()) {
            line_ = lines.number();
            words_.clear();
            split_words(lines.line(), words_);
            if (words_.empty()) continue;
            if (words_[0] == "solid") in_solid = true;
            if (words_[0] == "endsolid") in_solid = false;
            read_statement();
        }
        if (in_solid || corners_ != 0) fail("the file ends before \"endsolid\"");
        return std::move(mesh_);
    }

private:
    [[noreturn]] void fail(const std::string& sentence) const {
        throw InputError({file_, line_, 0, {}}, sentence, std::string(line_of(text_, line_)));
    }

    void read_statement() {
        const std::string_view keyword = words_[0];
        if (keyword == "vertex") {
            read_vertex();
        } else if (keyword == "endloop" || keyword == "endfacet") {
            if (corners_ != 0 && corners_ != 3)
                fail(fmt::format("a facet has {} corners; it must have 3", corners_));
            corners_ = 0;
        } else if (keyword != "solid" && keyword != "facet" && keyword != "outer" &&
                   keyword != "endsolid") {
            fail(
                fmt::format("unknown word \"{}\"; expected solid, facet, outer, vertex, endloop, "
                            "endfacet or endsolid",
                            keyword.substr(0, 40)));
        }
    }

    void read_vertex() {
        if (words_.size() < 4) fail("\"vertex\" needs three numbers");
        std::array<double, 3> v{};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto number = parse_number<double>(words_[i + 1]);
            if (!number) fail(fmt::format("\"{}\" is no number", words_[i + 1].substr(0, 40)));
            v[i] = *number;
        }
        if (corners_ == 3) fail("a facet has a fourth corner; it must have 3");
        triangle_[corners_++] = welder_.vertex_at({v[0], v[1], v[2]});
        if (corners_ == 3) mesh_.triangles.push_back(triangle_);
    }

    const std::string& file_;
    std::string_view text_;
    std::size_t line_ = 0;
    std::vector<std::string_view> words_;
    std::array<std::uint32_t, 3> triangle_{};
    std::size_t corners_ = 0;  ///< of the facet that is being read
    Mesh mesh_;
    Welder welder_{mesh_};
};

Mesh read_binary(const std::string& file, std::string_view bytes, std::uint64_t count,
                 Diagnostics& diagnostics) {
    const std::uint64_t needed = kStartBytes + count * kTriangleBytes;
    if (bytes.size() < needed)
        throw InputError({file, 0, 0, fmt::format("byte {}", kHeadBytes)},
                         fmt::format("states {} triangles, which take {} bytes; the file has {}",
                                     count, needed, bytes.size()));
    if (bytes.size() > needed)
        diagnostics.push_back(
            {{file, 0, 0, fmt::format("byte {}", needed)},
             fmt::format("{} bytes after the last triangle are not used", bytes.size() - needed)});
    Mesh mesh;
    Welder welder(mesh);
    mesh.triangles.reserve(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        const char* corner = bytes.data() + kStartBytes + i * kTriangleBytes + kNormalBytes;
        auto& triangle = mesh.triangles.emplace_back();
        for (std::uint32_t& index : triangle) {
            index = welder.vertex_at({double(little_endian<float>(corner)),
                                      double(little_endian<float>(corner + 4)),
                                      double(little_endian<float>(corner + 8))});
            corner += kNormalBytes;
        }
    }
    return mesh;
}

bool begins_with_solid(std::string_view bytes) {
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && bytes.substr(first).starts_with("solid");
}

}  // namespace

Mesh parse_stl(const std::string& file, std::string_view bytes, Diagnostics& diagnostics) {
    const bool has_count = bytes.size() >= kStartBytes;
    const std::uint64_t count =
        has_count ? little_endian<std::uint32_t>(bytes.data() + kHeadBytes) : 0;
    const bool fits = has_count && bytes.size() == kStartBytes + count * kTriangleBytes;
    if (!fits && begins_with_solid(bytes)) return TextReader(file, bytes).read();
    if (!has_count)
        throw InputError(SourcePlace{file, 0, 0, {}},
                         fmt::format("{} bytes are too few for a binary STL file, and a text one "
                                     "begins with \"solid\"",
                                     bytes.size()));
    return read_binary(file, bytes, count, diagnostics);
}

}  // namespace dewbow
