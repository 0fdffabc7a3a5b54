// SPDX-License-Identifier: Apache-2.0
#include "picture_error.h"

#include <algorithm>
#include <numeric>

#include "dewbow/spectrum/rgb.h"

namespace dewbow::bench {

const std::vector<ErrorColumn>& error_columns() {
    static const std::vector<ErrorColumn> columns = {
        {"sRGB", &PictureError::srgb},     {"trimmed", &PictureError::trimmed},
        {"XYZ", &PictureError::xyz},       {"Y", &PictureError::y},
        {"colour", &PictureError::colour},
    };
    return columns;
}

PictureError error_between(const Picture& a, const Picture& b) {
    PictureError sum;
    std::vector<double> srgb;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Colour<Xyz> d = a[i] - b[i];
        const Colour<LinearSrgb> rgb = rgb_from_xyz<LinearSrgb>(d);
        srgb.push_back((rgb[0] * rgb[0] + rgb[1] * rgb[1] + rgb[2] * rgb[2]) / 3.0);
        sum.xyz += (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) / 3.0;
        sum.y += d[1] * d[1];
        const double x_y = d[0] - d[1], z_y = d[2] - d[1];
        sum.colour += (x_y * x_y + z_y * z_y) / 2.0;
    }
    std::sort(srgb.begin(), srgb.end());
    const auto kept = srgb.size() - std::size_t(kTrimmedShare * double(srgb.size()));
    sum.trimmed = std::accumulate(srgb.begin(), srgb.begin() + std::ptrdiff_t(kept), 0.0);
    sum.srgb = std::accumulate(srgb.begin(), srgb.end(), 0.0);
    for (const ErrorColumn& column : error_columns()) sum.*column.value /= double(a.size());
    sum.trimmed *= double(srgb.size()) / double(kept);
    return sum;
}

Reference make_reference(const Picture& first, const Picture& second) {
    Reference reference{first, error_between(first, second)};
    for (std::size_t i = 0; i < first.size(); ++i) reference.mean[i] = (first[i] + second[i]) * 0.5;
    for (const ErrorColumn& column : error_columns()) reference.own.*column.value /= 4.0;
    return reference;
}

PictureError error_against(const Reference& reference, const Picture& picture) {
    PictureError error = error_between(picture, reference.mean);
    for (const ErrorColumn& column : error_columns())
        error.*column.value = std::max(0.0, error.*column.value - reference.own.*column.value);
    return error;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return n == 0 ? 0.0 : 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

}  // namespace dewbow::bench
