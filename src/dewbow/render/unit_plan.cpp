// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/unit_plan.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "dewbow/base/check.h"
#include "dewbow/base/error.h"

namespace dewbow {

namespace {

std::vector<PixelRect> tiles_of(PixelRect crop, int side) {
    std::vector<PixelRect> tiles;
    for (int y = crop.y0; y < crop.y1; y += side)
        for (int x = crop.x0; x < crop.x1; x += side)
            tiles.push_back({x, y, std::min(x + side, crop.x1), std::min(y + side, crop.y1)});
    return tiles;
}

[[noreturn]] void refuse() {
    throw InputError("damaged: its list of finished units is not possible");
}

constexpr std::size_t kBitsPerByte = 8;

std::size_t bytes_for(std::size_t bits) { return (bits + kBitsPerByte - 1) / kBitsPerByte; }

}  // namespace

UnitPlan::UnitPlan(PixelRect crop, std::int64_t samples_per_pixel, int tile_side,
                   double light_paths)
    : crop_(crop),
      tiles_(tiles_of(crop, tile_side)),
      samples_per_pixel_(samples_per_pixel),
      passes_(
          static_cast<std::size_t>((samples_per_pixel + kSamplesPerPass - 1) / kSamplesPerPass)),
      light_paths_(light_paths) {
    DEWBOW_CHECK(samples_per_pixel >= 1, "a render has samples");
    DEWBOW_CHECK(light_paths >= 0.0, "a number of light paths is not negative");
    light_units_ = (light_paths_of(0) + kLightPathsPerUnit - 1) / kLightPathsPerUnit;
}

std::int64_t UnitPlan::samples_of(std::size_t pass) const {
    const std::int64_t first = static_cast<std::int64_t>(pass) * kSamplesPerPass;
    return std::min<std::int64_t>(kSamplesPerPass, samples_per_pixel_ - first);
}

std::uint64_t UnitPlan::light_paths_of(std::size_t pass) const {
    if (light_paths_ == 0.0) return 0;
    const double paths = light_paths_ * static_cast<double>(samples_of(pass));
    return static_cast<std::uint64_t>(std::max(std::llround(paths), 1LL));
}

Unit UnitPlan::unit(std::size_t pass, std::size_t tile) const {
    DEWBOW_CHECK(pass < passes_ && tile < tiles_.size(), "the plan has that tile");
    const std::int64_t first = static_cast<std::int64_t>(pass) * kSamplesPerPass;
    return {tiles_[tile], first, first + samples_of(pass)};
}

LightUnit UnitPlan::light_unit(std::size_t pass, std::size_t number) const {
    DEWBOW_CHECK(pass < passes_ && is_light(number) && number < units_per_pass(),
                 "the plan has that light unit");
    const std::size_t part = number - tiles_.size();
    const std::uint64_t paths = light_paths_of(pass), each = paths / light_units_,
                        larger = paths % light_units_;  // the first ones have a path more
    const std::uint64_t first = part * each + std::min<std::uint64_t>(part, larger);
    return {pass, first, first + each + (part < larger ? 1 : 0)};
}

void UnitPlan::add_whole(std::size_t first, std::size_t end) {
    auto run = whole_.emplace(first, end).first;
    if (const auto next = whole_.find(end); next != whole_.end()) {
        run->second = next->second;
        whole_.erase(next);
    }
    if (run == whole_.begin()) return;
    const auto before = std::prev(run);
    if (before->second != first) return;
    before->second = run->second;
    whole_.erase(run);
}

void UnitPlan::finish_if_whole(std::map<std::size_t, BegunPass>::iterator begun) {
    if (begun->second.count < units_per_pass()) return;
    const std::size_t pass = begun->first;
    begun_.erase(begun);
    add_whole(pass, pass + 1);
}

void UnitPlan::set_finished(std::size_t pass, std::size_t number) {
    DEWBOW_CHECK(!finished(pass, number), "each unit is finished once");
    const auto begun = begun_.try_emplace(pass).first;
    begun->second.finished.resize(units_per_pass());
    begun->second.finished[number] = true;
    ++begun->second.count;
    ++finished_units_;
    finish_if_whole(begun);
}

bool UnitPlan::finished(std::size_t pass, std::size_t number) const {
    DEWBOW_CHECK(pass < passes_ && number < units_per_pass(), "the plan has that unit");
    const auto begun = begun_.find(pass);
    return begun != begun_.end() ? begun->second.finished[number] : pass_finished(pass);
}

bool UnitPlan::pass_finished(std::size_t pass) const {
    const auto after = whole_.upper_bound(pass);
    return after != whole_.begin() && pass < std::prev(after)->second;
}

std::int64_t UnitPlan::finished_samples() const {
    std::int64_t samples = 0;
    for (const auto& [first, end] : whole_)
        samples += crop_.area() * (unit(end - 1, 0).end_sample - unit(first, 0).first_sample);
    for (const auto& [pass, begun] : begun_) {
        for (std::size_t tile = 0; tile < tiles_.size(); ++tile) {
            if (!begun.finished[tile]) continue;
            const Unit u = unit(pass, tile);
            samples += u.tile.area() * (u.end_sample - u.first_sample);
        }
    }
    return samples;
}

std::uint64_t UnitPlan::finished_light_paths() const {
    if (light_units_ == 0) return 0;
    std::uint64_t paths = 0;
    for (const auto& [first, end] : whole_)  // all passes but the last have as many
        paths += (end - 1 - first) * light_paths_of(first) + light_paths_of(end - 1);
    for (const auto& [pass, begun] : begun_)
        for (std::size_t number = tiles_.size(); number < units_per_pass(); ++number)
            if (begun.finished[number]) paths += light_unit(pass, number).paths();
    return paths;
}

std::size_t UnitPlan::first_open_pass() const {
    const auto run = whole_.begin();
    return run == whole_.end() || run->first > 0 ? 0 : run->second;
}

bool UnitPlan::operator==(const UnitPlan& other) const {
    return crop_ == other.crop_ && tiles_ == other.tiles_ &&
           samples_per_pixel_ == other.samples_per_pixel_ && light_paths_ == other.light_paths_ &&
           begun_ == other.begun_ && whole_ == other.whole_;
}

std::size_t UnitPlan::common_units(const UnitPlan& other) const {
    DEWBOW_CHECK(tiles_ == other.tiles_ && samples_per_pixel_ == other.samples_per_pixel_ &&
                     light_paths_ == other.light_paths_,
                 "the plans have the same units");
    std::size_t common = 0;
    for (const auto& [first, end] : other.whole_) {
        // Only the run before it can reach into it from the left.
        auto run = whole_.upper_bound(first);
        if (run != whole_.begin()) --run;
        for (; run != whole_.end() && run->first < end; ++run) {
            const std::size_t from = std::max(first, run->first), to = std::min(end, run->second);
            if (from < to) common += (to - from) * units_per_pass();
        }
        for (auto pass = begun_.lower_bound(first); pass != begun_.end() && pass->first < end;
             ++pass)
            common += pass->second.count;
    }
    for (const auto& [pass, begun] : other.begun_) {
        if (pass_finished(pass)) common += begun.count;
        const auto here = begun_.find(pass);
        if (here == begun_.end()) continue;
        for (std::size_t number = 0; number < units_per_pass(); ++number)
            common += begun.finished[number] && here->second.finished[number];
    }
    return common;
}

void UnitPlan::add(const UnitPlan& other) {
    DEWBOW_CHECK(common_units(other) == 0, "each unit is finished once");
    for (const auto& [first, end] : other.whole_) add_whole(first, end);
    for (const auto& [pass, begun] : other.begun_) {
        const auto here = begun_.try_emplace(pass).first;
        here->second.finished.resize(units_per_pass());
        for (std::size_t number = 0; number < units_per_pass(); ++number)
            if (begun.finished[number]) here->second.finished[number] = true;
        here->second.count += begun.count;
        finish_if_whole(here);
    }
    finished_units_ += other.finished_units_;
}

void UnitPlan::append_bytes(std::string& to) const {
    append_value(to, std::uint64_t{whole_.size()});
    for (const auto& [first, end] : whole_) {
        append_value(to, std::uint64_t{first});
        append_value(to, std::uint64_t{end});
    }
    append_value(to, std::uint64_t{begun_.size()});
    for (const auto& [pass, begun] : begun_) {
        append_value(to, std::uint64_t{pass});
        std::string bits(bytes_for(units_per_pass()), '\0');
        for (std::size_t number = 0; number < units_per_pass(); ++number)
            if (begun.finished[number])
                bits[number / kBitsPerByte] |= static_cast<char>(1u << (number % kBitsPerByte));
        to += bits;
    }
}

void UnitPlan::read_bytes(ByteSource& from) {
    DEWBOW_CHECK(finished_units_ == 0, "the plan is untouched");
    const auto runs = read_value<std::uint64_t>(from);
    for (std::uint64_t i = 0; i < runs; ++i) {
        const auto first = read_value<std::uint64_t>(from);
        const auto end = read_value<std::uint64_t>(from);
        const bool apart = whole_.empty() || first > whole_.rbegin()->second;
        if (!apart || first >= end || end > passes_) refuse();
        whole_.emplace_hint(whole_.end(), first, end);
        finished_units_ += (end - first) * units_per_pass();
    }
    const auto begun = read_value<std::uint64_t>(from);
    for (std::uint64_t i = 0; i < begun; ++i) read_begun_pass(from);
}

void UnitPlan::read_begun_pass(ByteSource& from) {
    const auto pass = read_value<std::uint64_t>(from);
    const bool later = begun_.empty() || pass > begun_.rbegin()->first;
    if (!later || pass >= passes_ || pass_finished(pass)) refuse();
    std::string bits(bytes_for(units_per_pass()), '\0');
    from.read(bits.data(), bits.size());
    BegunPass begun{std::vector<bool>(units_per_pass()), 0};
    for (std::size_t bit = 0; bit < bits.size() * kBitsPerByte; ++bit) {
        const bool set =
            (static_cast<unsigned char>(bits[bit / kBitsPerByte]) >> (bit % kBitsPerByte)) & 1u;
        if (!set) continue;
        if (bit >= units_per_pass()) refuse();
        begun.finished[bit] = true;
        ++begun.count;
    }
    if (begun.count == 0 || begun.count == units_per_pass()) refuse();
    finished_units_ += begun.count;
    begun_.emplace_hint(begun_.end(), pass, std::move(begun));
}

}  // namespace dewbow
