// SPDX-License-Identifier: Apache-2.0
#pragma once

// The exact state of a render: what it is of, which units are finished, and their sums. It is a
// checkpoint, a slice of a render, a message between machines, and what `merge` adds up.
//
// The bytes, all numbers in the byte order of the machine that wrote them:
//
//     "dewbow state\n"  3 bytes 0                           16 bytes
//     byte order 0x01020304, version                        2 × u32
//     length of the identity, identity                      u64, bytes
//     checksum of all that stands before                    u64
//     pixels of each tile, in the plan's order              128 + 8 · bins bytes a pixel
//     blocks of splats, and number and bytes of each        u64, u64 + SplatSums::append_block each
//     plan                                                  UnitPlan::append_bytes
//     invalid samples: count, kept, and x, y, index each    i64, u64, 2 × i32 + i64 each
//     invalid splats                                        i64
//     seconds of rendering                                  f64
//     checksum of all that stands before                    u64
//
// The checksum is that of base/checksum.h.

#include <filesystem>
#include <optional>

#include "dewbow/base/checksum.h"
#include "dewbow/render/unit_plan.h"

namespace dewbow {

/// All that the bits of a film depend on.
struct RenderIdentity {
    std::uint64_t scene_hash = 0;  ///< of the files and options that the scene was read from
    std::string estimator;
    std::string settings;  ///< of the estimator, as text: "packet 8, max depth 64, …"
    std::uint64_t seed = 0;
    std::int64_t samples_per_pixel = 0;  ///< that are planned
    FilmLayout film;
    int tile_side = kTileSide, samples_per_pass = kSamplesPerPass;
    double light_paths = 0.0;  ///< Estimator::light_paths
    std::string fingerprint;   ///< of the program and machine
    /// How pictures are made of the film (picture_settings.h). Nothing in the film depends on it,
    /// and states that differ in it alone can be added.
    std::string picture;
};

/// The units of that render, none of them finished.
UnitPlan plan_of(const RenderIdentity& identity);

/// The first thing that differs, with both values: `the seed is 1 in a and 2 in b` for the names
/// "a" and "b"; nothing if states of the two can be added.
std::optional<std::string> mismatch(const RenderIdentity& a, const std::string& a_name,
                                    const RenderIdentity& b, const std::string& b_name);

/// As they stand in a state.
std::string identity_bytes(const RenderIdentity& identity);
/// Throws InputError.
RenderIdentity identity_from_bytes(std::string_view bytes);

struct RenderState {
    explicit RenderState(RenderIdentity of);  ///< nothing is finished
    /// @param empty  a film of that layout without samples.
    RenderState(RenderIdentity of, FilmSums empty);
    RenderIdentity identity;
    UnitPlan plan;
    FilmSums film;
    double seconds = 0.0;  ///< of rendering, on all machines one after the other
};

/// Writes a state piece by piece, so that nobody needs it whole in memory: the identity at once,
/// then the pixels of every tile in the plan's order, then what light paths brought, then the rest.
class StateWriter {
public:
    StateWriter(const RenderIdentity& identity, ByteSink sink);
    /// @param bytes  FilmSums::append_pixels of the next tile.
    void add_tile(std::string_view bytes);
    /// @param blocks  how many will be added
    void begin_splats(std::size_t blocks);
    /// @param bytes  SplatSums::append_block of the next block that is touched
    void add_block(std::size_t block, std::string_view bytes);
    void finish(const UnitPlan& plan, const InvalidSamples& invalid, double seconds);

private:
    void put(std::string_view bytes);
    void put_checksum();
    ByteSink sink_;
    Checksum checksum_;
};

void write_state(const RenderState& state, const ByteSink& sink);
std::string state_bytes(const RenderState& state);

/// Throws InputError "NAME: not a render's state …", "… damaged: …": any damage is found, and
/// lengths are checked before memory is taken. @param name  of the file, for messages.
RenderState read_state(ByteSource& from, const std::string& name);
RenderState state_from_bytes(std::string_view bytes, const std::string& name);
/// Reads piece by piece: needs no more memory than the state itself.
RenderState load_state(const std::filesystem::path& path);

/// The ending of files that hold a state.
inline constexpr std::string_view kStateExtension = ".dewbow";

enum class Added { added, already_there };

/// Adds the units of `from`. If `into` has all of them already, nothing is done. Throws InputError,
/// and leaves `into` as it was, if the two are of different renders (naming what differs) or if
/// only some units are there already.
/// @param into_name,from_name  for messages.
Added add_state(RenderState& into, const std::string& into_name, const RenderState& from,
                const std::string& from_name);

}  // namespace dewbow
