// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/storm.h"

#include <fmt/format.h>

#include <algorithm>

#include "dewbow/base/file.h"
#include "dewbow/import/toml/storm_drops.h"
#include "dewbow/import/toml/table.h"

namespace dewbow {
namespace {

using namespace toml_import;

constexpr std::uint64_t kMaxStormBytes = std::uint64_t{16} << 20;

std::vector<double> read_steps(const TomlDocument& document, const TomlValue& value,
                               std::string_view name, const Range& range) {
    Table table(document, value, std::string(name));
    const double from = table.require_number("from", range), to = table.require_number("to", range);
    const double step = table.require_number("step", {0.0, range.high, true, false});
    table.finish();
    if (to < from) table.fail_here(fmt::format("goes from {} to {}; it must ascend", from, to));
    if ((to - from) / step > kMostListed)
        table.fail_here(fmt::format("has more than {} steps", kMostListed));
    return stepped(from, to, step);
}

/// A number, an ascending array of them, or { from, to, step }.
std::vector<double> read_list(const TomlDocument& document, const TomlValue& value,
                              std::string_view name, const Range& range) {
    if (value.table()) return read_steps(document, value, name, range);
    if (!value.array()) return {read_number(document, value, name, range)};
    const std::vector<double> list = read_numbers(document, value, name, range);
    for (std::size_t i = 1; i < list.size(); ++i)
        if (list[i] <= list[i - 1])
            fail(document, (*value.array())[i].place,
                 fmt::format("{}[{}] is {} after {}; it must ascend", name, i, list[i],
                             list[i - 1]));
    return list;
}

class StormReader {
public:
    explicit StormReader(const TomlDocument& document)
        : document_(document), table_(document, document.root, "the storm file") {}

    Storm read() {
        read_storm_drops(table_, std::filesystem::path(document_.file).parent_path(), storm_);
        read_sun();
        read_view();
        table_.finish();
        return storm_;
    }

private:
    /// What `find` finds by the text `value`; its errors get the place.
    template <class Find>
    auto named(const TomlValue& value, std::string_view key, Find find) {
        const std::string& name = read_text(document_, value, key);
        return at_place(document_, value.place, [&] { return find(name); });
    }
    std::optional<bool> boolean(std::string_view key) {
        const TomlValue* value = table_.find(key);
        if (!value) return std::nullopt;
        return read_boolean(document_, *value, key);
    }
    std::optional<Angle> angle(std::string_view key, const Range& range) {
        const auto degrees = table_.find_number(key, range);
        if (!degrees) return std::nullopt;
        return *degrees * unit::deg;
    }
    template <class Word>
    std::optional<Word> word(std::string_view key, const std::vector<std::string>& names) {
        const TomlValue* value = table_.find(key);
        if (!value) return std::nullopt;
        return static_cast<Word>(read_choice(document_, *value, key, names));
    }
    std::vector<double> list(std::string_view key, const Range& range) {
        const TomlValue* value = table_.find(key);
        return value ? read_list(document_, *value, key, range) : std::vector<double>{};
    }

    void read_sun() {
        if (const TomlValue* value = table_.find("illuminant"))
            storm_.illuminant =
                named(*value, "illuminant", [](std::string_view name) { return &find_lamp(name); });
        storm_.sun_altitude = angle("sun_altitude_deg", kSunAltitudes_deg);
        storm_.sun_radius = angle("sun_radius_deg", kSunRadii_deg);
        storm_.limb_darkening = table_.find_number("limb_darkening", kShareRange);
        storm_.reddened = boolean("sun_reddened");
        storm_.haze = table_.find_number("haze_depth", kHazes);
    }

    void read_view() {
        for (const double nm : list("wavelengths_nm", kRainbowWavelengths_nm))
            storm_.wavelengths.push_back(nm * unit::nm);
        for (const double degrees : list("angles_deg", kScatteringAngles_deg))
            storm_.angles.push_back(degrees * unit::deg);
        storm_.polarisation = word<Polarisation>("polarisation", polarisation_names());
        storm_.polariser = angle("polariser_deg", kPolariserAngles_deg);
        storm_.clock_angle = angle("clock_angle_deg", kClockAngles_deg);
    }

    const TomlDocument& document_;
    Table table_;
    Storm storm_;
};

template <class T>
void put_above(std::optional<T>& value, const std::optional<T>& above) {
    if (above) value = above;
}
template <class T>
void put_above(std::vector<T>& value, const std::vector<T>& above) {
    if (!above.empty()) value = above;
}

}  // namespace

const std::vector<std::string>& polarisation_names() {
    static const std::vector<std::string> names{"unpolarised", "perpendicular", "parallel"};
    return names;
}

const std::vector<std::string>& drop_shape_names() {
    static const std::vector<std::string> names{"sphere", "oblate"};
    return names;
}

Storm with_above(Storm storm, const Storm& above) {
    if (above.illuminant) storm.illuminant = above.illuminant;
    if (above.index) storm.water = storm.air = std::nullopt;
    if (above.water || above.air) storm.index = std::nullopt;
    put_above(storm.models, above.models);
    put_above(storm.orders, above.orders);
    put_above(storm.sizes, above.sizes);
    put_above(storm.tolerance, above.tolerance);
    put_above(storm.paper, above.paper);
    put_above(storm.shape, above.shape);
    put_above(storm.oscillation, above.oscillation);
    put_above(storm.tilt, above.tilt);
    put_above(storm.water, above.water);
    put_above(storm.air, above.air);
    put_above(storm.index, above.index);
    put_above(storm.sun_altitude, above.sun_altitude);
    put_above(storm.sun_radius, above.sun_radius);
    put_above(storm.limb_darkening, above.limb_darkening);
    put_above(storm.reddened, above.reddened);
    put_above(storm.haze, above.haze);
    put_above(storm.wavelengths, above.wavelengths);
    put_above(storm.angles, above.angles);
    put_above(storm.polarisation, above.polarisation);
    put_above(storm.polariser, above.polariser);
    put_above(storm.clock_angle, above.clock_angle);
    return storm;
}

std::vector<double> stepped(double from, double to, double step) {
    constexpr double kHair = 1e-6;
    const auto count = static_cast<std::size_t>((to - from) / step + kHair) + 1;
    std::vector<double> list(count);
    for (std::size_t i = 0; i < count; ++i)
        list[i] = std::min(from + static_cast<double>(i) * step, to);
    return list;
}

Storm parse_storm(const std::string& file, std::string text) {
    const TomlDocument document = parse_toml(file, std::move(text));
    return StormReader(document).read();
}

Storm load_storm(const std::filesystem::path& path) {
    return parse_storm(path.string(), read_file(path, kMaxStormBytes));
}

}  // namespace dewbow
