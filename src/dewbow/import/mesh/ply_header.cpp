// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/mesh/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "dewbow/base/error.h"
#include "dewbow/base/parse_number.h"
#include "dewbow/import/mesh/words.h"

namespace dewbow::ply {
namespace {

constexpr std::pair<std::string_view, Scalar> kScalarNames[] = {
    {"char", Scalar::int8},       {"int8", Scalar::int8},       {"uchar", Scalar::uint8},
    {"uint8", Scalar::uint8},     {"short", Scalar::int16},     {"int16", Scalar::int16},
    {"ushort", Scalar::uint16},   {"uint16", Scalar::uint16},   {"int", Scalar::int32},
    {"int32", Scalar::int32},     {"uint", Scalar::uint32},     {"uint32", Scalar::uint32},
    {"float", Scalar::float32},   {"float32", Scalar::float32}, {"double", Scalar::float64},
    {"float64", Scalar::float64},
};
constexpr std::pair<std::string_view, Format> kFormatNames[] = {
    {"ascii", Format::ascii},
    {"binary_little_endian", Format::little_endian},
    {"binary_big_endian", Format::big_endian},
};
/// A header is a few lines; more is an attack on whoever reads it.
constexpr std::size_t kMaxHeaderLines = 10'000;

class HeaderReader {
public:
    HeaderReader(const std::string& file, std::string_view bytes) : file_(file), bytes_(bytes) {}

    Header read() {
        if (!next_line() || words_.empty() || words_[0] != "ply")
            fail("the file does not begin with \"ply\"");
        bool has_format = false;
        while (next_line()) {
            if (words_.empty() || words_[0] == "comment" || words_[0] == "obj_info") continue;
            if (words_[0] == "end_header") {
                if (!has_format) fail("the header states no format");
                header_.body_offset = position_;
                header_.body_line = line_ + 1;
                return std::move(header_);
            }
            has_format = read_line() || has_format;
        }
        fail("the header has no end_header");
    }

private:
    [[noreturn]] void fail(const std::string& sentence, const std::string& hint = {}) const {
        throw InputError({file_, line_, 0, {}}, sentence, std::string(line_of(bytes_, line_)),
                         hint);
    }

    bool next_line() {
        if (position_ >= bytes_.size() || line_ >= kMaxHeaderLines) return false;
        const std::size_t end = std::min(bytes_.find('\n', position_), bytes_.size());
        std::string_view line = bytes_.substr(position_, end - position_);
        if (line.ends_with('\r')) line.remove_suffix(1);
        position_ = std::min(end + 1, bytes_.size());
        ++line_;
        words_.clear();
        split_words(line, words_);
        return true;
    }

    /// True if it was the format.
    bool read_line() {
        if (words_[0] == "format") {
            read_format();
            return true;
        }
        if (words_[0] == "element") {
            read_element();
        } else if (words_[0] == "property") {
            read_property();
        } else {
            fail(fmt::format("unknown word \"{}\" in the header", words_[0]),
                 "expected format, comment, element, property, end_header");
        }
        return false;
    }

    void read_format() {
        for (const auto& [name, format] : kFormatNames) {
            if (words_.size() != 3 || words_[1] != name || words_[2] != "1.0") continue;
            header_.format = format;
            return;
        }
        fail("unknown format",
             "expected ascii 1.0, binary_little_endian 1.0 or binary_big_endian 1.0");
    }

    void read_element() {
        const auto count =
            words_.size() == 3 ? parse_number<std::uint64_t>(words_[2]) : std::nullopt;
        if (!count) fail("expected: element NAME COUNT");
        header_.elements.push_back({std::string(words_[1]), *count, {}});
    }

    Scalar read_scalar(std::string_view word) const {
        for (const auto& [name, scalar] : kScalarNames) {
            if (name == word) return scalar;
        }
        fail(fmt::format("unknown type \"{}\"", word));
    }

    void read_property() {
        if (header_.elements.empty()) fail("a property needs an element above it");
        Property property;
        if (words_.size() == 5 && words_[1] == "list") {
            property.list_count = read_scalar(words_[2]);
            if (*property.list_count >= Scalar::float32) fail("a list's length is a whole number");
            property.type = read_scalar(words_[3]);
            property.name = words_[4];
        } else if (words_.size() == 3) {
            property.type = read_scalar(words_[1]);
            property.name = words_[2];
        } else {
            fail("expected: property TYPE NAME or property list TYPE TYPE NAME");
        }
        header_.elements.back().properties.push_back(std::move(property));
    }

    const std::string& file_;
    std::string_view bytes_;
    std::size_t position_ = 0, line_ = 0;
    std::vector<std::string_view> words_;
    Header header_;
};

}  // namespace

std::size_t size_of(Scalar scalar) {
    constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return kSizes[std::size_t(scalar)];
}

std::optional<std::size_t> Element::find(std::string_view property) const {
    for (std::size_t i = 0; i < properties.size(); ++i) {
        if (properties[i].name == property) return i;
    }
    return std::nullopt;
}

Header parse_header(const std::string& file, std::string_view bytes) {
    return HeaderReader(file, bytes).read();
}

}  // namespace dewbow::ply
