// SPDX-License-Identifier: Apache-2.0
#include "dewbow/image/exr_preflight.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <optional>

#include "dewbow/image/limits.h"
#include "dewbow/image/refuse.h"

namespace dewbow {
namespace {

static_assert(std::endian::native == std::endian::little, "OpenEXR headers are little endian");

constexpr std::uint32_t kMagic = 20000630;
constexpr std::uint32_t kVersion = 2;
constexpr std::uint32_t kFlagTiled = 0x200, kFlagLongNames = 0x400, kFlagDeep = 0x800,
                        kFlagMultiPart = 0x1000;
/// Longest name with the long-names flag; the library cuts longer ones.
constexpr std::size_t kMaxNameLength = 255;
/// 4096 x 4096: the library takes memory for whole tiles, however small the picture is.
constexpr std::int64_t kMaxTilePixels = std::int64_t{1} << 24;
/// Coordinates of windows stay where sums and differences of two cannot overflow an int.
constexpr std::int64_t kMaxCoordinate = std::int64_t{1} << 29;

/// Reads forward through a slice of the file; every step is checked.
class Reader {
public:
    Reader(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}

    std::string_view take(std::size_t count) {
        if (count > rest_.size()) refuse("it is cut short in its header");
        const std::string_view taken = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return taken;
    }
    template <class T>
    T take_number() {
        T value;
        std::memcpy(&value, take(sizeof value).data(), sizeof value);
        return value;
    }
    /// Text up to a zero byte, which is taken as well.
    std::string_view take_name() {
        const std::size_t end = rest_.substr(0, kMaxNameLength + 1).find('\0');
        if (end == rest_.npos)
            refuse(rest_.size() > kMaxNameLength ? "a name in its header is too long"
                                                 : "it is cut short in its header");
        return take(end + 1).substr(0, end);
    }
    bool empty() const { return rest_.empty(); }

    [[noreturn]] void refuse(const std::string& why) const {
        refuse_file(name_, "this OpenEXR file is not read: " + why);
    }

private:
    std::string_view rest_;
    const std::string& name_;
};

void check_version(Reader& reader) {
    const auto version = reader.take_number<std::uint32_t>();
    if ((version & 0xff) != kVersion)
        reader.refuse(fmt::format("its format version is {}, not {}", version & 0xff, kVersion));
    if (version & kFlagMultiPart)
        reader.refuse("it has several parts, and single-part files are read only");
    if (version & kFlagDeep) reader.refuse("it holds deep data, and flat pictures are read only");
    if (version & ~(0xffu | kFlagTiled | kFlagLongNames))
        reader.refuse("its version field has flags that are not known");
}

struct Window {
    std::int64_t width, height;
};

Window read_window(Reader value) {
    std::int64_t corner[4];
    for (std::int64_t& coordinate : corner) {
        coordinate = value.take_number<std::int32_t>();
        if (coordinate < -kMaxCoordinate || coordinate > kMaxCoordinate)
            value.refuse("its data window lies too far out");
    }
    return {corner[2] - corner[0] + 1, corner[3] - corner[1] + 1};
}

/// Number of channels in a channel list, each checked to be full size.
int count_channels(Reader value) {
    int count = 0;
    for (;;) {
        const std::string_view channel = value.take_name();
        if (channel.empty()) return count;
        value.take(8);  // pixel type, linearity and padding: the library checks them
        const auto x_sampling = value.take_number<std::int32_t>();
        const auto y_sampling = value.take_number<std::int32_t>();
        if (x_sampling != 1 || y_sampling != 1)
            value.refuse(
                fmt::format("its channel \"{}\" is subsampled {} x {}, and full-size "
                            "channels are read only",
                            channel, x_sampling, y_sampling));
        ++count;
    }
}

void check_tiles(Reader value) {
    const std::int64_t width = value.take_number<std::uint32_t>();
    const std::int64_t height = value.take_number<std::uint32_t>();
    if (width < 1 || height < 1 || width > kMaxImageSide || height > kMaxImageSide ||
        width * height > kMaxTilePixels)
        value.refuse(fmt::format("its tiles are {} x {}", width, height));
}

}  // namespace

ExrFacts check_exr_header(std::string_view bytes, const std::string& name) {
    Reader reader(bytes, name);
    if (bytes.size() < 8 || reader.take_number<std::uint32_t>() != kMagic)
        refuse_file(name, "this is not an OpenEXR file");
    check_version(reader);

    std::optional<Window> window;
    std::optional<int> channels;
    for (;;) {
        const std::string_view attribute = reader.take_name();
        if (attribute.empty()) break;
        reader.take_name();  // its type: the library checks it
        const auto size = reader.take_number<std::int32_t>();
        if (size < 0) reader.refuse("a size in its header is negative");
        const std::string_view content = reader.take(static_cast<std::size_t>(size));
        const Reader value(content, name);
        if (attribute == "dataWindow") {
            if (window) reader.refuse("it states its data window twice");
            window = read_window(value);
        } else if (attribute == "channels") {
            if (channels) reader.refuse("it lists its channels twice");
            channels = count_channels(value);
        } else if (attribute == "tiles") {
            check_tiles(value);
        } else if (attribute == "type" && content.starts_with("deep")) {
            reader.refuse("it holds deep data, and flat pictures are read only");
        }
    }
    if (!window) reader.refuse("it states no data window");
    if (!channels) reader.refuse("it lists no channels");
    check_image_size(name, window->width, window->height, *channels, bytes.size());
    return {window->width, window->height, *channels};
}

}  // namespace dewbow
