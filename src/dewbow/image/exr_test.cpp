// SPDX-License-Identifier: Apache-2.0
#include "dewbow/image/exr.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStdIO.h>
#include <ImfTiledOutputFile.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <thread>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

/// Half floats keep 11 bits: rounding is at most 2^-11 of the value.
constexpr double kHalfRounding = 1.0 / 2048.0;

/// Values from tiny to huge, of both signs, none equal to its neighbours'.
Image picture(int width, int height, std::initializer_list<const char*> names) {
    Image image{width, height, {}};
    for (const char* name : names) {
        Channel& channel = image.channels.emplace_back(Channel{name, {}});
        float value = 1e-3f * static_cast<float>(image.channels.size());
        for (int i = 0; i < width * height; ++i) channel.values.push_back(value *= -1.037f);
    }
    return image;
}

void expect_same_bits(const Image& image, const Image& expected) {
    ASSERT_EQ(image.width, expected.width);
    ASSERT_EQ(image.height, expected.height);
    ASSERT_EQ(image.channels.size(), expected.channels.size());
    for (const Channel& channel : expected.channels) {
        const Channel* found = image.find(channel.name);
        ASSERT_TRUE(found) << channel.name;
        ASSERT_EQ(found->values.size(), channel.values.size());
        EXPECT_EQ(std::memcmp(found->values.data(), channel.values.data(),
                              channel.values.size() * sizeof(float)),
                  0)
            << channel.name;
    }
}

const Attribute* find(const Attributes& attributes, std::string_view name) {
    for (const Attribute& attribute : attributes)
        if (attribute.name == name) return &attribute;
    return nullptr;
}

std::string refusal(std::string_view bytes) {
    try {
        decode_exr(bytes, "shot.exr");
    } catch (const InputError& error) {
        EXPECT_EQ(error.place().file, "shot.exr");
        return error.sentence();
    }
    return "it was read";
}
bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != text.npos;
}

// ---- round trips -----------------------------------------------------------------------------

TEST(Exr, FloatsComeBackBitForBit) {
    Image image = picture(37, 23, {"R", "G", "B", "Z", "albedo.R", "S0.550,000000nm"});
    image.channels[0].values[0] = std::numeric_limits<float>::denorm_min();
    image.channels[0].values[1] = std::numeric_limits<float>::max();
    image.channels[0].values[2] = -0.0f;
    const DecodedExr decoded = decode_exr(encode_exr(image, {}, {}), "shot.exr");
    expect_same_bits(decoded.image, image);
    EXPECT_EQ(decoded.non_finite, 0);
    EXPECT_EQ(decoded.offset_x, 0);
    EXPECT_EQ(decoded.display_width, 37);
    EXPECT_EQ(decoded.display_height, 23);
}

TEST(Exr, HalvesAreRoundedAndClampedAndDepthAndSpectraAreNot) {
    Image image = picture(8, 8, {"R", "Z", "camera.Z", "S0.550,000000nm", "T.550,000000nm", "Sky"});
    image.channels[0].values[5] = 1e6f;
    image.channels[0].values[6] = -1e6f;
    const DecodedExr decoded = decode_exr(encode_exr(image, {}, {.half = true}), "shot.exr");
    for (const char* name : {"Z", "camera.Z", "S0.550,000000nm", "T.550,000000nm"})
        EXPECT_EQ(decoded.image.find(name)->values, image.find(name)->values) << name;
    for (const char* name : {"R", "Sky"}) {
        EXPECT_NE(decoded.image.find(name)->values, image.find(name)->values) << name;
        for (std::size_t i = 0; i < 64; ++i) {
            const float expected = std::clamp(image.find(name)->values[i], -65504.0f, 65504.0f);
            EXPECT_NEAR(decoded.image.find(name)->values[i], expected,
                        std::abs(expected) * kHalfRounding);
        }
    }
}

