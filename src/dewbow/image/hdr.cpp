// SPDX-License-Identifier: Apache-2.0
#include "dewbow/image/hdr.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "dewbow/base/parse_number.h"
#include "dewbow/image/limits.h"
#include "dewbow/image/refuse.h"

namespace dewbow {
namespace {

/// Component m of exponent byte e is m * 2^(e - 136): a bias of 128 and 8 bits of fraction.
constexpr int kExponentBias = 136;
/// Lines of other widths are never in the newer run-length form. [Radiance, color.c]
constexpr std::size_t kMinRunWidth = 8, kMaxRunWidth = 0x7fff;
constexpr std::size_t kMaxHeaderLine = 4096;

using Rgbe = std::array<std::uint8_t, 4>;

class HdrReader {
public:
    HdrReader(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}

    std::uint8_t take_byte() {
        if (rest_.empty()) refuse("it is cut short");
        const auto byte = static_cast<std::uint8_t>(rest_.front());
        rest_.remove_prefix(1);
        return byte;
    }
    Rgbe take_pixel() {
        Rgbe pixel;
        for (std::uint8_t& byte : pixel) byte = take_byte();
        return pixel;
    }
    std::string_view take_line() {
        const std::size_t end = rest_.substr(0, kMaxHeaderLine).find('\n');
        if (end == rest_.npos) refuse("its header does not end");
        std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(end + 1);
        if (line.ends_with('\r')) line.remove_suffix(1);
        return line;
    }
    /// No pixel looks like this: its largest component would be below 128.
    bool next_is_run_marker() const {
        return rest_.size() >= 3 && rest_[0] == 2 && rest_[1] == 2 &&
               static_cast<std::uint8_t>(rest_[2]) < 128;
    }
    [[noreturn]] void refuse(const std::string& why) const {
        refuse_file(name_, "this Radiance HDR file cannot be read: " + why);
    }

private:
    std::string_view rest_;
    const std::string& name_;
};

// ---- header ----------------------------------------------------------------------------------

/// What every value is divided by, for R, G, B.
using Exposure = std::array<double, 3>;

std::string_view next_word(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    const std::string_view word = text.substr(0, text.find_first_of(" \t"));
    text.remove_prefix(word.size());
    return word;
}

double take_factor(const HdrReader& reader, std::string_view& text) {
    const std::optional<double> factor = parse_number<double>(next_word(text));
    if (!factor || !std::isfinite(*factor) || *factor <= 0.0)
        reader.refuse("an exposure in its header is not a positive number");
    return *factor;
}

void read_header_line(const HdrReader& reader, std::string_view line, Exposure& exposure) {
    const auto value_of = [&](std::string_view key) -> std::optional<std::string_view> {
        if (!line.starts_with(key)) return std::nullopt;
        return line.substr(key.size());
    };
    if (auto format = value_of("FORMAT=")) {
        const std::string_view word = next_word(*format);
        if (word != "32-bit_rle_rgbe")
            reader.refuse(fmt::format("its format is \"{}\", not \"32-bit_rle_rgbe\"", word));
    } else if (auto one = value_of("EXPOSURE=")) {
        const double factor = take_factor(reader, *one);
        for (double& channel : exposure) channel *= factor;
    } else if (auto three = value_of("COLORCORR=")) {
        for (double& channel : exposure) channel *= take_factor(reader, *three);
    }
}

Exposure read_header(HdrReader& reader) {
    Exposure exposure{1.0, 1.0, 1.0};
    for (std::string_view line = reader.take_line(); !line.empty(); line = reader.take_line())
        read_header_line(reader, line, exposure);
    return exposure;
}

struct Size {
    int width, height;
};

Size read_size(HdrReader& reader) {
    const std::string_view line = reader.take_line();
    std::string_view rest = line;
    const bool minus_y = next_word(rest) == "-Y";
    const std::optional<int> height = parse_number<int>(next_word(rest));
    const bool plus_x = next_word(rest) == "+X";
    const std::optional<int> width = parse_number<int>(next_word(rest));
    if (!minus_y || !plus_x || !width || !height)
        reader.refuse(fmt::format("its size is \"{}\", not of the form \"-Y 512 +X 1024\"", line));
    return {*width, *height};
}

// ---- pixels ----------------------------------------------------------------------------------

/// One component of a line: runs (128 + count, value) and literals (count, values…).
void read_component_runs(HdrReader& reader, std::vector<Rgbe>& line, std::size_t component) {
    std::size_t x = 0;
    while (x < line.size()) {
        const std::uint8_t code = reader.take_byte();
        const bool run = code > 128;
        const std::size_t count = run ? code - 128u : code;
        if (count == 0 || count > line.size() - x) reader.refuse("a run leaves its line");
        const std::uint8_t repeated = run ? reader.take_byte() : std::uint8_t{0};
        for (const std::size_t end = x + count; x < end; ++x)
            line[x][component] = run ? repeated : reader.take_byte();
    }
}

/// Pixels one by one; (1, 1, 1, n) repeats the last one n times, and again n * 256 times if it
/// follows itself, and so on.
void read_line_of_pixels(HdrReader& reader, std::vector<Rgbe>& line) {
    constexpr int kMaxShift = 24;
    int shift = 0;
    for (std::size_t x = 0; x < line.size();) {
        const Rgbe pixel = reader.take_pixel();
        if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
            line[x++] = pixel;
            shift = 0;
            continue;
        }
        const std::size_t count = shift > kMaxShift ? 0 : std::size_t{pixel[3]} << shift;
        if (x == 0 || count > line.size() - x) reader.refuse("a run leaves its line");
        if (shift > kMaxShift) reader.refuse("a run is too long");
        std::fill_n(line.begin() + static_cast<std::ptrdiff_t>(x), count, line[x - 1]);
        x += count;
        shift += 8;
    }
}

/// The newer form begins each line with (2, 2, width), width below 2^15.
void read_line(HdrReader& reader, std::vector<Rgbe>& line) {
    const std::size_t width = line.size();
    if (width < kMinRunWidth || width > kMaxRunWidth || !reader.next_is_run_marker())
        return read_line_of_pixels(reader, line);
    const Rgbe marker = reader.take_pixel();
    if (marker[2] * 256u + marker[3] != width) reader.refuse("a line has another width");
    for (std::size_t component = 0; component < 4; ++component)
        read_component_runs(reader, line, component);
}

void store_line(const std::vector<Rgbe>& line, std::size_t y, const Exposure& exposure,
                Image& image) {
    for (std::size_t x = 0; x < line.size(); ++x)
        for (std::size_t c = 0; c < 3; ++c) {
            const double mantissa = line[x][3] == 0 ? 0.0 : line[x][c];
            const double value = std::ldexp(mantissa, line[x][3] - kExponentBias) / exposure[c];
            image.channels[c].values[y * line.size() + x] = static_cast<float>(value);
        }
}

}  // namespace

Image decode_hdr(std::string_view bytes, const std::string& name) {
    if (!bytes.starts_with("#?")) refuse_file(name, "this is not a Radiance HDR file");
    HdrReader reader(bytes, name);
    const Exposure exposure = read_header(reader);
    const Size size = read_size(reader);
    check_image_size(name, size.width, size.height, 3, bytes.size());

    Image image{size.width, size.height, {{"R", {}}, {"G", {}}, {"B", {}}}};
    const auto width = static_cast<std::size_t>(size.width);
    const auto height = static_cast<std::size_t>(size.height);
    for (Channel& channel : image.channels) channel.values.resize(width * height);
    std::vector<Rgbe> line(width);
    for (std::size_t y = 0; y < height; ++y) {
        read_line(reader, line);
        store_line(line, y, exposure, image);
    }
    return image;
}

}  // namespace dewbow
