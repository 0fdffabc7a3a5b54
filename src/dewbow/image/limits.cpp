// SPDX-License-Identifier: Apache-2.0
#include "dewbow/image/limits.h"

#include <fmt/format.h>

#include "dewbow/image/refuse.h"

namespace dewbow {

void check_image_size(const std::string& name, std::int64_t width, std::int64_t height,
                      std::int64_t channels, std::size_t file_bytes) {
    const auto refuse = [&](const std::string& why) {
        refuse_file(name, fmt::format("the picture is {} x {} with {} channels; {}", width, height,
                                      channels, why));
    };
    if (width < 1 || height < 1) refuse("it needs at least one pixel");
    if (channels < 1) refuse("it needs at least one channel");
    if (width > kMaxImageSide || height > kMaxImageSide)
        refuse(fmt::format("a side may be {} pixels at most", kMaxImageSide));
    if (channels > kMaxImageChannels)
        refuse(fmt::format("{} channels are the most that is read", kMaxImageChannels));
    if (width * height > kMaxImagePixels)
        refuse(fmt::format("{} pixels are the most that is read", kMaxImagePixels));
    // The limits above keep this product below 2^38: it cannot overflow.
    const std::int64_t values = width * height * channels;
    if (values > kMaxImageValues)
        refuse(fmt::format("{} values are the most that is read", kMaxImageValues));
    if ((values - kFreeImageValues) / kMaxValuesPerByte > static_cast<std::int64_t>(file_bytes))
        refuse(fmt::format("a file of {} bytes cannot hold that", file_bytes));
}

}  // namespace dewbow
