// SPDX-License-Identifier: Apache-2.0
#pragma once

// The units of a render, and which of them are finished: the truth of what a film holds.

#include <map>

#include "dewbow/base/bytes.h"
#include "dewbow/render/estimator.h"
#include "dewbow/render/light_unit.h"

namespace dewbow {

/// Samples per pixel in one pass. --time and --noise stop at pass ends only.
inline constexpr int kSamplesPerPass = 4;
/// Side of a tile in pixels.
inline constexpr int kTileSide = 16;
/// Most light paths of a unit: about as much work as some tiles.
inline constexpr std::uint64_t kLightPathsPerUnit = 8192;

/// The units of a render, in the order (pass, number), and which of them are finished. The first
/// numbers of a pass are its tiles, the others its light units. A plain value: who shares it
/// between threads guards it.
class UnitPlan {
public:
    /// @param tile_side  of square tiles, in pixels. A tile as large as the picture makes each pass
    /// one unit.  @param light_paths  of each sample of all pixels of the whole picture together;
    /// 0: there are no light units.
    UnitPlan(PixelRect crop, std::int64_t samples_per_pixel, int tile_side = kTileSide,
             double light_paths = 0.0);

    std::size_t passes() const { return passes_; }
    std::size_t tiles() const { return tiles_.size(); }
    std::size_t light_units() const { return light_units_; }  ///< of a pass
    std::size_t units_per_pass() const { return tiles_.size() + light_units_; }
    std::size_t units() const { return passes_ * units_per_pass(); }
    /// Whether that number of a pass is a light unit.
    bool is_light(std::size_t number) const { return number >= tiles_.size(); }
    Unit unit(std::size_t pass, std::size_t tile) const;
    LightUnit light_unit(std::size_t pass, std::size_t number) const;

    void set_finished(std::size_t pass, std::size_t number);  // each unit once
    bool finished(std::size_t pass, std::size_t number) const;
    bool pass_finished(std::size_t pass) const;
    std::size_t finished_units() const { return finished_units_; }
    /// Of all pixels together, in finished units.
    std::int64_t finished_samples() const;
    /// In finished units.
    std::uint64_t finished_light_paths() const;
    /// The first pass that is not wholly finished; passes() if there is none.
    std::size_t first_open_pass() const;

    bool operator==(const UnitPlan& other) const;

    /// How many of the finished units of `other`, a plan of the same units, are finished here too.
    std::size_t common_units(const UnitPlan& other) const;
    /// Takes over the finished units of `other`, a plan of the same units; none in common.
    void add(const UnitPlan& other);

    /// Appends which units are finished: runs of whole passes [first, end), then each pass that is
    /// begun with one bit a unit. Millions of finished passes are 16 bytes.
    void append_bytes(std::string& to) const;
    /// What append_bytes wrote for a plan of the same units, none of which is finished here yet.
    /// Throws InputError if that cannot be; memory is taken only for what `from` has bytes left.
    void read_bytes(ByteSource& from);

private:
    // A pass takes memory from its first finished unit to its last: millions of passes may be
    // planned.
    struct BegunPass {
        std::vector<bool> finished;
        std::size_t count = 0;
        bool operator==(const BegunPass&) const = default;
    };
    void add_whole(std::size_t first, std::size_t end);
    void finish_if_whole(std::map<std::size_t, BegunPass>::iterator begun);
    void read_begun_pass(ByteSource& from);
    std::int64_t samples_of(std::size_t pass) const;
    std::uint64_t light_paths_of(std::size_t pass) const;

    PixelRect crop_;
    std::vector<PixelRect> tiles_;
    std::int64_t samples_per_pixel_;
    std::size_t passes_;
    double light_paths_;
    std::size_t light_units_ = 0;
    std::map<std::size_t, BegunPass> begun_;    // by pass; neither untouched nor wholly finished
    std::map<std::size_t, std::size_t> whole_;  // runs [first, end) of wholly finished passes
    std::size_t finished_units_ = 0;
};

}  // namespace dewbow
