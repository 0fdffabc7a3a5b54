// SPDX-License-Identifier: Apache-2.0
#include "dewbow/image/png.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <bit>
#include <csetjmp>
#include <cstring>

#include "dewbow/base/check.h"
#include "dewbow/image/limits.h"
#include "dewbow/image/refuse.h"

// libpng reports an error by longjmp. So that no destructor is jumped over, each function that
// calls setjmp has only trivial locals, and what must be destroyed lives in its caller's PngWriter
// or PngReader.

namespace dewbow {
namespace {

constexpr std::size_t kMaxMessageLength = 200;
/// PNG's limit on keywords. [PNG specification, 3rd edition, §11.3.3.1]
constexpr std::size_t kMaxKeywordLength = 79;
/// Largest chunk other than pixels that is unpacked (a colour profile, a text): 8 MiB.
constexpr png_alloc_size_t kMaxChunkBytes = png_alloc_size_t{8} << 20;
constexpr int kMaxTextChunks = 256;
/// Deflate turns at most 258 bytes into 2 bits. [RFC 1951]
constexpr std::int64_t kMaxDeflateRatio = 1032;

struct PngMessage {
    char text[kMaxMessageLength + 1] = "";
};

void fail(png_structp png, png_const_charp text) {
    auto* message = static_cast<PngMessage*>(png_get_error_ptr(png));
    std::strncpy(message->text, text, kMaxMessageLength);
    png_longjmp(png, 1);
}
void ignore_warning(png_structp, png_const_charp) {}

// ---- writing ---------------------------------------------------------------------------------

struct TextEntry {
    std::string keyword, text;
    bool ascii = true;
};

struct PngWriter {
    PngWriter() = default;
    PngWriter(const PngWriter&) = delete;
    ~PngWriter() { png_destroy_write_struct(&png, &info); }

    PngMessage message;
    png_structp png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, fail, ignore_warning);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    std::string bytes;
    std::vector<png_text> texts;
};

/// A failure to grow becomes an error of libpng: no exception may cross it.
void append(png_structp png, png_bytep data, png_size_t size) {
    auto* bytes = static_cast<std::string*>(png_get_io_ptr(png));
    bool grown = true;
    try {
        bytes->append(reinterpret_cast<const char*>(data), size);
    } catch (...) {
        grown = false;
    }
    if (!grown) png_error(png, "out of memory");
}

bool is_printable_ascii(char c) { return c >= ' ' && c <= '~'; }

bool is_keyword(std::string_view name) {
    return !name.empty() && name.size() <= kMaxKeywordLength &&
           std::all_of(name.begin(), name.end(), is_printable_ascii) && name.front() != ' ' &&
           name.back() != ' ' && name.find("  ") == name.npos;
}

std::string text_from(const Attribute& attribute) {
    return std::visit([](const auto& value) { return fmt::format("{}", value); }, attribute.value);
}

/// PNG text has no control characters but line ends.
std::string without_controls(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < ' ' && c != '\n') c = ' ';
    return text;
}

TextEntry entry_from(const Attribute& attribute) {
    TextEntry entry{attribute.name, text_from(attribute), true};
    if (!is_keyword(attribute.name)) entry = {"Comment", attribute.name + ": " + entry.text, true};
    entry.text = without_controls(std::move(entry.text));
    entry.ascii = std::all_of(entry.text.begin(), entry.text.end(),
                              [](char c) { return static_cast<unsigned char>(c) < 0x80; });
    return entry;
}

/// tEXt is Latin-1, of which ASCII is the part that is UTF-8 too; anything else is iTXt, which is
/// UTF-8.
png_text png_text_from(TextEntry& entry) {
    png_text text{};
    text.compression = entry.ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    text.key = entry.keyword.data();
    text.text = entry.text.data();
    return text;
}

bool write_png(PngWriter& writer, const Image8& image) {
    if (setjmp(png_jmpbuf(writer.png))) return false;
    const png_structp png = writer.png;
    png_set_write_fn(png, &writer.bytes, append, nullptr);
    png_set_user_limits(png, kMaxImageSide, kMaxImageSide);
    png_set_IHDR(png, writer.info, static_cast<png_uint_32>(image.width),
                 static_cast<png_uint_32>(image.height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(png, writer.info, PNG_sRGB_INTENT_RELATIVE);
    png_set_text(png, writer.info, writer.texts.data(), static_cast<int>(writer.texts.size()));
    png_write_info(png, writer.info);
    const std::size_t stride = 3 * static_cast<std::size_t>(image.width);
    for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y)
        png_write_row(png, image.rgb.data() + y * stride);
    png_write_end(png, nullptr);
    return true;
}

// ---- reading ---------------------------------------------------------------------------------

struct PngReader {
    PngReader() = default;
    PngReader(const PngReader&) = delete;
    ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }

    PngMessage message;
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &message, fail, ignore_warning);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    std::string_view rest;
    std::vector<png_bytep> rows;
};

void take(png_structp png, png_bytep to, png_size_t size) {
    auto* rest = static_cast<std::string_view*>(png_get_io_ptr(png));
    if (size > rest->size()) png_error(png, "the file is cut short");
    std::memcpy(to, rest->data(), size);
    rest->remove_prefix(size);
}

bool read_png_header(PngReader& reader) {
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_set_read_fn(reader.png, &reader.rest, take);
    png_set_user_limits(reader.png, kMaxImageSide, kMaxImageSide);
    png_set_chunk_malloc_max(reader.png, kMaxChunkBytes);
    png_set_chunk_cache_max(reader.png, kMaxTextChunks);
    png_read_info(reader.png, reader.info);
    return true;
}

