// SPDX-License-Identifier: Apache-2.0
// The bytes of a render's state, written and read; state.h describes them.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstring>

#include "dewbow/base/checksum.h"
#include "dewbow/base/error.h"
#include "dewbow/base/file.h"
#include "dewbow/render/state.h"
#include "dewbow/scene/caustics_settings.h"

namespace dewbow {

namespace {

constexpr std::string_view kMagic("dewbow state\n\0\0\0", 16);
constexpr std::uint32_t kByteOrder = 0x01020304, kOtherByteOrder = 0x04030201;
constexpr std::uint32_t kVersion = 2;
/// No name or fingerprint is longer.
constexpr std::uint64_t kMostIdentityBytes = 1 << 20;
constexpr std::uint64_t kMostKeptInvalid = 100;
constexpr int kMostSide = 1 << 20, kMostBins = 1 << 12, kMostExponent = 128;
constexpr std::int64_t kMostSamples = std::int64_t{1} << 32;

void append_text(std::string& to, const std::string& text) {
    append_value(to, std::uint64_t{text.size()});
    to += text;
}

/// What is in memory already.
class MemorySource : public ByteSource {
public:
    explicit MemorySource(std::string_view bytes) : bytes_(bytes) {}
    void read(char* to, std::size_t size) override {
        if (size > bytes_.size()) throw InputError("damaged: it ends too early");
        std::memcpy(to, bytes_.data(), size);
        bytes_.remove_prefix(size);
    }
    std::uint64_t left() const override { return bytes_.size(); }

private:
    std::string_view bytes_;
};

std::string read_text(ByteSource& from) {
    const auto size = read_value<std::uint64_t>(from);
    if (size > from.left()) throw InputError("damaged: it ends too early");
    std::string text(static_cast<std::size_t>(size), '\0');
    from.read(text.data(), text.size());
    return text;
}

RenderIdentity identity_from(ByteSource& from) {
    RenderIdentity identity;
    identity.scene_hash = read_value<std::uint64_t>(from);
    identity.estimator = read_text(from);
    identity.settings = read_text(from);
    identity.seed = read_value<std::uint64_t>(from);
    identity.samples_per_pixel = read_value<std::int64_t>(from);
    FilmLayout& film = identity.film;
    for (int* value : {&film.width, &film.height, &film.crop.x0, &film.crop.y0, &film.crop.x1,
                       &film.crop.y1, &film.spectral_bins, &film.reference_exponent,
                       &identity.tile_side, &identity.samples_per_pass})
        *value = read_value<std::int32_t>(from);
    identity.light_paths = read_value<double>(from);
    identity.fingerprint = read_text(from);
    identity.picture = read_text(from);
    if (from.left() > 0) throw InputError("damaged: its description is too long");
    return identity;
}

/// A checksum that holds says that these were written so; it does not say by whom.
void check_possible(const RenderIdentity& identity) {
    const FilmLayout& film = identity.film;
    const PixelRect& crop = film.crop;
    const auto within = [](auto value, auto least, auto most) {
        return value >= least && value <= most;
    };
    const bool possible = within(film.width, 1, kMostSide) && within(film.height, 1, kMostSide) &&
                          crop.x0 >= 0 && crop.y0 >= 0 && crop.x0 < crop.x1 && crop.y0 < crop.y1 &&
                          crop.x1 <= film.width && crop.y1 <= film.height &&
                          within(film.spectral_bins, 0, kMostBins) &&
                          within(film.reference_exponent, -kMostExponent, kMostExponent) &&
                          within(identity.samples_per_pixel, std::int64_t{1}, kMostSamples) &&
                          within(identity.tile_side, 1, kMostSide) &&
                          within(identity.light_paths, 0.0, kMostLightPaths);
    if (!possible) throw InputError("damaged: what it says of the picture is not possible");
    if (identity.samples_per_pass != kSamplesPerPass)
        throw InputError(fmt::format("its passes have {} samples a pixel, and ours {}",
                                     identity.samples_per_pass, kSamplesPerPass));
}

/// Another source, whose bytes are summed up on their way.
class CheckedSource : public ByteSource {
public:
    explicit CheckedSource(ByteSource& from) : from_(from) {}
    void read(char* to, std::size_t size) override {
        if (size > from_.left()) throw InputError("damaged: it ends too early");
        from_.read(to, size);
        checksum_.add({to, size});
    }
    std::uint64_t left() const override { return from_.left(); }
    /// Throws InputError if the next 8 bytes are not the checksum of all before.
    void check() {
        const std::uint64_t expected = checksum_.value();
        if (read_value<std::uint64_t>(*this) != expected)
            throw InputError("damaged: its checksum does not hold");
    }

private:
    ByteSource& from_;
    Checksum checksum_;
};

RenderIdentity read_identity(CheckedSource& from) {
    std::array<char, kMagic.size()> magic{};
    if (from.left() >= magic.size()) from.read(magic.data(), magic.size());
    if (std::string_view(magic.data(), magic.size()) != kMagic)
        throw InputError("not the state of a render");
    const auto byte_order = read_value<std::uint32_t>(from);
    if (byte_order == kOtherByteOrder)
        throw InputError("written on a machine of another byte order");
    if (byte_order != kByteOrder) throw InputError("damaged: its byte order is none");
    const auto version = read_value<std::uint32_t>(from);
    if (version != kVersion)
        throw InputError(
            fmt::format("its version is {}; this program reads version {}", version, kVersion));
    const auto size = read_value<std::uint64_t>(from);
    if (size > kMostIdentityBytes || size > from.left())
        throw InputError("damaged: its description is too long");
    std::string bytes(static_cast<std::size_t>(size), '\0');
    from.read(bytes.data(), bytes.size());
    from.check();
    return identity_from_bytes(bytes);
}

InvalidSamples read_invalid(ByteSource& from, const PixelRect& crop) {
    InvalidSamples invalid;
    invalid.count = read_value<std::int64_t>(from);
    const auto kept = read_value<std::uint64_t>(from);
    bool possible = invalid.count >= 0 && kept <= kMostKeptInvalid &&
                    kept <= static_cast<std::uint64_t>(invalid.count);
    for (std::uint64_t i = 0; possible && i < kept; ++i) {
        InvalidSample sample;
        sample.x = read_value<std::int32_t>(from);
        sample.y = read_value<std::int32_t>(from);
        sample.index = read_value<std::int64_t>(from);
        possible =
            sample.x >= crop.x0 && sample.x < crop.x1 && sample.y >= crop.y0 && sample.y < crop.y1;
        invalid.first.push_back(sample);
    }
    invalid.splats = read_value<std::int64_t>(from);
    possible = possible && invalid.splats >= 0;
    if (!possible) throw InputError("damaged: its list of invalid samples is not possible");
    return invalid;
}

void read_splats(ByteSource& from, SplatSums& splats) {
    const auto blocks = read_value<std::uint64_t>(from);
    std::uint64_t next = 0;
    std::string bytes;
    for (std::uint64_t i = 0; i < blocks; ++i) {
        const auto block = read_value<std::uint64_t>(from);
        if (block < next || block >= splats.blocks())
            throw InputError("damaged: its splats lie where there are no pixels");
        next = block + 1;
        bytes.resize(splats.block_bytes(block));
        from.read(bytes.data(), bytes.size());
        splats.add_block(block, bytes);
    }
}

RenderState read_checked(ByteSource& source) {
    CheckedSource from(source);
    const RenderIdentity identity = read_identity(from);
    const std::size_t pixel_bytes = FilmSums::bytes_per_pixel(identity.film.spectral_bins);
    const auto area = static_cast<std::uint64_t>(identity.film.crop.area());
    if (area * pixel_bytes > from.left()) throw InputError("damaged: it ends too early");

    RenderState state(identity);
    std::string bytes;
    for (std::size_t tile = 0; tile < state.plan.tiles(); ++tile) {
        const PixelRect& part = state.plan.unit(0, tile).tile;
        bytes.resize(static_cast<std::size_t>(part.area()) * pixel_bytes);
        from.read(bytes.data(), bytes.size());
        state.film.add_pixels(part, bytes);
    }
    read_splats(from, state.film.splats());
    state.plan.read_bytes(from);
    state.film.add_light_paths(state.plan.finished_light_paths());
    if (state.film.light_paths() == 0 && state.film.splats().touched_blocks() > 0)
        throw InputError("damaged: it has splats without light paths");
    state.film.add_invalid(read_invalid(from, identity.film.crop));
    state.seconds = read_value<double>(from);
    if (!(state.seconds >= 0.0) || !std::isfinite(state.seconds))
        throw InputError("damaged: its time is not possible");
    from.check();
    if (from.left() > 0) throw InputError("damaged: something follows after its end");
    return state;
}

}  // namespace

std::string identity_bytes(const RenderIdentity& identity) {
    std::string bytes;
    append_value(bytes, identity.scene_hash);
    append_text(bytes, identity.estimator);
    append_text(bytes, identity.settings);
    append_value(bytes, identity.seed);
    append_value(bytes, identity.samples_per_pixel);
    const FilmLayout& film = identity.film;
    for (const int value : {film.width, film.height, film.crop.x0, film.crop.y0, film.crop.x1,
                            film.crop.y1, film.spectral_bins, film.reference_exponent,
                            identity.tile_side, identity.samples_per_pass})
        append_value(bytes, std::int32_t{value});
    append_value(bytes, identity.light_paths);
    append_text(bytes, identity.fingerprint);
    append_text(bytes, identity.picture);
    return bytes;
}

RenderIdentity identity_from_bytes(std::string_view bytes) {
    MemorySource memory(bytes);
    RenderIdentity identity = identity_from(memory);
    check_possible(identity);
    return identity;
}

StateWriter::StateWriter(const RenderIdentity& identity, ByteSink sink) : sink_(std::move(sink)) {
    const std::string description = identity_bytes(identity);
    std::string bytes(kMagic);
    append_value(bytes, kByteOrder);
    append_value(bytes, kVersion);
    append_value(bytes, std::uint64_t{description.size()});
    put(bytes + description);
    put_checksum();
}

void StateWriter::put(std::string_view bytes) {
    checksum_.add(bytes);
    sink_(bytes);
}

void StateWriter::put_checksum() {
    std::string bytes;
    append_value(bytes, checksum_.value());
    put(bytes);
}

void StateWriter::add_tile(std::string_view bytes) { put(bytes); }

void StateWriter::begin_splats(std::size_t blocks) {
    std::string bytes;
    append_value(bytes, std::uint64_t{blocks});
    put(bytes);
}

void StateWriter::add_block(std::size_t block, std::string_view bytes) {
    std::string number;
    append_value(number, std::uint64_t{block});
    put(number);
    put(bytes);
}

void StateWriter::finish(const UnitPlan& plan, const InvalidSamples& invalid, double seconds) {
    std::string bytes;
    plan.append_bytes(bytes);
    append_value(bytes, invalid.count);
    append_value(bytes, std::uint64_t{invalid.first.size()});
    for (const InvalidSample& sample : invalid.first) {
        append_value(bytes, std::int32_t{sample.x});
        append_value(bytes, std::int32_t{sample.y});
        append_value(bytes, sample.index);
    }
    append_value(bytes, invalid.splats);
    append_value(bytes, seconds);
    put(bytes);
    put_checksum();
}

void write_state(const RenderState& state, const ByteSink& sink) {
    StateWriter writer(state.identity, sink);
    std::string bytes;
    for (std::size_t tile = 0; tile < state.plan.tiles(); ++tile) {
        bytes.clear();
        state.film.append_pixels(state.plan.unit(0, tile).tile, bytes);
        writer.add_tile(bytes);
    }
    const SplatSums& splats = state.film.splats();
    writer.begin_splats(splats.touched_blocks());
    for (std::size_t block = 0; block < splats.blocks(); ++block) {
        if (!splats.touched(block)) continue;
        bytes.clear();
        splats.append_block(block, bytes);
        writer.add_block(block, bytes);
    }
    writer.finish(state.plan, state.film.invalid(), state.seconds);
}

std::string state_bytes(const RenderState& state) {
    std::string bytes;
    write_state(state, [&](std::string_view piece) { bytes += piece; });
    return bytes;
}

RenderState read_state(ByteSource& from, const std::string& name) {
    const SourcePlace place{name, 0, 0, {}};
    try {
        return read_checked(from);
    } catch (const std::bad_alloc&) {
        throw InputError(place, "there is not memory enough for this state");
    } catch (const InputError& error) {
        if (!error.place().file.empty()) throw;
        throw InputError(place, error.sentence(), {}, error.hint());
    }
}

RenderState state_from_bytes(std::string_view bytes, const std::string& name) {
    MemorySource source(bytes);
    return read_state(source, name);
}

RenderState load_state(const std::filesystem::path& path) {
    FileSource source(path);
    return read_state(source, path.string());
}

}  // namespace dewbow
