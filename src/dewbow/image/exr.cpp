// SPDX-License-Identifier: Apache-2.0
#include "dewbow/image/exr.h"

#include <Iex.h>
#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfDoubleAttribute.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfIntAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <half.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "dewbow/base/check.h"
#include "dewbow/image/exr_preflight.h"
#include "dewbow/image/refuse.h"

namespace dewbow {
namespace {

/// The library works in the calling thread: several pictures can be coded at once, and each one's
/// bytes do not depend on a pool's size.
constexpr int kNoLibraryThreads = 0;
constexpr float kHalfMax = 65504.0f;
/// OpenEXR cuts longer names.
constexpr std::size_t kMaxNameLength = 255;

// ---- streams ---------------------------------------------------------------------------------

class MemoryOutput : public Imf::OStream {
public:
    MemoryOutput() : OStream("memory") {}

    void write(const char bytes[], int count) override {
        const auto size = static_cast<std::size_t>(count);
        if (position_ + size > bytes_.size()) bytes_.resize(position_ + size);
        std::memcpy(bytes_.data() + position_, bytes, size);
        position_ += size;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

    std::string take() { return std::move(bytes_); }

private:
    std::string bytes_;
    std::size_t position_ = 0;
};

class MemoryInput : public Imf::IStream {
public:
    MemoryInput(std::string_view bytes, const std::string& name)
        : IStream(name.c_str()), bytes_(bytes) {}

    bool read(char to[], int count) override {
        if (count < 0 || static_cast<std::uint64_t>(count) > bytes_.size() - position_)
            throw Iex::InputExc("the file is cut short");
        std::memcpy(to, bytes_.data() + position_, static_cast<std::size_t>(count));
        position_ += static_cast<std::uint64_t>(count);
        return position_ < bytes_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override {
        if (position > bytes_.size()) throw Iex::InputExc("it points beyond its end");
        position_ = position;
    }

private:
    std::string_view bytes_;
    std::uint64_t position_ = 0;
};

// ---- header ----------------------------------------------------------------------------------

/// Numbers that OpenEXR's standard attributes, or the spectral layout ("EV"), declare as 32-bit
/// float.
bool is_float_attribute(std::string_view name) {
    constexpr std::string_view kNames[] = {"EV",        "aperture", "altitude",  "expTime",
                                           "focus",     "isoSpeed", "latitude",  "longitude",
                                           "utcOffset", "xDensity", "imageScale"};
    return std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames);
}

/// Fields that describe the file's structure or that ExrOptions states: never an Attribute.
bool is_structural(std::string_view name) {
    constexpr std::string_view kNames[] = {"channels",
                                           "chromaticities",
                                           "chunkCount",
                                           "compression",
                                           "dataWindow",
                                           "displayWindow",
                                           "lineOrder",
                                           "maxSamplesPerPixel",
                                           "name",
                                           "pixelAspectRatio",
                                           "preview",
                                           "screenWindowCenter",
                                           "screenWindowWidth",
                                           "tiles",
                                           "type",
                                           "version",
                                           "view",
                                           "whiteLuminance",
                                           "dwaCompressionLevel"};
    return std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames);
}

bool fits_int(std::int64_t value) {
    return value >= std::numeric_limits<int>::min() && value <= std::numeric_limits<int>::max();
}

void insert_attribute(Imf::Header& header, const Attribute& attribute) {
    const std::string& name = attribute.name;
    if (name.empty() || name.size() > kMaxNameLength || name.find('\0') != name.npos)
        throw InputError("\"" + name + "\" cannot name a header attribute: 1 to 255 bytes can");
    if (is_structural(name))
        throw InputError("the header field \"" + name + "\" is OpenEXR's own and cannot be set");
    if (const auto* text = std::get_if<std::string>(&attribute.value))
        header.insert(name, Imf::StringAttribute(*text));
    else if (const auto* number = std::get_if<double>(&attribute.value))
        if (is_float_attribute(name))
            header.insert(name, Imf::FloatAttribute(static_cast<float>(*number)));
        else
            header.insert(name, Imf::DoubleAttribute(*number));
    else if (const auto integer = std::get<std::int64_t>(attribute.value); fits_int(integer))
        header.insert(name, Imf::IntAttribute(static_cast<int>(integer)));
    else
        header.insert(name, Imf::StringAttribute(std::to_string(integer)));
}

Imf::Chromaticities chromaticities_from(const std::array<double, 8>& xy) {
    const auto point = [&](std::size_t i) {
        return Imath::V2f(static_cast<float>(xy[2 * i]), static_cast<float>(xy[2 * i + 1]));
    };
    return Imf::Chromaticities(point(0), point(1), point(2), point(3));
}

Imf::Header make_header(const Image& image, const Attributes& attributes,
                        const ExrOptions& options) {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::addChromaticities(header, chromaticities_from(options.chromaticities));
    Imf::addWhiteLuminance(header, static_cast<float>(options.white_luminance));
    for (const Attribute& attribute : attributes) insert_attribute(header, attribute);
    return header;
}

std::optional<Attribute> attribute_from(const char* name, const Imf::Attribute& attribute) {
    if (is_structural(name)) return std::nullopt;
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute))
        return Attribute{name, text->value()};
    if (const auto* number = dynamic_cast<const Imf::DoubleAttribute*>(&attribute))
        return Attribute{name, number->value()};
    if (const auto* number = dynamic_cast<const Imf::FloatAttribute*>(&attribute))
        return Attribute{name, double{number->value()}};
    if (const auto* number = dynamic_cast<const Imf::IntAttribute*>(&attribute))
        return Attribute{name, std::int64_t{number->value()}};
    return std::nullopt;
}