TEST(Exr, AttributesComeBack) {
    const Attributes attributes{{"dewbow:seed", std::int64_t{7}},
                                {"dewbow:large", std::int64_t{1} << 40},
                                {"dewbow:smallest", std::int64_t{std::numeric_limits<int>::min()}},
                                {"dewbow:below", std::int64_t{-2147483649}},
                                {"dewbow:exposure", 0.1},
                                {"EV", -1.5},
                                {"dewbow:command", "dewbow render é.toml"},
                                {"dewbow:empty", ""},
                                {std::string(200, 'n'), "a name longer than 31 bytes"}};
    const Attributes decoded =
        decode_exr(encode_exr(picture(1, 1, {"R"}), attributes, {}), "shot.exr").attributes;
    ASSERT_EQ(decoded.size(), attributes.size());
    for (const Attribute& attribute : attributes) {
        const Attribute* found = find(decoded, attribute.name);
        ASSERT_TRUE(found) << attribute.name;
        if (attribute.name == "dewbow:large")
            EXPECT_EQ(std::get<std::string>(found->value), "1099511627776");
        else if (attribute.name == "dewbow:below")
            EXPECT_EQ(std::get<std::string>(found->value), "-2147483649");
        else
            EXPECT_EQ(found->value, attribute.value) << attribute.name;
    }
}

TEST(Exr, TheSpectralLayoutsExposureIsAFloat) {
    const std::string bytes = encode_exr(picture(1, 1, {"R"}), {{"EV", 0.0}}, {});
    EXPECT_TRUE(contains(bytes, std::string_view("EV\0float\0", 9)));
}

TEST(Exr, FieldsThatOpenExrOwnsCannotBeSet) {
    for (const char* name : {"compression", "channels", "dataWindow", "chromaticities", "type", ""})
        EXPECT_THROW(encode_exr(picture(1, 1, {"R"}), {{name, "x"}}, {}), InputError) << name;
    EXPECT_THROW(encode_exr(picture(1, 1, {"R"}), {{std::string(256, 'n'), "x"}}, {}), InputError);
}

TEST(Exr, PrimariesAndWhiteAreStated) {
    const std::string bytes = encode_exr(picture(1, 1, {"R"}), {}, {.white_luminance = 683.0});
    const DecodedExr decoded = decode_exr(bytes, "shot.exr");
    ASSERT_TRUE(decoded.chromaticities && decoded.white_luminance);
    const std::array<double, 8> srgb{0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290};
    for (std::size_t i = 0; i < srgb.size(); ++i)
        EXPECT_EQ((*decoded.chromaticities)[i], static_cast<float>(srgb[i]));
    EXPECT_EQ(*decoded.white_luminance, 683.0);
}

TEST(Exr, ValuesThatAreNotFiniteBecomeZeroAndAreCounted) {
    Image image = picture(4, 4, {"R", "G"});
    image.channels[0].values[3] = std::numeric_limits<float>::quiet_NaN();
    image.channels[1].values[4] = std::numeric_limits<float>::infinity();
    image.channels[1].values[5] = -std::numeric_limits<float>::infinity();
    const DecodedExr decoded = decode_exr(encode_exr(image, {}, {}), "shot.exr");
    EXPECT_EQ(decoded.non_finite, 3);
    EXPECT_EQ(decoded.image.find("R")->values[3], 0.0f);
    EXPECT_EQ(decoded.image.find("G")->values[4], 0.0f);
    EXPECT_EQ(decoded.image.find("G")->values[5], 0.0f);
    EXPECT_EQ(decoded.image.find("G")->values[6], image.channels[1].values[6]);
}

TEST(Exr, ThreadsWriteTheSameBytes) {
    const Image image = picture(64, 64, {"R", "G", "B"});
    const std::string expected = encode_exr(image, {}, {.half = true});
    std::vector<std::string> results(4);
    {
        std::vector<std::jthread> threads;
        for (std::string& result : results)
            threads.emplace_back([&] {
                result = encode_exr(image, {}, {.half = true});
                expect_same_bits(decode_exr(result, "shot.exr").image,
                                 decode_exr(expected, "shot.exr").image);
            });
    }
    for (const std::string& result : results) EXPECT_EQ(result, expected);
}

