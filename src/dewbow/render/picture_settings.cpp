// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/picture_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dewbow/base/error.h"
#include "dewbow/base/parse_number.h"

namespace dewbow {

namespace {

constexpr std::string_view kExposureModes[] = {"fixed", "automatic", "automatic_if_far"};

std::string name_of(GamutMapping gamut) {
    for (const std::string& name : gamut_mapping_names())
        if (gamut_mapping_from_name(name) == gamut) return name;
    return {};
}

[[noreturn]] void refuse(std::string_view name) {
    throw InputError(fmt::format("its settings of pictures have no {} that can be read", name));
}

/// The lines of a text, in their order.
class Lines {
public:
    explicit Lines(std::string_view text) : text_(text) {}
    std::string_view value(std::string_view name) {
        const std::string_view line = text_.substr(0, text_.find('\n'));
        if (!line.starts_with(name) || line.substr(name.size(), 1) != " ") refuse(name);
        text_.remove_prefix(std::min(text_.size(), line.size() + 1));
        return line.substr(name.size() + 1);
    }
    template <class Number>
    Number number(std::string_view name) {
        const auto number = parse_number<Number>(value(name));
        if (!number) refuse(name);
        return *number;
    }

private:
    std::string_view text_;
};

ExposureMode exposure_mode(std::string_view word) {
    const auto place = std::find(std::begin(kExposureModes), std::end(kExposureModes), word);
    if (place == std::end(kExposureModes)) refuse("exposure_mode");
    return static_cast<ExposureMode>(place - std::begin(kExposureModes));
}

GamutMapping gamut_mapping(std::string_view word) {
    const std::vector<std::string> names = gamut_mapping_names();
    if (std::find(names.begin(), names.end(), word) == names.end()) refuse("gamut");
    return gamut_mapping_from_name(word);
}

}  // namespace

std::string text_of(const PictureSettings& settings) {
    std::string scene_file = settings.scene_file;
    std::replace(scene_file.begin(), scene_file.end(), '\n', ' ');
    return fmt::format(
        "packet {}\nwhite_luminance {}\nexposure_mode {}\nexposure_stops {}\ngamut {}\n"
        "scene_file {}\n",
        settings.packet, settings.white_luminance,
        kExposureModes[static_cast<std::size_t>(settings.exposure)], settings.exposure_stops,
        name_of(settings.gamut), scene_file);
}

PictureSettings picture_settings_from_text(std::string_view text) {
    Lines lines(text);
    PictureSettings settings;
    settings.packet = lines.number<int>("packet");
    settings.white_luminance = lines.number<double>("white_luminance");
    settings.exposure = exposure_mode(lines.value("exposure_mode"));
    settings.exposure_stops = lines.number<double>("exposure_stops");
    settings.gamut = gamut_mapping(lines.value("gamut"));
    settings.scene_file = lines.value("scene_file");
    if (!(settings.white_luminance > 0.0) || !std::isfinite(settings.white_luminance))
        refuse("white_luminance");
    if (!std::isfinite(settings.exposure_stops)) refuse("exposure_stops");
    return settings;
}

}  // namespace dewbow
