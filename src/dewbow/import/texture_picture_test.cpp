// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/texture_picture.h"

#include <gtest/gtest.h>

#include <fstream>

#include "dewbow/base/error.h"
#include "dewbow/image/png.h"

namespace dewbow {
namespace {

using namespace std::string_literals;

const Image8 kTwoPixels{2, 1, {255, 0, 10, 51, 102, 153}};

std::string refusal(const std::string& bytes) {
    try {
        decode_texture(bytes, "wood.png");
    } catch (const InputError& error) {
        return error.what();
    }
    return "it was read";
}

TEST(TexturePicture, HoldsTheTexelsOfItsFile) {
    const auto image = decode_texture(encode_png(kTwoPixels, {}), "wood.png");
    EXPECT_EQ(image->name, "wood.png");
    EXPECT_EQ(image->width, 2);
    EXPECT_EQ(image->height, 1);
    EXPECT_EQ(image->stored(0, 0), (std::array<double, 4>{1.0, 0.0, 10 / 255.0, 1.0}));
    EXPECT_EQ(image->stored(1, 0), (std::array<double, 4>{0.2, 0.4, 0.6, 1.0}));
}

TEST(TexturePicture, OneFileIsReadOnce) {
    const auto path = std::filesystem::path(testing::TempDir()) / "dewbow_texture_picture.png";
    std::ofstream(path, std::ios::binary) << encode_png(kTwoPixels, {});
    TexturePictures pictures;
    const auto first = pictures.load(path);
    std::filesystem::remove(path);
    EXPECT_EQ(pictures.load(path.parent_path() / "." / path.filename()), first);
}

TEST(TexturePicture, FormatsThatAreNotReadAreNamed) {
    struct Row {
        std::string bytes;
        const char* phrase;
    };
    const Row rows[] = {
        {"", "wood.png: is empty"},
        {"RIFF\x10\0\0\0WEBPVP8 "s, "this is a WebP picture; textures are PNG or JPEG"},
        {"\xabKTX 20\xbb\r\n\x1a\n"s, "this is a KTX2 picture"},
        {"II*\0\x08"s, "this is a TIFF picture"},
        {"hello", "is neither a PNG nor a JPEG picture"},
    };
    for (const Row& row : rows) {
        EXPECT_NE(refusal(row.bytes).find(row.phrase), std::string::npos)
            << row.phrase << " is not in " << refusal(row.bytes);
    }
}

TEST(TexturePicture, AMissingFileIsNamed) {
    TexturePictures pictures;
    try {
        pictures.load("no_such_folder/wood.png");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("no_such_folder/wood.png"), std::string::npos);
    }
}

}  // namespace
}  // namespace dewbow
