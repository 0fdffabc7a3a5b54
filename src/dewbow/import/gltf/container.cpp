// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/container.h"

#include <fmt/format.h>

#include "dewbow/base/error.h"

namespace dewbow::gltf {
namespace {

constexpr std::string_view kMagic = "glTF";
constexpr std::string_view kJsonChunk = "JSON";
constexpr std::string_view kBinaryChunk{"BIN\0", 4};
constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;

class ContainerReader {
public:
    ContainerReader(const std::string& file, std::string_view bytes) : file_(file), bytes_(bytes) {}

    Container read() {
        read_header();
        const Chunk json = read_chunk();
        if (json.kind != kJsonChunk)
            fail("the first chunk of a .glb holds the JSON; this one does not");
        Container container{json.bytes, std::nullopt};
        while (position_ < bytes_.size()) {
            const Chunk chunk = read_chunk();
            if (chunk.kind == kBinaryChunk && !container.binary) container.binary = chunk.bytes;
        }
        return container;
    }

private:
    struct Chunk {
        std::string_view kind, bytes;
    };

    [[noreturn]] void fail(const std::string& sentence) const {
        throw InputError({file_, 0, 0, fmt::format("byte {}", position_)}, sentence, {}, {});
    }

    std::uint32_t u32(std::size_t offset) const {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            value |= std::uint32_t(static_cast<unsigned char>(bytes_[offset + i])) << (8 * i);
        }
        return value;
    }

    void read_header() {
        if (bytes_.size() < kHeaderBytes) fail("the file ends within its header");
        if (u32(4) != 2) fail(fmt::format("this is version {} of .glb; version 2 is read", u32(4)));
        const std::uint32_t length = u32(8);
        if (length < kHeaderBytes || length > bytes_.size()) {
            fail(fmt::format("the header states {} bytes, the file has {}", length, bytes_.size()));
        }
        bytes_ = bytes_.substr(0, length);
        position_ = kHeaderBytes;
    }

    Chunk read_chunk() {
        if (bytes_.size() - position_ < kChunkHeaderBytes)
            fail("the file ends within a chunk's header");
        const std::uint32_t length = u32(position_);
        const std::string_view kind = bytes_.substr(position_ + 4, 4);
        const std::size_t left = bytes_.size() - position_ - kChunkHeaderBytes;
        if (length > left) {
            fail(fmt::format("a chunk states {} bytes, but {} are left", length, left));
        }
        const Chunk chunk{kind, bytes_.substr(position_ + kChunkHeaderBytes, length)};
        position_ += kChunkHeaderBytes + length;
        return chunk;
    }

    const std::string& file_;
    std::string_view bytes_;
    std::size_t position_ = 0;
};

}  // namespace

Container open_container(const std::string& file, std::string_view bytes) {
    if (!bytes.starts_with(kMagic)) return {bytes, std::nullopt};
    return ContainerReader(file, bytes).read();
}

}  // namespace dewbow::gltf