std::optional<std::array<double, 8>> read_chromaticities(const Imf::Header& header) {
    if (!Imf::hasChromaticities(header)) return std::nullopt;
    const Imf::Chromaticities& c = Imf::chromaticities(header);
    return std::array<double, 8>{c.red.x,  c.red.y,  c.green.x, c.green.y,
                                 c.blue.x, c.blue.y, c.white.x, c.white.y};
}

void read_header(const Imf::Header& header, DecodedExr& decoded) {
    for (auto field = header.begin(); field != header.end(); ++field)
        if (auto attribute = attribute_from(field.name(), field.attribute()))
            decoded.attributes.push_back(std::move(*attribute));
    decoded.chromaticities = read_chromaticities(header);
    if (Imf::hasWhiteLuminance(header)) decoded.white_luminance = Imf::whiteLuminance(header);

    const Imath::Box2i& data = header.dataWindow();
    const Imath::Box2i& display = header.displayWindow();
    decoded.image.width = data.max.x - data.min.x + 1;
    decoded.image.height = data.max.y - data.min.y + 1;
    decoded.offset_x = data.min.x - display.min.x;
    decoded.offset_y = data.min.y - display.min.y;
    decoded.display_width = display.max.x - display.min.x + 1;
    decoded.display_height = display.max.y - display.min.y + 1;
}

// ---- pixels ----------------------------------------------------------------------------------

/// Depth loses metres in a half float, and narrow bands have tails that a half float drops.
bool stays_float(std::string_view name) {
    const std::string_view last = name.substr(name.rfind('.') + 1);
    const bool emissive =
        name.size() > 3 && name[0] == 'S' && name[1] >= '0' && name[1] <= '3' && name[2] == '.';
    return last == "Z" || emissive || name.starts_with("T.");
}

std::vector<half> half_from(const std::vector<float>& values) {
    std::vector<half> result(values.size());
    std::transform(values.begin(), values.end(), result.begin(), [](float value) {
        return half(std::isfinite(value) ? std::clamp(value, -kHalfMax, kHalfMax) : value);
    });
    return result;
}

