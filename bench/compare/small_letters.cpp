// SPDX-License-Identifier: Apache-2.0
#include "small_letters.h"

#include <array>
#include <cctype>

namespace dewbow::bench {
namespace {

struct Letter {
    char character;
    std::array<int, kLetterHeight> rows;  ///< from the top; bit 4 is the left pixel
};

constexpr Letter kLetters[] = {
    {'A', {14, 17, 17, 31, 17, 17, 17}}, {'B', {30, 17, 17, 30, 17, 17, 30}},
    {'C', {14, 17, 16, 16, 16, 17, 14}}, {'D', {30, 17, 17, 17, 17, 17, 30}},
    {'E', {31, 16, 16, 30, 16, 16, 31}}, {'F', {31, 16, 16, 30, 16, 16, 16}},
    {'G', {14, 17, 16, 23, 17, 17, 15}}, {'H', {17, 17, 17, 31, 17, 17, 17}},
    {'I', {14, 4, 4, 4, 4, 4, 14}},      {'J', {7, 2, 2, 2, 2, 18, 12}},
    {'K', {17, 18, 20, 24, 20, 18, 17}}, {'L', {16, 16, 16, 16, 16, 16, 31}},
    {'M', {17, 27, 21, 21, 17, 17, 17}}, {'N', {17, 25, 21, 19, 17, 17, 17}},
    {'O', {14, 17, 17, 17, 17, 17, 14}}, {'P', {30, 17, 17, 30, 16, 16, 16}},
    {'Q', {14, 17, 17, 17, 21, 18, 13}}, {'R', {30, 17, 17, 30, 20, 18, 17}},
    {'S', {15, 16, 16, 14, 1, 1, 30}},   {'T', {31, 4, 4, 4, 4, 4, 4}},
    {'U', {17, 17, 17, 17, 17, 17, 14}}, {'V', {17, 17, 17, 17, 17, 10, 4}},
    {'W', {17, 17, 17, 21, 21, 27, 17}}, {'X', {17, 17, 10, 4, 10, 17, 17}},
    {'Y', {17, 17, 10, 4, 4, 4, 4}},     {'Z', {31, 1, 2, 4, 8, 16, 31}},
    {'0', {14, 17, 19, 21, 25, 17, 14}}, {'1', {4, 12, 4, 4, 4, 4, 14}},
    {'2', {14, 17, 1, 2, 4, 8, 31}},     {'3', {31, 2, 4, 2, 1, 17, 14}},
    {'4', {2, 6, 10, 18, 31, 2, 2}},     {'5', {31, 16, 30, 1, 1, 17, 14}},
    {'6', {6, 8, 16, 30, 17, 17, 14}},   {'7', {31, 1, 2, 4, 8, 8, 8}},
    {'8', {14, 17, 17, 14, 17, 17, 14}}, {'9', {14, 17, 17, 15, 1, 2, 12}},
    {'.', {0, 0, 0, 0, 0, 12, 12}},      {',', {0, 0, 0, 0, 12, 4, 8}},
    {'-', {0, 0, 0, 31, 0, 0, 0}},       {'_', {0, 0, 0, 0, 0, 0, 31}},
    {'+', {0, 4, 4, 31, 4, 4, 0}},       {':', {0, 12, 12, 0, 12, 12, 0}},
};

void put_letter(Image8& image, const Letter& letter, int left, int top, std::uint8_t grey) {
    for (int row = 0; row < kLetterHeight; ++row)
        for (int column = 0; column < kLetterWidth; ++column) {
            const int x = left + column, y = top + row;
            const bool ink = letter.rows[std::size_t(row)] >> (kLetterWidth - 1 - column) & 1;
            if (!ink || x < 0 || x >= image.width || y < 0 || y >= image.height) continue;
            for (int c = 0; c < 3; ++c)
                image.rgb[std::size_t((y * image.width + x) * 3 + c)] = grey;
        }
}

}  // namespace

void put_letters(Image8& image, std::string_view text, int left, int top, std::uint8_t grey) {
    for (const char c : text) {
        const char capital = char(std::toupper(static_cast<unsigned char>(c)));
        for (const Letter& letter : kLetters)
            if (letter.character == capital) put_letter(image, letter, left, top, grey);
        left += kLetterWidth + 1;
    }
}

}  // namespace dewbow::bench
