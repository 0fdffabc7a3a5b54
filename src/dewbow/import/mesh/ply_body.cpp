// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/mesh/ply_body.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "dewbow/base/parse_number.h"

namespace dewbow::ply {
namespace {

class AsciiBody : public Body {
public:
    AsciiBody(const std::string& file, std::string_view bytes, const Header& header)
        : file_(file), bytes_(bytes), position_(header.body_offset), line_(header.body_line) {}

    double number(Scalar) override {
        skip_space();
        const std::size_t end = std::min(bytes_.find_first_of(" \t\r\n", position_), bytes_.size());
        const std::string_view word = bytes_.substr(position_, end - position_);
        if (word.empty())
            throw InputError(place(), "the file ends before all its elements are there");
        const auto value = parse_number<double>(word);
        if (!value) {
            throw InputError(place(), fmt::format("\"{}\" is no number", word.substr(0, 40)),
                             std::string(line_of(bytes_, line_)));
        }
        position_ = end;
        return *value;
    }
    SourcePlace place() const override { return {file_, line_, 0, {}}; }
    std::uint64_t left() const override { return bytes_.size() - position_; }
    std::size_t least_bytes(Scalar) const override { return 1; }

private:
    void skip_space() {
        for (; position_ < bytes_.size(); ++position_) {
            const char c = bytes_[position_];
            if (c == '\n') ++line_;
            if (c != ' ' && c != '\t' && c != '\r' && c != '\n') return;
        }
    }

    std::string file_;
    std::string_view bytes_;
    std::size_t position_, line_;
};

class BinaryBody : public Body {
public:
    BinaryBody(const std::string& file, std::string_view bytes, const Header& header)
        : file_(file), bytes_(bytes), position_(header.body_offset) {
        const bool file_is_little = header.format == Format::little_endian;
        swap_ = file_is_little != (std::endian::native == std::endian::little);
    }

    double number(Scalar type) override {
        switch (type) {
            case Scalar::int8:
                return take<std::int8_t>();
            case Scalar::uint8:
                return take<std::uint8_t>();
            case Scalar::int16:
                return take<std::int16_t>();
            case Scalar::uint16:
                return take<std::uint16_t>();
            case Scalar::int32:
                return take<std::int32_t>();
            case Scalar::uint32:
                return take<std::uint32_t>();
            case Scalar::float32:
                return double(take<float>());
            case Scalar::float64:
                return take<double>();
        }
        return 0.0;
    }
    SourcePlace place() const override { return {file_, 0, 0, fmt::format("byte {}", position_)}; }
    std::uint64_t left() const override { return bytes_.size() - position_; }
    std::size_t least_bytes(Scalar type) const override { return size_of(type); }

private:
    template <class T>
    T take() {
        if (left() < sizeof(T)) {
            throw InputError(place(), "the file ends before all its elements are there");
        }
        char raw[sizeof(T)];
        std::memcpy(raw, bytes_.data() + position_, sizeof(T));
        if (swap_) std::reverse(std::begin(raw), std::end(raw));
        position_ += sizeof(T);
        T value;
        std::memcpy(&value, raw, sizeof(T));
        return value;
    }

    std::string file_;
    std::string_view bytes_;
    std::size_t position_;
    bool swap_ = false;
};

}  // namespace

std::unique_ptr<Body> make_body(const std::string& file, std::string_view bytes,
                                const Header& header) {
    if (header.format == Format::ascii) return std::make_unique<AsciiBody>(file, bytes, header);
    return std::make_unique<BinaryBody>(file, bytes, header);
}

}  // namespace dewbow::ply
