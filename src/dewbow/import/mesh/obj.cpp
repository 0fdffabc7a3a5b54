// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/mesh/obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <set>

#include "dewbow/base/parse_number.h"
#include "dewbow/import/mesh/clean.h"
#include "dewbow/import/mesh/words.h"

namespace dewbow {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// A corner of a face as the file gives it: where its vertex and its normal stand.
struct Corner {
    std::uint32_t vertex = 0, normal = kNone;
};

class ObjReader {
public:
    ObjReader(const std::string& file, std::string_view text, Diagnostics& diagnostics)
        : file_(file), text_(text), diagnostics_(diagnostics) {}

    Mesh read() {
        LineReader lines(text_);
        while (lines.next()) {
            line_ = lines.number();
            words_.clear();
            split_words(lines.line(), words_);
            if (!words_.empty() && words_[0][0] != '#') read_statement();
        }
        return assemble();
    }

private:
    [[noreturn]] void fail(const std::string& sentence) const {
        throw InputError({file_, line_, 0, {}}, sentence, std::string(line_of(text_, line_)));
    }

    void note_once(const std::string& subject, const std::string& text) {
        if (noted_.insert(subject).second) diagnostics_.push_back({{file_, line_, 0, {}}, text});
    }

    void read_statement() {
        const std::string_view keyword = words_[0];
        if (keyword == "v") {
            vertices_.push_back({read_vec3()});
        } else if (keyword == "vn") {
            normals_.push_back({read_vec3()});
        } else if (keyword == "f") {
            read_face();
        } else if (keyword == "usemtl" || keyword == "mtllib") {
            note_once("materials", "materials of the file (mtllib, usemtl) are not used");
        } else if (keyword == "l" || keyword == "p") {
            note_once("lines", "lines and points are not shown");
        } else if (!std::binary_search(std::begin(kPassedOver), std::end(kPassedOver), keyword)) {
            note_once("unknown", fmt::format("statements \"{}\" are not used", keyword));
        }
    }

    Vec3 read_vec3() {
        if (words_.size() < 4) fail(fmt::format("\"{}\" needs three numbers", words_[0]));
        std::array<double, 3> v;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto number = parse_number<double>(words_[i + 1]);
            if (!number) fail(fmt::format("\"{}\" is no number", words_[i + 1]));
            v[i] = *number;
        }
        return {v[0], v[1], v[2]};
    }

    /// "7" is the seventh of `count`, "-1" the last.
    std::uint32_t read_index(std::string_view word, std::size_t count, const char* what) {
        const auto number = parse_number<std::int64_t>(word);
        if (!number || *number == 0) fail(fmt::format("\"{}\" is no index of a {}", word, what));
        const std::int64_t size = std::int64_t(count);
        if (*number > size || *number < -size) {
            fail(fmt::format("there is no {} {}: {} stand above", what, *number, count));
        }
        return std::uint32_t(*number > 0 ? *number - 1 : size + *number);
    }

    /// v, v/vt, v//vn or v/vt/vn.
    Corner read_corner(std::string_view word) {
        const std::size_t first = word.find('/');
        Corner corner{read_index(word.substr(0, first), vertices_.size(), "vertex"), kNone};
        if (first == std::string_view::npos) return corner;
        const std::size_t second = word.find('/', first + 1);
        if (second == std::string_view::npos || second + 1 == word.size()) return corner;
        corner.normal = read_index(word.substr(second + 1), normals_.size(), "normal");
        return corner;
    }

    void read_face() {
        if (words_.size() < 4) fail("a face needs three corners");
        const std::size_t first = corners_.size();
        for (std::size_t i = 1; i < words_.size(); ++i) corners_.push_back(read_corner(words_[i]));
        polygon_.clear();
        if (corners_.size() > kNone) fail("there are too many corners");
        for (std::size_t i = first; i < corners_.size(); ++i) polygon_.push_back(std::uint32_t(i));
        add_polygon(mesh_, polygon_);
    }

    Mesh assemble();
    bool keep_normals();

    static constexpr std::string_view kPassedOver[] = {"g", "mg", "o", "s", "vt"};

    const std::string& file_;
    std::string_view text_;
    Diagnostics& diagnostics_;
    std::set<std::string> noted_;
    std::size_t line_ = 0;
    std::vector<std::string_view> words_;
    std::vector<Point<Object>> vertices_;
    std::vector<Normal<Object>> normals_;
    std::vector<Corner> corners_;
    std::vector<std::uint32_t> polygon_;
    Mesh mesh_;  ///< until assemble(), its triangles count corners
};

bool ObjReader::keep_normals() {
    const auto with = std::count_if(corners_.begin(), corners_.end(),
                                    [](const Corner& corner) { return corner.normal != kNone; });
    if (with > 0 && std::size_t(with) < corners_.size()) {
        diagnostics_.push_back(
            {{file_, 0, 0, {}}, "only some corners have normals: none are used, facets are flat"});
    }
    return with > 0 && std::size_t(with) == corners_.size();
}

Mesh ObjReader::assemble() {
    const bool with_normals = keep_normals();
    // Corners that share vertex and normal share a vertex of the mesh, numbered in the order of
    // first use.
    std::unordered_map<std::uint64_t, std::uint32_t> index_of;
    for (auto& triangle : mesh_.triangles) {
        for (std::uint32_t& index : triangle) {
            const Corner corner = corners_[index];
            const std::uint32_t normal = with_normals ? corner.normal : 0;
            const auto [found, is_new] =
                index_of.try_emplace((std::uint64_t{corner.vertex} << 32) | normal,
                                     std::uint32_t(mesh_.vertices.size()));
            index = found->second;
            if (!is_new) continue;
            mesh_.vertices.push_back(vertices_[corner.vertex]);
            if (with_normals) mesh_.normals.push_back(normals_[corner.normal]);
        }
    }
    return std::move(mesh_);
}

}  // namespace

Mesh parse_obj(const std::string& file, std::string_view text, Diagnostics& diagnostics) {
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
        throw InputError(SourcePlace{file, 0, 0, fmt::format("byte {}", zero)},
                         "this is no text, which OBJ files are");
    }
    return ObjReader(file, text, diagnostics).read();
}

}  // namespace dewbow
