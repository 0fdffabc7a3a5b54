// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/storm.h"

#include <fmt/format.h>

#include <algorithm>

#include "dewbow/base/file.h"
#include "dewbow/import/glass/glass_file.h"
#include "dewbow/import/toml/table.h"
#include "dewbow/optics/catalogue.h"
#include "dewbow/rainbow/models.h"

namespace dewbow {
namespace {

using namespace toml_import;

constexpr std::uint64_t kMaxStormBytes = std::uint64_t{16} << 20;

/// A glass of the catalogue, or of a file in `folder`.
Glass glass_or_file(const std::string& name, const std::filesystem::path& folder) {
    if (!is_glass_file_reference(name)) return find_glass(name);
    const GlassReference reference = split_glass_reference(name);
    return load_glass(resolve_inside(folder.empty() ? "." : folder, reference.file),
                      reference.name);
}

/// One name, or an array of them.
std::vector<std::string> read_models(const TomlDocument& document, const TomlValue& value) {
    std::vector<std::string> known;
    for (const ScatteringModelRow& row : scattering_models()) known.push_back(row.name);
    const auto model = [&](const TomlValue& entry) {
        return known[read_choice(document, entry, "model", known)];
    };
    if (!value.array()) return {model(value)};
    std::vector<std::string> models;
    for (const TomlValue& entry : *value.array()) models.push_back(model(entry));
    if (models.empty()) fail(document, value.place, "model is an empty array");
    return models;
}

Orders read_orders(const TomlDocument& document, const TomlValue& value) {
    const auto order = [&](const TomlValue& entry) {
        return static_cast<int>(read_integer(document, entry, "orders", 0, kHighestOrder));
    };
    if (!value.array()) return {order(value)};
    Orders orders;
    for (const TomlValue& entry : *value.array()) orders.push_back(order(entry));
    if (orders.empty()) fail(document, value.place, "orders is an empty array");
    return orders;
}

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

/// 1.333, or [1.333, 1e-8] with the extinction coefficient.
ComplexIndex read_index_value(const TomlDocument& document, const TomlValue& value) {
    if (!value.array()) return {read_number(document, value, "index", kDropIndices), 0.0};
    if (value.array()->size() != 2)
        fail(document, value.place,
             fmt::format("index is {}; expected n or [n, k]", describe(value)));
    return {read_number(document, (*value.array())[0], "n of index", kDropIndices),
            read_number(document, (*value.array())[1], "k of index", kDropExtinctions)};
}

class StormReader {
public:
    explicit StormReader(const TomlDocument& document)
        : document_(document), table_(document, document.root, "the storm file") {}

    Storm read() {
        table_.at_most_one_of({"drop_radius_mm", "drop_radius_um", "drop_sizes"});
        for (const char* key : {"water", "air"}) table_.at_most_one_of({"index", key});
        read_model();
        read_drops();
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
    std::optional<Glass> glass(std::string_view key) {
        const TomlValue* value = table_.find(key);
        if (!value) return std::nullopt;
        return named(*value, key, [&](const std::string& name) {
            return glass_or_file(name, std::filesystem::path(document_.file).parent_path());
        });
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

    void read_model() {
        if (const TomlValue* value = table_.find("model"))
            storm_.models = read_models(document_, *value);
        if (const TomlValue* value = table_.find("orders"))
            storm_.orders = read_orders(document_, *value);
        storm_.tolerance = table_.find_number("tolerance", kTolerances);
    }

    /// One distribution, or an array of them.
    std::vector<DropSizesPtr> read_showers(const TomlValue& value) {
        if (!value.array()) return {named(value, "drop_sizes", parse_drop_sizes)};
        std::vector<DropSizesPtr> showers;
        for (const TomlValue& entry : *value.array())
            showers.push_back(named(entry, "drop_sizes", parse_drop_sizes));
        if (showers.empty()) fail(document_, value.place, "drop_sizes is an empty array");
        return showers;
    }

    void read_drops() {
        const Range um{1e3 * kDropRadii_mm.low, 1e3 * kDropRadii_mm.high};
        if (const auto mm = table_.find_number("drop_radius_mm", kDropRadii_mm))
            storm_.sizes = {single_drop_size(*mm * unit::mm)};
        if (const auto micrometres = table_.find_number("drop_radius_um", um))
            storm_.sizes = {single_drop_size(*micrometres * unit::um)};
        if (const TomlValue* value = table_.find("drop_sizes")) storm_.sizes = read_showers(*value);
        storm_.shape = word<DropShape>("drop_shape", drop_shape_names());
        storm_.oscillation = table_.find_number("drop_oscillation", kOscillations);
        storm_.tilt = angle("drop_tilt_deg", kTilts_deg);
        storm_.water = glass("water");
        storm_.air = glass("air");
        if (const TomlValue* value = table_.find("index"))
            storm_.index = read_index_value(document_, *value);
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
