// SPDX-License-Identifier: Apache-2.0
#include "rainbow_output.h"

#include <algorithm>
#include <filesystem>

#include "dewbow/base/check.h"
#include "dewbow/export/scattering_files.h"
#include "rainbow_plots.h"

namespace dewbow {
namespace {

struct OutputRow {
    std::string ending, summary;
    std::string (*encode)(RainbowTables& tables);
};

const ScatteringTable& curve(RainbowTables& tables) {
    return tables.get({kSodium}, whole_circle());
}

const std::vector<OutputRow>& rows() {
    static const std::vector<OutputRow> all{
        {".csv", "the curve as a table",
         [](RainbowTables& t) { return csv_of(curve(t), t.setup().facts()); }},
        {".json", "the same for programs",
         [](RainbowTables& t) { return json_of(curve(t), t.setup().facts()); }},
        {".exr", "the table for renderers, angle by wavelength",
         [](RainbowTables& t) {
             return exr_of(t.get(visible_wavelengths(), whole_circle()), t.setup().facts());
         }},
        {".png", "the bow in the sky", [](RainbowTables& t) { return draw_arc(t, ".png"); }},
        {".svg", "the curve as a plot", [](RainbowTables& t) { return draw_intensity(t, ".svg"); }},
    };
    return all;
}

}  // namespace

const std::vector<std::string>& rainbow_output_endings() {
    static const std::vector<std::string> endings = [] {
        std::vector<std::string> names;
        for (const OutputRow& row : rows()) names.push_back(row.ending);
        return names;
    }();
    return endings;
}

std::string rainbow_outputs_described() {
    std::string text;
    for (const OutputRow& row : rows())
        text += (text.empty() ? "" : "; ") + row.ending + ", " + row.summary;
    return text;
}

std::string ending_of(const std::string& file) {
    std::string ending = std::filesystem::path(file).extension().string();
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return ending;
}

std::string rainbow_output(const std::string& file, RainbowTables& tables) {
    const auto row = std::find_if(rows().begin(), rows().end(),
                                  [&](const OutputRow& r) { return r.ending == ending_of(file); });
    DEWBOW_CHECK(row != rows().end(), "the command line knows the endings");
    return row->encode(tables);
}

}  // namespace dewbow