// ---- files of other programs, written here with the library itself ---------------------------

const Imath::Box2i kWindow(Imath::V2i(-3, 5), Imath::V2i(29, 21));
const Imath::Box2i kDisplay(Imath::V2i(1, 2), Imath::V2i(20, 13));
constexpr int kWindowWidth = 33, kWindowHeight = 17;

Imf::Header foreign_header(const char* channel, int sampling = 1) {
    Imf::Header header(kDisplay, kWindow);
    header.channels().insert(channel, Imf::Channel(Imf::FLOAT, sampling, sampling));
    return header;
}

Imf::FrameBuffer frame_of(const Image& image) {
    Imf::FrameBuffer frame;
    for (const Channel& channel : image.channels)
        frame.insert(channel.name, Imf::Slice::Make(Imf::FLOAT, channel.values.data(), kWindow));
    return frame;
}

std::string scanline_file(const Image& image, Imf::Compression compression) {
    Imf::Header header = foreign_header("Y");
    header.compression() = compression;
    Imf::StdOSStream stream;
    {
        Imf::OutputFile file(stream, header, 0);
        file.setFrameBuffer(frame_of(image));
        file.writePixels(kWindowHeight);
    }
    return stream.str();
}

std::string tiled_file(const Image& image, Imf::LevelMode mode) {
    Imf::Header header = foreign_header("Y");
    header.setTileDescription(Imf::TileDescription(8, 4, mode));
    Imf::StdOSStream stream;
    {
        Imf::TiledOutputFile file(stream, header, 0);
        file.setFrameBuffer(frame_of(image));
        for (int level = 0; level < file.numLevels(); ++level)
            file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
    }
    return stream.str();
}

std::string two_part_file(const Image& image) {
    std::vector<Imf::Header> headers(2, foreign_header("Y"));
    headers[0].setName("left");
    headers[1].setName("right");
    for (Imf::Header& header : headers) header.setType(Imf::SCANLINEIMAGE);
    Imf::StdOSStream stream;
    {
        Imf::MultiPartOutputFile file(stream, headers.data(), 2, false, 0);
        for (int part = 0; part < 2; ++part) {
            Imf::OutputPart output(file, part);
            output.setFrameBuffer(frame_of(image));
            output.writePixels(kWindowHeight);
        }
    }
    return stream.str();
}

TEST(Exr, WindowsWithOffsetsAreRead) {
    const Image image = picture(kWindowWidth, kWindowHeight, {"Y"});
    for (const Imf::Compression compression :
         {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,
          Imf::PIZ_COMPRESSION}) {
        const DecodedExr decoded = decode_exr(scanline_file(image, compression), "shot.exr");
        expect_same_bits(decoded.image, image);
        EXPECT_EQ(decoded.offset_x, -4);
        EXPECT_EQ(decoded.offset_y, 3);
        EXPECT_EQ(decoded.display_width, 20);
        EXPECT_EQ(decoded.display_height, 12);
        EXPECT_TRUE(decoded.attributes.empty());
        EXPECT_FALSE(decoded.chromaticities || decoded.white_luminance);
    }
}

TEST(Exr, TilesAreReadAtFullSize) {
    const Image image = picture(kWindowWidth, kWindowHeight, {"Y"});
    expect_same_bits(decode_exr(tiled_file(image, Imf::ONE_LEVEL), "shot.exr").image, image);
    expect_same_bits(decode_exr(tiled_file(image, Imf::MIPMAP_LEVELS), "shot.exr").image, image);
}

TEST(Exr, SeveralPartsAreRefused) {
    EXPECT_TRUE(contains(refusal(two_part_file(picture(kWindowWidth, kWindowHeight, {"Y"}))),
                         "several parts"));
}

TEST(Exr, SubsampledChannelsAreRefused) {
    Imf::Header header(8, 8);
    header.channels().insert("BY", Imf::Channel(Imf::HALF, 2, 2));
    Imf::StdOSStream stream;
    { Imf::OutputFile file(stream, header, 0); }
    EXPECT_TRUE(contains(refusal(stream.str()), "\"BY\" is subsampled 2 x 2"));
}

