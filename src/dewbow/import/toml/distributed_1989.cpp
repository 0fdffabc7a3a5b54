// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/distributed_1989.h"

#include "dewbow/spectrum/monitors.h"

namespace dewbow::toml_import {

void read_distributed_1989(const TomlDocument& document, const TomlValue* value,
                           Distributed1989Settings& settings) {
    if (!value) return;
    Table table(document, *value, "[render.distributed_1989]");
    SpectralSampling& sampling = settings.sampling;
    sampling.samples = int(table.integer("samples", 1, kMostSpectralSamples, sampling.samples));
    table.word("jitter", jitter_names(), sampling.jitter);
    sampling.correlated = table.boolean("correlated", sampling.correlated);
    sampling.tailored = table.boolean("tailored", sampling.tailored);
    table.word("colours", spectral_colours_names(), settings.model.colours);
    table.word("spacing", spectral_spacing_names(), settings.model.spacing);
    table.word("negative", negative_colours_names(), settings.model.negative);
    if (const TomlValue* name = table.find("monitor"))
        settings.model.monitor =
            monitor_names()[read_choice(document, *name, "monitor", monitor_names())];
    table.word("sum", sample_sum_names(), settings.sum);
    table.word("transport", rgb_or_spectral_names(), settings.transport);
    table.word("index", index_source_names(), settings.index);
    table.word("reflectance", reflectance_at_names(), settings.reflectance);
    settings.least_weight = table.number("least_weight", kShareRange, settings.least_weight);
    table.finish();
}

}  // namespace dewbow::toml_import
