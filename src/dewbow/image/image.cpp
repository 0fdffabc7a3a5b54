// SPDX-License-Identifier: Apache-2.0
#include "dewbow/image/image.h"

#include <algorithm>

namespace dewbow {

const Channel* Image::find(std::string_view name) const {
    const auto found = std::find_if(channels.begin(), channels.end(),
                                    [&](const Channel& channel) { return channel.name == name; });
    return found == channels.end() ? nullptr : &*found;
}

}  // namespace dewbow
