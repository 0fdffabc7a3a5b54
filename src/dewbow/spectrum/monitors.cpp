// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/monitors.h"

#include <array>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

constexpr std::array<double, 2> kD65{0.3127, 0.3290};

constexpr std::array kMonitors{
    MonitorRow{
        {"rogers", {0.628, 0.346}, {0.268, 0.588}, {0.150, 0.070}, {0.313, 0.329}},
        "a colour monitor of the 1980s, taken to be that of D. F. Rogers, Procedural Elements "
        "for Computer Graphics, 1985, which the paper cites; not checked against the book"},
    MonitorRow{{"smpte-c", {0.630, 0.340}, {0.310, 0.595}, {0.155, 0.070}, kD65},
               "SMPTE RP 145, 1987: phosphors of studio monitors"},
    MonitorRow{{"ntsc", {0.67, 0.33}, {0.21, 0.71}, {0.14, 0.08}, {0.310, 0.316}},
               "FCC 1953; white illuminant C"},
    MonitorRow{{"srgb", {0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, kD65},
               "IEC 61966-2-1, from ITU-R BT.709"},
    MonitorRow{{"rec2020", {0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, kD65}, "ITU-R BT.2020"},
};

}  // namespace

std::span<const MonitorRow> monitors() { return kMonitors; }

const std::vector<std::string>& monitor_names() {
    static const std::vector<std::string> kNames = [] {
        std::vector<std::string> names;
        for (const MonitorRow& row : kMonitors) names.emplace_back(row.primaries.name);
        return names;
    }();
    return kNames;
}

const MonitorRow& find_monitor(std::string_view name) {
    for (const MonitorRow& row : kMonitors)
        if (row.primaries.name == name) return row;
    throw InputError("unknown monitor \"" + std::string(name) + "\"",
                     hint_for(name, monitor_names()));
}

}  // namespace dewbow
