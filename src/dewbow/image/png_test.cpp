// SPDX-License-Identifier: Apache-2.0
#include "dewbow/image/png.h"

#include <gtest/gtest.h>
#include <png.h>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

using Bytes = std::vector<std::uint8_t>;

Image8 picture(int width, int height) {
    Image8 image{width, height, {}};
    for (int i = 0; i < 3 * width * height; ++i)
        image.rgb.push_back(static_cast<std::uint8_t>(i * 7));
    return image;
}

/// What another program writes: any colour type and depth, rows as PNG packs them.
struct ForeignPng {
    int width, height, depth, colour_type;
    Bytes row;  ///< every row is this one
    bool interlaced = false;
    std::vector<png_color> palette = {};
    Bytes palette_alpha = {};
};

void append(png_structp png, png_bytep data, png_size_t size) {
    static_cast<std::string*>(png_get_io_ptr(png))
        ->append(reinterpret_cast<const char*>(data), size);
}

std::string encode(ForeignPng foreign) {
    std::string bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &bytes, append, nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(foreign.width),
                 static_cast<png_uint_32>(foreign.height), foreign.depth, foreign.colour_type,
                 foreign.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (!foreign.palette.empty())
        png_set_PLTE(png, info, foreign.palette.data(), static_cast<int>(foreign.palette.size()));
    if (!foreign.palette_alpha.empty())
        png_set_tRNS(png, info, foreign.palette_alpha.data(),
                     static_cast<int>(foreign.palette_alpha.size()), nullptr);
    png_write_info(png, info);
    std::vector<png_bytep> rows(static_cast<std::size_t>(foreign.height), foreign.row.data());
    png_write_image(png, rows.data());
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

Bytes first_row(const std::string& bytes) {
    const Image8 image = decode_png(bytes, "wood.png");
    return Bytes(image.rgb.begin(), image.rgb.begin() + 3 * image.width);
}

std::string refusal(std::string_view bytes) {
    try {
        decode_png(bytes, "wood.png");
    } catch (const InputError& error) {
        EXPECT_EQ(error.place().file, "wood.png");
        return error.sentence();
    }
    return "it was read";
}
bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != text.npos;
}

// ---- round trips -----------------------------------------------------------------------------

TEST(Png, PixelsComeBack) {
    for (const auto& [width, height] : {std::pair{1, 1}, {37, 23}, {300, 2}}) {
        const Image8 image = picture(width, height);
        const Image8 decoded = decode_png(encode_png(image, {}), "wood.png");
        EXPECT_EQ(decoded.width, width);
        EXPECT_EQ(decoded.height, height);
        EXPECT_EQ(decoded.rgb, image.rgb);
    }
}

TEST(Png, TheFileSaysThatItIsSrgb) { EXPECT_TRUE(contains(encode_png(picture(1, 1), {}), "sRGB")); }

TEST(Png, AttributesBecomeText) {
    const std::string bytes =
        encode_png(picture(1, 1), {{"dewbow:seed", std::int64_t{-7}}, {"dewbow:exposure", 0.1}});
    EXPECT_TRUE(contains(bytes, std::string_view("\0\0\0\x0etEXtdewbow:seed\0-7", 22)));
    EXPECT_TRUE(contains(bytes, std::string_view("tEXtdewbow:exposure\0"
                                                 "0.1",
                                                 23)));
}

TEST(Png, TextBeyondAsciiIsUtf8) {
    const std::string bytes = encode_png(picture(1, 1), {{"Title", "Regenbogen über 虹"}});
    EXPECT_FALSE(contains(bytes, "tEXt"));
    // keyword, not compressed, method 0, no language, no translated keyword
    EXPECT_TRUE(
        contains(bytes, std::string("iTXtTitle") + std::string(5, '\0') + "Regenbogen über 虹"));
}

