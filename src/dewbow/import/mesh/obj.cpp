// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/mesh/obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "dewbow/base/parse_number.h"
#include "dewbow/import/mesh/obj_parts.h"
#include "dewbow/import/mesh/words.h"
#include "dewbow/spectrum/display.h"

namespace dewbow {
namespace {

using obj::Corner;
using obj::Faces;
using obj::kNone;
using obj::Pool;

class ObjReader {
public:
    ObjReader(const std::string& file, std::string_view text, ObjDivision division,
              Diagnostics& diagnostics)
        : file_(file), text_(text), division_(division), diagnostics_(diagnostics) {}

    ObjModel read() {
        LineReader lines(text_);
        while (lines.next()) {
            line_ = lines.number();
            words_.clear();
            split_words(lines.line(), words_);
            if (!words_.empty() && words_[0][0] != '#') read_statement();
        }
        if (division_ == ObjDivision::objects_and_materials)
            faces_ = obj::joined_where_they_touch(std::move(faces_), pool_.vertices.size());
        for (const Faces& faces : faces_)
            if (!faces.corners.empty())
                model_.parts.push_back(obj::assemble(faces, pool_, file_, diagnostics_));
        return std::move(model_);
    }

private:
    [[noreturn]] void fail(const std::string& sentence) const {
        throw InputError({file_, line_, 0, {}}, sentence, std::string(line_of(text_, line_)));
    }

    void note(const std::string& text) { diagnostics_.push_back({{file_, line_, 0, {}}, text}); }

    void note_once(const std::string& subject, const std::string& text) {
        if (noted_.insert(subject).second) note(text);
    }

    void read_statement() {
        const std::string_view keyword = words_[0];
        if (keyword == "v") {
            read_vertex();
        } else if (keyword == "vn") {
            pool_.normals.push_back({read_vec3()});
        } else if (keyword == "vt") {
            read_texcoord();
        } else if (keyword == "f") {
            read_face();
        } else if (keyword == "o" || keyword == "g") {
            read_name(keyword == "o", rest_of_line());
        } else if (keyword == "usemtl") {
            material_ = rest_of_line();
            material_line_ = line_;
            current_ = nullptr;
        } else if (keyword == "mtllib") {
            model_.libraries.push_back({rest_of_line(), line_});
        } else if (keyword == "l" || keyword == "p") {
            note_once("lines", "lines and points are not shown");
        } else if (keyword != "s" && keyword != "mg") {
            note_unknown(std::string(keyword.substr(0, 40)));
        }
    }

    /// What follows the first word.
    std::string rest_of_line() const {
        if (words_.size() < 2) return {};
        return {words_[1].data(), words_.back().data() + words_.back().size()};
    }

    void note_unknown(const std::string& keyword) {
        constexpr std::size_t kMostNotes = 10;
        if (!unknown_.insert(keyword).second || unknown_.size() > kMostNotes + 1) return;
        note(unknown_.size() <= kMostNotes ? fmt::format("statements \"{}\" are not used", keyword)
                                           : std::string("more kinds of statements are not used"));
    }

    double read_number(std::size_t word) {
        const auto number = parse_number<double>(words_[word]);
        if (!number) fail(fmt::format("\"{}\" is no number", words_[word].substr(0, 40)));
        return *number;
    }

    Vec3 read_vec3() {
        if (words_.size() < 4) fail(fmt::format("\"{}\" needs three numbers", words_[0]));
        return {read_number(1), read_number(2), read_number(3)};
    }

    /// x y z, a weight that only curves have, or a colour.
    void read_vertex() {
        const Vec3 place = read_vec3();
        const bool has_colour = words_.size() >= 7;
        if (has_colour || !pool_.colours.empty()) {
            pool_.colours.resize(pool_.vertices.size(), {1.0f, 1.0f, 1.0f, 1.0f});
            auto& colour = pool_.colours.emplace_back(std::array{1.0f, 1.0f, 1.0f, 1.0f});
            for (std::size_t c = 0; c < 3 && has_colour; ++c)
                colour[c] = float(srgb_decode(held_in_share(read_number(c + 4))));
        }
        pool_.vertices.push_back({place});
    }

    double held_in_share(double value) {
        if (value >= 0.0 && value <= 1.0) return value;
        note_once("colours", "colours of vertices outside 0 to 1 are held there");
        return value > 1.0 ? 1.0 : 0.0;  // NaN is 0
    }

    /// OBJ's v grows upwards.
    void read_texcoord() {
        if (words_.size() < 2) fail("\"vt\" needs one to three numbers");
        const double u = read_number(1), v = words_.size() > 2 ? read_number(2) : 0.0;
        pool_.texcoords.push_back({float(u), float(1.0 - v)});
    }

    void read_name(bool is_object, std::string name) {
        if (!is_object && has_objects_) return;
        has_objects_ |= is_object;
        name_ = std::move(name);
        current_ = nullptr;
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
        std::array<std::string_view, 3> parts;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t slash = word.find('/');
            parts[i] = word.substr(0, slash);
            word = slash == std::string_view::npos ? std::string_view{} : word.substr(slash + 1);
        }
        Corner corner{read_index(parts[0], pool_.vertices.size(), "vertex"), kNone, kNone};
        if (!parts[1].empty())
            corner.texcoord = read_index(parts[1], pool_.texcoords.size(), "texture coordinate");
        if (!parts[2].empty()) corner.normal = read_index(parts[2], pool_.normals.size(), "normal");
        return corner;
    }

    Faces& faces() {
        if (current_) return *current_;
        const bool whole = division_ == ObjDivision::none;
        const auto key =
            whole ? std::pair<std::string, std::string>() : std::pair(name_, material_);
        const auto [found, is_new] = index_of_.try_emplace(key, faces_.size());
        if (is_new) faces_.push_back({key.first, key.second, material_line_, {}, {}});
        return *(current_ = &faces_[found->second]);
    }

    void read_face() {
        if (words_.size() < 4) fail("a face needs three corners");
        Faces& into = faces();
        const std::size_t first = into.corners.size();
        for (std::size_t i = 1; i < words_.size(); ++i)
            into.corners.push_back(read_corner(words_[i]));
        for (std::size_t i = 2; i + 1 < words_.size(); ++i)
            into.triangles.push_back(
                {std::uint32_t(first), std::uint32_t(first + i - 1), std::uint32_t(first + i)});
    }

    const std::string& file_;
    std::string_view text_;
    ObjDivision division_;
    Diagnostics& diagnostics_;
    std::set<std::string> noted_, unknown_;
    std::size_t line_ = 0, material_line_ = 0;
    std::vector<std::string_view> words_;
    std::string name_, material_;
    bool has_objects_ = false;
    Pool pool_;
    std::map<std::pair<std::string, std::string>, std::size_t> index_of_;
    std::vector<Faces> faces_;
    Faces* current_ = nullptr;
    ObjModel model_;
};

}  // namespace

ObjModel parse_obj(const std::string& file, std::string_view text, ObjDivision division,
                   Diagnostics& diagnostics) {
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
        throw InputError(SourcePlace{file, 0, 0, fmt::format("byte {}", zero)},
                         "this is no text, which OBJ files are");
    }
    return ObjReader(file, text, division, diagnostics).read();
}

}  // namespace dewbow
