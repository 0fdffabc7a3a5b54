// SPDX-License-Identifier: Apache-2.0
#include "dewbow/image/jpeg.h"

#include <gtest/gtest.h>

#include <cstdio>  // jpeglib.h needs FILE and does not say so

#include <jpeglib.h>

#include <cstdlib>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

/// At quality 100 a constant block loses at most a rounding in each of YCbCr and RGB.
constexpr int kConstantColourTolerance = 2;

/// A picture of one colour, whose components are `colour`.
std::string encode(int width, int height, J_COLOR_SPACE space, std::vector<std::uint8_t> colour,
                   bool progressive) {
    jpeg_compress_struct codec{};
    jpeg_error_mgr errors{};
    codec.err = jpeg_std_error(&errors);
    jpeg_create_compress(&codec);
    unsigned char* buffer = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&codec, &buffer, &size);
    codec.image_width = static_cast<JDIMENSION>(width);
    codec.image_height = static_cast<JDIMENSION>(height);
    codec.input_components = static_cast<int>(colour.size());
    codec.in_color_space = space;
    jpeg_set_defaults(&codec);
    jpeg_set_quality(&codec, 100, TRUE);
    if (progressive) jpeg_simple_progression(&codec);
    jpeg_start_compress(&codec, TRUE);
    std::vector<std::uint8_t> line;
    for (int x = 0; x < width; ++x) line.insert(line.end(), colour.begin(), colour.end());
    for (int y = 0; y < height; ++y) {
        JSAMPROW row = line.data();
        jpeg_write_scanlines(&codec, &row, 1);
    }
    jpeg_finish_compress(&codec);
    const std::string bytes(reinterpret_cast<const char*>(buffer), size);
    jpeg_destroy_compress(&codec);
    std::free(buffer);
    return bytes;
}

void expect_colour(const Image8& image, int width, int height, std::array<int, 3> colour) {
    ASSERT_EQ(image.width, width);
    ASSERT_EQ(image.height, height);
    ASSERT_EQ(image.rgb.size(), static_cast<std::size_t>(3 * width * height));
    for (std::size_t i = 0; i < image.rgb.size(); ++i)
        ASSERT_NEAR(image.rgb[i], colour[i % 3], kConstantColourTolerance) << "at byte " << i;
}

std::string refusal(const std::string& bytes) {
    try {
        decode_jpeg(bytes, "wood.jpg");
    } catch (const InputError& error) {
        EXPECT_EQ(error.place().file, "wood.jpg");
        return error.sentence();
    }
    return "it was read";
}
bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != text.npos;
}

TEST(Jpeg, ColourIsRead) {
    for (const bool progressive : {false, true})
        expect_colour(decode_jpeg(encode(19, 11, JCS_RGB, {200, 100, 30}, progressive), "wood.jpg"),
                      19, 11, {200, 100, 30});
}

TEST(Jpeg, GreyBecomesRgb) {
    expect_colour(decode_jpeg(encode(5, 3, JCS_GRAYSCALE, {77}, false), "wood.jpg"), 5, 3,
                  {77, 77, 77});
}

TEST(Jpeg, CmykIsRefused) {
    EXPECT_TRUE(contains(refusal(encode(4, 4, JCS_CMYK, {1, 2, 3, 4}, false)), "CMYK"));
}

TEST(Jpeg, AnotherFormatIsRefused) {
    EXPECT_TRUE(contains(refusal(""), "not a JPEG file"));
    EXPECT_TRUE(contains(refusal("\x89PNG\r\n"), "not a JPEG file"));
}

/// The size stands behind the marker of the frame (FFC0) as length, precision, height, width.
TEST(Jpeg, ClaimedSizesAreCheckedBeforeMemoryIsTaken) {
    std::string bytes = encode(16, 16, JCS_RGB, {1, 2, 3}, false);
    const std::size_t frame = bytes.find("\xff\xc0");
    ASSERT_NE(frame, bytes.npos);
    bytes.replace(frame + 5, 4, "\xff\x00\xff\x00", 4);
    EXPECT_TRUE(contains(refusal(bytes), "pixels are the most")) << refusal(bytes);
    bytes.replace(frame + 5, 4, "\x1f\x40\x1f\x40", 4);
    EXPECT_TRUE(contains(refusal(bytes), "cannot hold that")) << refusal(bytes);
}

TEST(Jpeg, ManyEmptyScansAreRefused) {
    std::string bytes = encode(16, 16, JCS_RGB, {90, 80, 70}, true);
    const std::size_t last_scan = bytes.rfind("\xff\xda");
    ASSERT_NE(last_scan, bytes.npos);
    const std::string scan = bytes.substr(last_scan, bytes.size() - 2 - last_scan);
    std::string many = bytes.substr(0, bytes.size() - 2);
    for (int i = 0; i < 200; ++i) many += scan;
    many += "\xff\xd9";
    EXPECT_TRUE(contains(refusal(many), "cannot be read"));
}

}  // namespace
}  // namespace dewbow