TEST(Png, NamesThatAreNoKeywordsGoIntoAComment) {
    const std::string long_name(80, 'n');
    for (const std::string& name : {long_name, std::string("größe"), std::string(" x")}) {
        const std::string bytes = encode_png(picture(1, 1), {{name, std::int64_t{3}}});
        EXPECT_TRUE(contains(bytes, "tEXtComment") || contains(bytes, "iTXtComment")) << name;
        EXPECT_TRUE(contains(bytes, name + ": 3")) << name;
    }
}

// ---- files of other programs -----------------------------------------------------------------

TEST(Png, GreyBecomesRgb) {
    EXPECT_EQ(first_row(encode({2, 1, 8, PNG_COLOR_TYPE_GRAY, {9, 200}})),
              (Bytes{9, 9, 9, 200, 200, 200}));
    EXPECT_EQ(first_row(encode({3, 2, 1, PNG_COLOR_TYPE_GRAY, {0b10100000}})),
              (Bytes{255, 255, 255, 0, 0, 0, 255, 255, 255}));
}

TEST(Png, PalettesBecomeRgbAndTheirAlphaIsDropped) {
    const ForeignPng foreign{3,
                             1,
                             2,
                             PNG_COLOR_TYPE_PALETTE,
                             {0b10000100},
                             false,
                             {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}},
                             {0, 128, 255}};
    EXPECT_EQ(first_row(encode(foreign)), (Bytes{7, 8, 9, 1, 2, 3, 4, 5, 6}));
}

