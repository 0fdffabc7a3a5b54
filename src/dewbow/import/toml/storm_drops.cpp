// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/storm_drops.h"

#include <fmt/format.h>

#include "dewbow/base/file.h"
#include "dewbow/import/glass/glass_file.h"
#include "dewbow/optics/catalogue.h"
#include "dewbow/rainbow/models.h"

namespace dewbow::toml_import {
namespace {

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

/// 1.333, or [1.333, 1e-8] with the extinction coefficient.
ComplexIndex read_index_value(const TomlDocument& document, const TomlValue& value) {
    if (!value.array()) return {read_number(document, value, "index", kDropIndices), 0.0};
    if (value.array()->size() != 2)
        fail(document, value.place,
             fmt::format("index is {}; expected n or [n, k]", describe(value)));
    return {read_number(document, (*value.array())[0], "n of index", kDropIndices),
            read_number(document, (*value.array())[1], "k of index", kDropExtinctions)};
}

class DropReader {
public:
    DropReader(Table& table, const std::filesystem::path& folder, Storm& storm)
        : table_(table), document_(table.document()), folder_(folder), storm_(storm) {}

    void read() {
        table_.at_most_one_of({"drop_radius_mm", "drop_radius_um", "drop_sizes"});
        for (const char* key : {"water", "air"}) table_.at_most_one_of({"index", key});
        read_model();
        read_drops();
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
        return named(*value, key,
                     [&](const std::string& name) { return glass_or_file(name, folder_); });
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
        if (const TomlValue* value = table_.find("drop_shape"))
            storm_.shape = static_cast<DropShape>(
                read_choice(document_, *value, "drop_shape", drop_shape_names()));
        storm_.oscillation = table_.find_number("drop_oscillation", kOscillations);
        if (const auto degrees = table_.find_number("drop_tilt_deg", kTilts_deg))
            storm_.tilt = *degrees * unit::deg;
        storm_.water = glass("water");
        storm_.air = glass("air");
        if (const TomlValue* value = table_.find("index"))
            storm_.index = read_index_value(document_, *value);
    }

    Table& table_;
    const TomlDocument& document_;
    const std::filesystem::path& folder_;
    Storm& storm_;
};

}  // namespace

void read_storm_drops(Table& table, const std::filesystem::path& folder, Storm& storm) {
    DropReader(table, folder, storm).read();
}

}  // namespace dewbow::toml_import

namespace dewbow {
namespace {

/// Throws InputError for a wavelength that the glass has no data of.
void check_range(const Glass& glass, std::span<const Wavelength> wavelengths) {
    for (const Wavelength lambda : wavelengths) {
        const double nm = lambda.to(unit::nm);
        if (glass.lambda_max_nm <= 0.0 || (nm >= glass.lambda_min_nm && nm <= glass.lambda_max_nm))
            continue;
        throw InputError(fmt::format("no index of {} at {} nm: its data are of {:.6g} to {:.6g} nm",
                                     glass.name, nm, glass.lambda_min_nm, glass.lambda_max_nm));
    }
}

}  // namespace

DropOptics drop_optics(const Storm& storm, std::span<const Wavelength> wavelengths) {
    if (storm.index) {
        const DispersionPtr drop =
            make_dispersion({"constant", {storm.index->n}, IndexReference::vacuum});
        return {drop, vacuum(), storm.index->k};
    }
    const Glass water = storm.water ? *storm.water : find_glass(kDropWater);
    const Glass air = storm.air ? *storm.air : find_glass(kDropAir);
    check_range(water, wavelengths);
    check_range(air, wavelengths);
    const DropOptics optics{make_dispersion(water.data), make_dispersion(air.data), 0.0};
    const double n = optics.index(kSodium).value;
    if (n <= 1.0)
        throw InputError(
            fmt::format("drops of {} in {} have the index {:.6g}, which must be above 1",
                        water.name, air.name, n));
    return optics;
}

}  // namespace dewbow
