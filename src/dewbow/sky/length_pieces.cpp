// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/length_pieces.h"

#include <algorithm>
#include <cmath>

namespace dewbow {

std::vector<LengthPiece> sum_of(std::span<const LengthPiece> a, std::span<const LengthPiece> b,
                                double sign) {
    const auto at = [](const LengthPiece& piece, double s) {
        return piece.slope == 0.0 ? piece.length : piece.length + piece.slope * (s - piece.begin);
    };
    std::vector<LengthPiece> sum;
    double begin = a.empty() ? 0.0 : a.front().begin;
    for (std::size_t i = 0, k = 0; i < a.size() && k < b.size();) {
        const double end = std::min(a[i].end, b[k].end);
        if (begin < end) {
            const bool endless = std::isinf(a[i].length);
            const double length = endless ? a[i].length : at(a[i], begin) + sign * at(b[k], begin);
            const double slope = endless ? 0.0 : a[i].slope + sign * b[k].slope;
            sum.push_back({begin, end, std::max(0.0, length), slope});
        }
        begin = end;
        const bool next_a = a[i].end <= end, next_b = b[k].end <= end;
        i += next_a, k += next_b;
    }
    return sum;
}

void scale_distance(std::span<LengthPiece> pieces, double factor) {
    for (LengthPiece& piece : pieces)
        piece.begin *= factor, piece.end *= factor, piece.slope /= factor;
}

void drop_endless(std::span<LengthPiece> pieces) {
    for (LengthPiece& piece : pieces) {
        if (std::isinf(piece.length)) piece.length = 0.0;
    }
}

}  // namespace dewbow