TEST(Png, AlphaIsDroppedAndColoursStay) {
    EXPECT_EQ(first_row(encode({2, 3, 8, PNG_COLOR_TYPE_RGB_ALPHA, {1, 2, 3, 0, 4, 5, 6, 255}})),
              (Bytes{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(first_row(encode({1, 1, 8, PNG_COLOR_TYPE_GRAY_ALPHA, {77, 0}})),
              (Bytes{77, 77, 77}));
}

/// v / 257 to nearest: 0x00ff becomes 1, where cutting bits off would give 0.
TEST(Png, SixteenBitsAreRounded) {
    EXPECT_EQ(
        first_row(encode({1, 1, 16, PNG_COLOR_TYPE_RGB, {0x00, 0xff, 0x80, 0x80, 0xff, 0x00}})),
        (Bytes{1, 128, 254}));
}

TEST(Png, InterlacedFilesAreRead) {
    const Bytes row{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    const Image8 image = decode_png(encode({5, 9, 8, PNG_COLOR_TYPE_RGB, row, true}), "wood.png");
    for (std::size_t y = 0; y < 9; ++y)
        EXPECT_TRUE(std::equal(row.begin(), row.end(), image.rgb.begin() + 15 * std::ptrdiff_t(y)));
}

// ---- with alpha ------------------------------------------------------------------------------

Bytes rgba_row(const ForeignPng& foreign) {
    const ImageRgba image = decode_png_rgba(encode(foreign), "wood.png");
    EXPECT_EQ(image.bits, 8);
    return Bytes(image.values8.begin(), image.values8.begin() + 4 * image.width);
}

TEST(PngRgba, AlphaIsTheFilesOrWhole) {
    EXPECT_EQ(rgba_row({2, 3, 8, PNG_COLOR_TYPE_RGB_ALPHA, {1, 2, 3, 0, 4, 5, 6, 255}}),
              (Bytes{1, 2, 3, 0, 4, 5, 6, 255}));
    EXPECT_EQ(rgba_row({1, 1, 8, PNG_COLOR_TYPE_GRAY_ALPHA, {77, 5}}), (Bytes{77, 77, 77, 5}));
    EXPECT_EQ(rgba_row({1, 1, 8, PNG_COLOR_TYPE_RGB, {1, 2, 3}}), (Bytes{1, 2, 3, 255}));
    EXPECT_EQ(rgba_row({3, 2, 1, PNG_COLOR_TYPE_GRAY, {0b10100000}}),
              (Bytes{255, 255, 255, 255, 0, 0, 0, 255, 255, 255, 255, 255}));
}

TEST(PngRgba, PalettesKeepTheirAlpha) {
    const std::vector<png_color> palette{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
    const Bytes row{0b10000100};
    EXPECT_EQ(rgba_row({3, 1, 2, PNG_COLOR_TYPE_PALETTE, row, false, palette, {0, 128, 255}}),
              (Bytes{7, 8, 9, 255, 1, 2, 3, 0, 4, 5, 6, 128}));
    EXPECT_EQ(rgba_row({3, 1, 2, PNG_COLOR_TYPE_PALETTE, row, false, palette, {}}),
              (Bytes{7, 8, 9, 255, 1, 2, 3, 255, 4, 5, 6, 255}));
}

TEST(PngRgba, SixteenBitsStay) {
    const Bytes row{0x01, 0x02, 0x80, 0x00, 0xff, 0xfe, 0x12, 0x34};
    const ImageRgba image =
        decode_png_rgba(encode({1, 2, 16, PNG_COLOR_TYPE_RGB_ALPHA, row, true}), "wood.png");
    EXPECT_EQ(image.bits, 16);
    EXPECT_EQ(image.values16, (std::vector<std::uint16_t>{0x0102, 0x8000, 0xfffe, 0x1234, 0x0102,
                                                          0x8000, 0xfffe, 0x1234}));
    const ImageRgba grey =
        decode_png_rgba(encode({1, 1, 16, PNG_COLOR_TYPE_GRAY, {0x01, 0x02}}), "wood.png");
    EXPECT_EQ(grey.values16, (std::vector<std::uint16_t>{0x0102, 0x0102, 0x0102, 0xffff}));
}

// ---- hostile files ---------------------------------------------------------------------------

/// `bytes` with another size in its header, whose checksum is made right.
std::string with_size(std::string bytes, std::uint32_t width, std::uint32_t height) {
    const auto put = [&](std::size_t at, std::uint32_t value) {
        for (int i = 0; i < 4; ++i) bytes[at + i] = static_cast<char>(value >> (24 - 8 * i));
    };
    put(16, width);
    put(20, height);
    std::uint32_t checksum = ~0u;  // CRC-32 of "IHDR" and its 13 bytes
    for (std::size_t i = 12; i < 29; ++i) {
        checksum ^= static_cast<std::uint8_t>(bytes[i]);
        for (int bit = 0; bit < 8; ++bit)
            checksum = (checksum >> 1) ^ (checksum & 1 ? 0xedb88320u : 0u);
    }
    put(29, ~checksum);
    return bytes;
}

TEST(Png, ClaimedSizesAreCheckedBeforeMemoryIsTaken) {
    const std::string bytes = encode_png(picture(4, 4), {});
    EXPECT_EQ(refusal(with_size(bytes, 4, 4)), "it was read");
    EXPECT_TRUE(contains(refusal(with_size(bytes, 70000, 1)), "cannot be read"));
    EXPECT_TRUE(contains(refusal(with_size(bytes, 60000, 60000)), "pixels are the most"));
    EXPECT_TRUE(contains(refusal(with_size(bytes, 8000, 8000)), "cannot hold that"));
    EXPECT_TRUE(contains(refusal(with_size(bytes, 1000, 1000)), "cannot hold 1000 x 1000"));
}

TEST(Png, AnotherFormatIsRefused) {
    EXPECT_TRUE(contains(refusal(""), "not a PNG file"));
    EXPECT_TRUE(contains(refusal("\xff\xd8\xff\xe0        "), "not a PNG file"));
}

TEST(Png, DamageIsNamed) {
    std::string bytes = encode_png(picture(30, 30), {});
    bytes[bytes.find("IDAT") + 40] ^= 1;
    EXPECT_TRUE(contains(refusal(bytes), "this PNG file cannot be read: "));
    EXPECT_GT(refusal(bytes).size(), std::string("this PNG file cannot be read: ").size());
}

}  // namespace
}  // namespace dewbow