/// Whatever the file holds becomes 8-bit RGB.
bool choose_rgb8(PngReader& reader) {
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_set_expand(reader.png);
    png_set_scale_16(reader.png);
    png_set_strip_alpha(reader.png);
    png_set_gray_to_rgb(reader.png);
    png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    return true;
}

/// Whatever the file holds becomes RGBA of 8 or 16 bits.
bool choose_rgba(PngReader& reader) {
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_set_expand(reader.png);
    png_set_gray_to_rgb(reader.png);
    // For those that have no alpha; of 0xffff an 8-bit picture takes the lower half.
    png_set_add_alpha(reader.png, 0xffff, PNG_FILLER_AFTER);
    if constexpr (std::endian::native == std::endian::little) png_set_swap(reader.png);
    png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    return true;
}

bool read_png_rows(PngReader& reader) {
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_read_image(reader.png, reader.rows.data());
    png_read_end(reader.png, nullptr);
    return true;
}

void check_png_size(const PngReader& reader, int channels, std::size_t file_bytes,
                    const std::string& name) {
    const std::int64_t width = png_get_image_width(reader.png, reader.info);
    const std::int64_t height = png_get_image_height(reader.png, reader.info);
    check_image_size(name, width, height, channels, file_bytes);
    const std::int64_t bits_per_pixel = std::int64_t{png_get_channels(reader.png, reader.info)} *
                                        png_get_bit_depth(reader.png, reader.info);
    if (width * height * bits_per_pixel / 8 >
        kMaxDeflateRatio * static_cast<std::int64_t>(file_bytes))
        refuse_file(name, fmt::format("a PNG file of {} bytes cannot hold {} x {} pixels",
                                      file_bytes, width, height));
}

[[noreturn]] void refuse(const PngReader& reader, const std::string& name) {
    refuse_file(name, std::string("this PNG file cannot be read: ") + reader.message.text);
}

/// Reads up to the first row, with those conversions chosen.
void open_png(PngReader& reader, std::string_view bytes, bool (*choose)(PngReader&), int channels,
              const std::string& name) {
    if (!is_png(bytes)) refuse_file(name, "this is not a PNG file");
    reader.rest = bytes;
    if (!reader.info || !read_png_header(reader)) refuse(reader, name);
    check_png_size(reader, channels, bytes.size(), name);
    if (!choose(reader)) refuse(reader, name);
}

/// All rows into `pixels`, `stride` bytes apart.
void read_png_pixels(PngReader& reader, png_bytep pixels, std::size_t stride,
                     const std::string& name) {
    DEWBOW_CHECK(png_get_rowbytes(reader.png, reader.info) == stride,
                 "the conversions leave pixels of the size that was asked for");
    const std::size_t height = png_get_image_height(reader.png, reader.info);
    for (std::size_t y = 0; y < height; ++y) reader.rows.push_back(pixels + y * stride);
    if (!read_png_rows(reader)) refuse(reader, name);
}

}  // namespace

std::string encode_png(const Image8& image, const Attributes& attributes) {
    DEWBOW_CHECK(image.width > 0 && image.height > 0, "a picture has at least one pixel");
    DEWBOW_CHECK(image.rgb.size() == 3 * static_cast<std::size_t>(image.width) *
                                         static_cast<std::size_t>(image.height),
                 "an 8-bit picture has three bytes a pixel");
    std::vector<TextEntry> entries;
    entries.reserve(attributes.size());
    PngWriter writer;
    for (const Attribute& attribute : attributes) {
        entries.push_back(entry_from(attribute));
        writer.texts.push_back(png_text_from(entries.back()));
    }
    if (!writer.info) throw InputError("the picture cannot be written as PNG: out of memory");
    if (!write_png(writer, image))
        throw InputError(std::string("the picture cannot be written as PNG: ") +
                         writer.message.text);
    return std::move(writer.bytes);
}

Image8 decode_png(std::string_view bytes, const std::string& name) {
    PngReader reader;
    open_png(reader, bytes, choose_rgb8, 3, name);
    Image8 image;
    image.width = static_cast<int>(png_get_image_width(reader.png, reader.info));
    image.height = static_cast<int>(png_get_image_height(reader.png, reader.info));
    const std::size_t stride = 3 * static_cast<std::size_t>(image.width);
    image.rgb.resize(stride * static_cast<std::size_t>(image.height));
    read_png_pixels(reader, image.rgb.data(), stride, name);
    return image;
}

ImageRgba decode_png_rgba(std::string_view bytes, const std::string& name) {
    PngReader reader;
    open_png(reader, bytes, choose_rgba, 4, name);
    ImageRgba image;
    image.width = static_cast<int>(png_get_image_width(reader.png, reader.info));
    image.height = static_cast<int>(png_get_image_height(reader.png, reader.info));
    image.bits = png_get_bit_depth(reader.png, reader.info);
    const std::size_t row = 4 * static_cast<std::size_t>(image.width);
    const std::size_t values = row * static_cast<std::size_t>(image.height);
    if (image.bits == 16) {
        image.values16.resize(values);
        read_png_pixels(reader, reinterpret_cast<png_bytep>(image.values16.data()), 2 * row, name);
    } else {
        image.values8.resize(values);
        read_png_pixels(reader, image.values8.data(), row, name);
    }
    return image;
}

bool is_png(std::string_view bytes) {
    constexpr std::size_t kSignatureLength = 8;
    return bytes.size() >= kSignatureLength &&
           png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, kSignatureLength) == 0;
}

}  // namespace dewbow
