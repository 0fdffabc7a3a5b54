// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/distributed_1989.h"

#include "dewbow/spectrum/monitors.h"

namespace dewbow::toml_import {
namespace {

/// One of `names`, which stand in the order of the enumerators.
template <class Enum>
void read_word(Table& table, std::string_view key, const std::vector<std::string>& names,
               Enum& setting) {
    if (const TomlValue* value = table.find(key))
        setting = static_cast<Enum>(read_choice(table.document(), *value, key, names));
}

}  // namespace

void read_distributed_1989(const TomlDocument& document, const TomlValue* value,
                           Distributed1989Settings& settings) {
    if (!value) return;
    Table table(document, *value, "[render.distributed_1989]");
    SpectralSampling& sampling = settings.sampling;
    sampling.samples = int(table.integer("samples", 1, kMostSpectralSamples, sampling.samples));
    read_word(table, "jitter", jitter_names(), sampling.jitter);
    sampling.correlated = table.boolean("correlated", sampling.correlated);
    sampling.tailored = table.boolean("tailored", sampling.tailored);
    read_word(table, "colours", spectral_colours_names(), settings.model.colours);
    read_word(table, "spacing", spectral_spacing_names(), settings.model.spacing);
    read_word(table, "negative", negative_colours_names(), settings.model.negative);
    if (const TomlValue* name = table.find("monitor"))
        settings.model.monitor =
            monitor_names()[read_choice(document, *name, "monitor", monitor_names())];
    read_word(table, "sum", sample_sum_names(), settings.sum);
    read_word(table, "transport", rgb_or_spectral_names(), settings.transport);
    read_word(table, "index", index_source_names(), settings.index);
    read_word(table, "reflectance", reflectance_at_names(), settings.reflectance);
    settings.least_weight = table.number("least_weight", kShareRange, settings.least_weight);
    table.finish();
}

}  // namespace dewbow::toml_import