TEST(Exr, FilesThatWereNeverFinishedAreRefused) {
    const Image image = picture(kWindowWidth, kWindowHeight, {"Y"});
    Imf::StdOSStream stream;
    {
        Imf::OutputFile file(stream, foreign_header("Y"), 0);
        file.setFrameBuffer(frame_of(image));
        file.writePixels(kWindowHeight / 2);
    }
    EXPECT_TRUE(contains(refusal(stream.str()), "cut short")) << refusal(stream.str());
}

// ---- hostile headers -------------------------------------------------------------------------

/// `bytes` with the value of the header's attribute replaced by one of the same size.
std::string with_attribute(std::string bytes, std::string_view name_and_type,
                           std::string_view value) {
    const std::size_t at = bytes.find(name_and_type);
    EXPECT_NE(at, bytes.npos);
    return bytes.replace(at + name_and_type.size() + 4, value.size(), value);
}

std::string with_window(const std::string& bytes, std::array<std::int32_t, 4> corners) {
    return with_attribute(bytes, std::string_view("dataWindow\0box2i\0", 17),
                          {reinterpret_cast<const char*>(corners.data()), sizeof corners});
}

TEST(Exr, ClaimedSizesAreCheckedBeforeMemoryIsTaken) {
    const std::string bytes = encode_exr(picture(4, 4, {"R", "G", "B"}), {}, {});
    constexpr int kMin = std::numeric_limits<int>::min(), kMax = std::numeric_limits<int>::max();
    EXPECT_TRUE(contains(refusal(with_window(bytes, {0, 0, 69999, 69999})), "a side may be"));
    EXPECT_TRUE(contains(refusal(with_window(bytes, {0, 0, 59999, 59999})), "pixels are the most"));
    EXPECT_TRUE(contains(refusal(with_window(bytes, {0, 0, 15999, 15999})), "cannot hold that"));
    EXPECT_TRUE(contains(refusal(with_window(bytes, {1, 0, 0, 9})), "at least one pixel"));
    EXPECT_TRUE(contains(refusal(with_window(bytes, {kMin, kMin, kMax, kMax})), "too far out"));
    EXPECT_TRUE(contains(refusal(with_window(bytes, {0, 0, 4, 4})), "cannot be read"));
}

TEST(Exr, LargeTilesAreRefused) {
    const std::string bytes =
        tiled_file(picture(kWindowWidth, kWindowHeight, {"Y"}), Imf::ONE_LEVEL);
    const std::string_view field("tiles\0tiledesc\0", 15);
    const std::array<std::uint32_t, 2> large{40000, 40000}, none{0, 8};
    EXPECT_TRUE(contains(
        refusal(with_attribute(bytes, field, {reinterpret_cast<const char*>(large.data()), 8})),
        "tiles are 40000 x 40000"));
    EXPECT_TRUE(contains(
        refusal(with_attribute(bytes, field, {reinterpret_cast<const char*>(none.data()), 8})),
        "tiles are 0 x 8"));
}

TEST(Exr, DeepDataAndUnknownVersionsAreRefused) {
    std::string bytes = encode_exr(picture(1, 1, {"R"}), {}, {});
    bytes[5] = 0x08;
    EXPECT_TRUE(contains(refusal(bytes), "deep"));
    bytes[5] = 0x40;
    EXPECT_TRUE(contains(refusal(bytes), "flags"));
    bytes[5] = 0;
    bytes[4] = 3;
    EXPECT_TRUE(contains(refusal(bytes), "version is 3"));
}

TEST(Exr, AnotherFormatIsRefused) {
    EXPECT_TRUE(contains(refusal(""), "not an OpenEXR file"));
    EXPECT_TRUE(contains(refusal("\x89PNG\r\n\x1a\n        "), "not an OpenEXR file"));
}

}  // namespace
}  // namespace dewbow
