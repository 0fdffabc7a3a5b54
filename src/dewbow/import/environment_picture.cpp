// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/environment_picture.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "dewbow/base/file.h"
#include "dewbow/image/exr.h"
#include "dewbow/image/hdr.h"
#include "dewbow/import/extension.h"

namespace dewbow {
namespace {

struct Picture {
    Image image;
    std::int64_t unusable = 0;
};

Picture decode(const std::filesystem::path& path) {
    const std::string extension = extension_of(path);
    const std::string name = path.string();
    if (extension == ".exr") {
        DecodedExr exr = decode_exr(read_file(path), name);
        return {std::move(exr.image), exr.non_finite};
    }
    if (extension == ".hdr") return {decode_hdr(read_file(path), name), 0};
    throw InputError({name, 0, 0, {}},
                     fmt::format("\"{}\" is no environment picture that is read", extension), {},
                     "expected .exr or .hdr");
}

std::array<const Channel*, 3> colour_channels(const Image& image, const std::string& name) {
    std::array<const Channel*, 3> channels = {image.find("R"), image.find("G"), image.find("B")};
    if (const Channel* grey = image.find("Y"); grey && !channels[0]) channels.fill(grey);
    for (const Channel* channel : channels) {
        if (!channel)
            throw InputError(SourcePlace{name, 0, 0, {}}, "has no channels R, G, B and no Y");
    }
    return channels;
}

}  // namespace

std::shared_ptr<ImageEnvironment> load_environment(const std::filesystem::path& path,
                                                   Diagnostics& diagnostics) {
    Picture picture = decode(path);
    const auto channels = colour_channels(picture.image, path.string());
    auto environment = std::make_shared<ImageEnvironment>();
    environment->width = picture.image.width;
    environment->height = picture.image.height;
    environment->pixels.resize(channels[0]->values.size());
    for (std::size_t i = 0; i < environment->pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double value = double(channels[c]->values[i]);
            const bool usable = std::isfinite(value) && value >= 0.0;
            if (!usable) ++picture.unusable;
            environment->pixels[i][c] = usable ? value : 0.0;
        }
    }
    if (picture.unusable > 0) {
        diagnostics.push_back({{path.string(), 0, 0, {}},
                               fmt::format("{} values that are negative or not finite count as 0",
                                           picture.unusable)});
    }
    return environment;
}

}  // namespace dewbow