void check_writable_image(const Image& image) {
    DEWBOW_CHECK(image.width > 0 && image.height > 0, "a picture has at least one pixel");
    DEWBOW_CHECK(!image.channels.empty(), "a picture has at least one channel");
    const auto pixels =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    for (const Channel& channel : image.channels) {
        DEWBOW_CHECK(channel.values.size() == pixels, "each channel has one value a pixel");
        DEWBOW_CHECK(!channel.name.empty() && channel.name.size() <= kMaxNameLength,
                     "a channel's name has 1 to 255 bytes");
        DEWBOW_CHECK(image.find(channel.name) == &channel, "no two channels share a name");
    }
}

std::string write_exr(const Image& image, Imf::Header header, const ExrOptions& options) {
    Imf::FrameBuffer frame;
    std::vector<std::vector<half>> halves;
    halves.reserve(image.channels.size());
    for (const Channel& channel : image.channels) {
        const void* base = channel.values.data();
        Imf::PixelType type = Imf::FLOAT;
        if (options.half && !stays_float(channel.name)) {
            base = halves.emplace_back(half_from(channel.values)).data();
            type = Imf::HALF;
        }
        header.channels().insert(channel.name, Imf::Channel(type));
        frame.insert(channel.name, Imf::Slice::Make(type, base, header.dataWindow()));
    }
    MemoryOutput stream;
    {
        Imf::OutputFile file(stream, header, kNoLibraryThreads);
        file.setFrameBuffer(frame);
        file.writePixels(image.height);
    }  // the destructor writes the table of lines
    return stream.take();
}

/// Room for every channel, and where the library puts each one's values.
Imf::FrameBuffer make_frame(const Imf::Header& header, Image& image) {
    const auto pixels =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    Imf::FrameBuffer frame;
    for (auto row = header.channels().begin(); row != header.channels().end(); ++row) {
        Channel& channel = image.channels.emplace_back(Channel{row.name(), {}});
        channel.values.resize(pixels);
        frame.insert(row.name(),
                     Imf::Slice::Make(Imf::FLOAT, channel.values.data(), header.dataWindow()));
    }
    return frame;
}

std::int64_t zero_non_finite(Image& image) {
    std::int64_t count = 0;
    for (Channel& channel : image.channels)
        for (float& value : channel.values)
            if (!std::isfinite(value)) {
                value = 0.0f;
                ++count;
            }
    return count;
}

DecodedExr read_exr(std::string_view bytes, const std::string& name, const ExrFacts& facts) {
    MemoryInput stream(bytes, name);
    Imf::InputFile file(stream, kNoLibraryThreads);
    if (!file.isComplete())
        refuse_file(name, "this OpenEXR file is cut short or was never finished");

    DecodedExr decoded;
    read_header(file.header(), decoded);
    if (decoded.image.width != facts.width || decoded.image.height != facts.height)
        refuse_file(name, "this OpenEXR file states its data window in two ways");
    const Imf::FrameBuffer frame = make_frame(file.header(), decoded.image);
    file.setFrameBuffer(frame);
    const Imath::Box2i& window = file.header().dataWindow();
    file.readPixels(window.min.y, window.max.y);
    decoded.non_finite = zero_non_finite(decoded.image);
    return decoded;
}

}  // namespace

std::string encode_exr(const Image& image, const Attributes& attributes,
                       const ExrOptions& options) {
    check_writable_image(image);
    try {
        return write_exr(image, make_header(image, attributes, options), options);
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError(std::string("the picture cannot be written as OpenEXR: ") + error.what());
    }
}

DecodedExr decode_exr(std::string_view bytes, const std::string& name) {
    const ExrFacts facts = check_exr_header(bytes, name);
    try {
        return read_exr(bytes, name, facts);
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        refuse_file(name, std::string("this OpenEXR file cannot be read: ") + error.what());
    }
}

}  // namespace dewbow
