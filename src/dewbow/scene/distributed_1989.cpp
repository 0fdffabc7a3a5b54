// SPDX-License-Identifier: Apache-2.0
#include "dewbow/scene/distributed_1989.h"

#include <fmt/format.h>

namespace dewbow {

namespace {

template <class Enum>
const std::string& word(const std::vector<std::string>& names, Enum value) {
    return names[static_cast<std::size_t>(value)];
}

}  // namespace

const std::vector<std::string>& sample_sum_names() {
    static const std::vector<std::string> names{"clamp", "wrap", "free"};
    return names;
}

const std::vector<std::string>& rgb_or_spectral_names() {
    static const std::vector<std::string> names{"rgb", "spectral"};
    return names;
}

const std::vector<std::string>& index_source_names() {
    static const std::vector<std::string> names{"linear", "scene"};
    return names;
}

const std::vector<std::string>& reflectance_at_names() {
    static const std::vector<std::string> names{"nominal", "spectral"};
    return names;
}

std::string text_of(const Distributed1989Settings& s) {
    return fmt::format(
        "samples {}, jitter {}, correlated {}, tailored {}, colours {}, spacing {}, negative {}, "
        "monitor {}, sum {}, transport {}, index {}, reflectance {}, least weight {}",
        s.sampling.samples, word(jitter_names(), s.sampling.jitter), s.sampling.correlated,
        s.sampling.tailored, word(spectral_colours_names(), s.model.colours),
        word(spectral_spacing_names(), s.model.spacing),
        word(negative_colours_names(), s.model.negative), s.model.monitor,
        word(sample_sum_names(), s.sum), word(rgb_or_spectral_names(), s.transport),
        word(index_source_names(), s.index), word(reflectance_at_names(), s.reflectance),
        s.least_weight);
}

}  // namespace dewbow
