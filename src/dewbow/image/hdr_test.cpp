// SPDX-License-Identifier: Apache-2.0
#include "dewbow/image/hdr.h"

#include <gtest/gtest.h>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

const std::string kHeader = "#?RADIANCE\n# made by hand\nFORMAT=32-bit_rle_rgbe\n\n";

std::string bytes_of(std::initializer_list<int> values) {
    std::string bytes;
    for (const int value : values) bytes.push_back(static_cast<char>(value));
    return bytes;
}

std::string refusal(const std::string& bytes) {
    try {
        decode_hdr(bytes, "sky.hdr");
    } catch (const InputError& error) {
        EXPECT_EQ(error.place().file, "sky.hdr");
        return error.sentence();
    }
    return "it was read";
}
bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != text.npos;
}

std::vector<float> red_of(const std::string& bytes) {
    return decode_hdr(bytes, "sky.hdr").find("R")->values;
}

/// 2^(129 - 136) = 1/128 a step.
TEST(Hdr, FlatPixelsAreMantissaTimesPowerOfTwo) {
    const std::string pixels = bytes_of({128, 64, 32, 129, 200, 100, 50, 0, 255, 1, 0, 136});
    const Image image = decode_hdr(kHeader + "-Y 1 +X 3\n" + pixels, "sky.hdr");
    EXPECT_EQ(image.width, 3);
    EXPECT_EQ(image.height, 1);
    EXPECT_EQ(image.find("R")->values, (std::vector<float>{1.0f, 0.0f, 255.0f}));
    EXPECT_EQ(image.find("G")->values, (std::vector<float>{0.5f, 0.0f, 1.0f}));
    EXPECT_EQ(image.find("B")->values, (std::vector<float>{0.25f, 0.0f, 0.0f}));
}

TEST(Hdr, NewRunsHoldEachComponentApart) {
    const std::string line =
        bytes_of({2,       2,  0, 8,                    // width 8
                  128 + 8, 10,                          // red: one run
                  4,       1,  2, 3, 4, 128 + 4, 5,     // green: literals and a run
                  128 + 3, 7,  5, 1, 2, 3,       4, 5,  // blue
                  128 + 8, 136});                       // exponent: m itself
    const Image image = decode_hdr(kHeader + "-Y 2 +X 8\n" + line + line, "sky.hdr");
    EXPECT_EQ(image.find("R")->values, std::vector<float>(16, 10.0f));
    const std::vector<float> green{1, 2, 3, 4, 5, 5, 5, 5, 1, 2, 3, 4, 5, 5, 5, 5};
    const std::vector<float> blue{7, 7, 7, 1, 2, 3, 4, 5, 7, 7, 7, 1, 2, 3, 4, 5};
    EXPECT_EQ(image.find("G")->values, green);
    EXPECT_EQ(image.find("B")->values, blue);
}

TEST(Hdr, OldRunsRepeatTheLastPixelAndCountOnInBytes) {
    const std::string few = bytes_of({9, 8, 7, 136, 1, 1, 1, 3, 5, 8, 7, 136});
    EXPECT_EQ(red_of(kHeader + "-Y 1 +X 5\n" + few), (std::vector<float>{9, 9, 9, 9, 5}));
    // 2 + 1 * 256 repetitions
    const std::string many = bytes_of({9, 8, 7, 136, 1, 1, 1, 2, 1, 1, 1, 1});
    EXPECT_EQ(red_of(kHeader + "-Y 1 +X 259\n" + many), std::vector<float>(259, 9.0f));
}

TEST(Hdr, ExposureIsTakenOut) {
    const std::string header =
        "#?RADIANCE\nEXPOSURE=2\r\nEXPOSURE= 4\nCOLORCORR= 1 2 0.5\nFORMAT=32-bit_rle_rgbe\n\n";
    const Image image = decode_hdr(header + "-Y 1 +X 1\n" + bytes_of({64, 64, 64, 136}), "sky.hdr");
    EXPECT_EQ(image.find("R")->values[0], 8.0f);
    EXPECT_EQ(image.find("G")->values[0], 4.0f);
    EXPECT_EQ(image.find("B")->values[0], 16.0f);
}

TEST(Hdr, WhatIsNotReadIsRefusedInASentence) {
    const std::string pixel = bytes_of({1, 2, 3, 136});
    EXPECT_TRUE(contains(refusal("P6\n"), "not a Radiance HDR file"));
    EXPECT_TRUE(contains(refusal("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n" + pixel),
                         "32-bit_rle_xyze"));
    EXPECT_TRUE(contains(refusal(kHeader + "+Y 1 +X 1\n" + pixel), "+Y 1 +X 1"));
    EXPECT_TRUE(contains(refusal(kHeader + "-Y one +X 1\n" + pixel), "-Y one"));
    EXPECT_TRUE(contains(refusal(kHeader + "-Y 0 +X 1\n"), "at least one pixel"));
    EXPECT_TRUE(contains(refusal(kHeader + "-Y 1 +X 70000\n"), "65536"));
    EXPECT_TRUE(contains(refusal(kHeader + "-Y 8000 +X 8000\n"), "cannot hold that"));
    EXPECT_TRUE(contains(refusal("#?RADIANCE\nEXPOSURE=0\n\n"), "exposure"));
    EXPECT_TRUE(contains(refusal("#?RADIANCE\nEXPOSURE=nan\n\n"), "exposure"));
}

TEST(Hdr, RunsThatLeaveTheirLineAreRefused) {
    const std::string size = kHeader + "-Y 1 +X 8\n";
    const std::string marker = bytes_of({2, 2, 0, 8});
    EXPECT_TRUE(contains(refusal(size + marker + bytes_of({128 + 9, 1})), "leaves its line"));
    EXPECT_TRUE(contains(refusal(size + marker + bytes_of({9, 1, 2, 3, 4, 5, 6, 7, 8, 9})),
                         "leaves its line"));
    EXPECT_TRUE(contains(refusal(size + marker + bytes_of({0, 0, 0, 0})), "leaves its line"));
    EXPECT_TRUE(contains(refusal(size + bytes_of({2, 2, 0, 9})), "another width"));
    EXPECT_TRUE(contains(refusal(size + bytes_of({1, 1, 1, 1})), "leaves its line"));
    EXPECT_TRUE(contains(refusal(size + bytes_of({9, 9, 9, 9, 1, 1, 1, 8})), "leaves its line"));
}

}  // namespace
}  // namespace dewbow
