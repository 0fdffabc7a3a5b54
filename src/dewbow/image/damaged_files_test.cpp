// SPDX-License-Identifier: Apache-2.0
// Every decoder against files that were cut or damaged: each ends in a picture or in an InputError,
// in no crash and in no other exception. Run it with the address sanitizer to see more.

#include <gtest/gtest.h>

#include <cstdio>  // jpeglib.h needs FILE and does not say so

#include <jpeglib.h>

#include <cstdlib>
#include <functional>
#include <random>

#include "dewbow/base/error.h"
#include "dewbow/image/exr.h"
#include "dewbow/image/hdr.h"
#include "dewbow/image/jpeg.h"
#include "dewbow/image/png.h"

namespace dewbow {
namespace {

constexpr int kWidth = 33, kHeight = 21;
constexpr int kMutants = 600;

/// Smooth with a little noise, so that every coder has something to do.
int sample(int x, int y, int c) { return (x * 5 + y * 3 + c * 40 + (x * y) % 7) & 0xff; }

std::string sound_exr() {
    Image image{kWidth, kHeight, {{"R", {}}, {"G", {}}, {"B", {}}, {"Z", {}}}};
    for (int c = 0; c < 4; ++c)
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                image.channels[std::size_t(c)].values.push_back(float(sample(x, y, c)) / 255.0f);
    return encode_exr(image, {{"dewbow:seed", std::int64_t{1}}, {"note", "damage"}},
                      {.half = true});
}

Image8 sound_picture() {
    Image8 image{kWidth, kHeight, {}};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            for (int c = 0; c < 3; ++c)
                image.rgb.push_back(static_cast<std::uint8_t>(sample(x, y, c)));
    return image;
}

std::string sound_png() { return encode_png(sound_picture(), {{"note", "damage"}}); }

std::string sound_jpeg(bool progressive) {
    jpeg_compress_struct codec{};
    jpeg_error_mgr errors{};
    codec.err = jpeg_std_error(&errors);
    jpeg_create_compress(&codec);
    unsigned char* buffer = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&codec, &buffer, &size);
    codec.image_width = kWidth;
    codec.image_height = kHeight;
    codec.input_components = 3;
    codec.in_color_space = JCS_RGB;
    jpeg_set_defaults(&codec);
    if (progressive) jpeg_simple_progression(&codec);
    jpeg_start_compress(&codec, TRUE);
    Image8 image = sound_picture();
    while (codec.next_scanline < codec.image_height) {
        JSAMPROW row = image.rgb.data() + 3 * kWidth * codec.next_scanline;
        jpeg_write_scanlines(&codec, &row, 1);
    }
    jpeg_finish_compress(&codec);
    const std::string bytes(reinterpret_cast<const char*>(buffer), size);
    jpeg_destroy_compress(&codec);
    std::free(buffer);
    return bytes;
}

/// Each line in the newer run-length form: one run and literals for each component.
std::string sound_hdr() {
    std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2\n\n-Y 21 +X 33\n";
    const auto put = [&](int byte) { bytes.push_back(static_cast<char>(byte)); };
    for (int y = 0; y < kHeight; ++y) {
        for (const int byte : {2, 2, 0, kWidth}) put(byte);
        for (int c = 0; c < 4; ++c) {
            for (const int byte : {128 + 10, 130 + c, kWidth - 10}) put(byte);
            for (int x = 10; x < kWidth; ++x) put(c == 3 ? 129 : sample(x, y, c));
        }
    }
    return bytes;
}

struct Format {
    const char* name;
    std::string sound;
    std::function<std::size_t(std::string_view)> decode;  ///< returns the number of values
};

std::vector<Format> formats() {
    const auto exr = [](std::string_view bytes) {
        const DecodedExr decoded = decode_exr(bytes, "damaged");
        return decoded.image.channels.size() * decoded.image.channels.at(0).values.size();
    };
    const auto png = [](std::string_view bytes) { return decode_png(bytes, "damaged").rgb.size(); };
    const auto jpeg = [](std::string_view bytes) {
        return decode_jpeg(bytes, "damaged").rgb.size();
    };
    const auto hdr = [](std::string_view bytes) {
        return 3 * decode_hdr(bytes, "damaged").channels.at(2).values.size();
    };
    return {{"EXR", sound_exr(), exr},
            {"PNG", sound_png(), png},
            {"JPEG", sound_jpeg(false), jpeg},
            {"progressive JPEG", sound_jpeg(true), jpeg},
            {"HDR", sound_hdr(), hdr}};
}

/// True if `bytes` are read, false if an InputError that names the file refuses them.
bool is_read(const Format& format, std::string_view bytes) {
    try {
        // A copy of exactly that size: reading past its end is seen by the address sanitizer.
        const std::vector<char> exact(bytes.begin(), bytes.end());
        EXPECT_GT(format.decode({exact.data(), exact.size()}), 0u);
        return true;
    } catch (const InputError& error) {
        EXPECT_EQ(error.place().file, "damaged") << error.what();
        EXPECT_FALSE(error.sentence().empty());
        return false;
    }
}

TEST(DamagedFiles, SoundOnesAreRead) {
    for (const Format& format : formats())
        EXPECT_TRUE(is_read(format, format.sound)) << format.name;
}

TEST(DamagedFiles, EveryCutIsRefused) {
    for (const Format& format : formats())
        for (std::size_t length = 0; length < format.sound.size(); ++length)
            ASSERT_FALSE(is_read(format, std::string_view(format.sound).substr(0, length)))
                << format.name << " of " << format.sound.size() << " bytes cut to " << length;
}

/// One to four bytes changed, mostly near the front where the structure stands; or a 32-bit number
/// that overflows things.
std::string mutate(std::string bytes, std::mt19937& random) {
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    const auto place = [&] {
        return below(2) ? below(bytes.size()) : below(std::min<std::size_t>(bytes.size(), 512));
    };
    if (below(4) == 0) {
        constexpr std::uint32_t kNumbers[] = {0,          1,          0x7fffffff, 0x80000000,
                                              0xffffffff, 0xfffffffe, 0x00010000, 0x01000000};
        const std::uint32_t number = kNumbers[below(std::size(kNumbers))];
        const std::size_t at = std::min(place(), bytes.size() - 4);
        for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<char>(number >> (8 * i));
        return bytes;
    }
    for (std::size_t count = 1 + below(4); count > 0; --count)
        bytes[place()] = static_cast<char>(random());
    return bytes;
}

TEST(DamagedFiles, MutantsAreReadOrRefused) {
    std::uint32_t seed = 1;
    for (const Format& format : formats()) {
        std::mt19937 random(seed++);
        int refused = 0;
        for (int mutant = 0; mutant < kMutants; ++mutant) {
            SCOPED_TRACE(std::string(format.name) + " mutant " + std::to_string(mutant));
            refused += !is_read(format, mutate(format.sound, random));
        }
        // Else the mutants reach nothing that matters.
        EXPECT_GT(refused, kMutants / 10) << format.name;
    }
}

}  // namespace
}  // namespace dewbow
