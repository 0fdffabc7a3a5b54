// SPDX-License-Identifier: Apache-2.0
#include "dewbow/export/scattering_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "dewbow/image/exr.h"

namespace dewbow {
namespace {

/// 3 angles × 2 wavelengths; the values tell where they belong: 100 angle + 10 wavelength + 1 or 2.
ScatteringTable small_table() {
    ScatteringTable table;
    for (const double degrees : {0.0, 137.5, 180.0}) table.angles.push_back(degrees * unit::deg);
    for (const double nm : {450.0, 650.0}) table.wavelengths.push_back(nm * unit::nm);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 2; ++j)
            table.phase.push_back({100.0 * i + 10.0 * j + 1.0, 100.0 * i + 10.0 * j + 2.0});
    table.efficiencies = {{2.1, 2.0, 0.8}, {2.2, 2.1, 0.9}};
    table.mean_cross_section = 0.5 * unit::mm * unit::mm;
    table.report = "two\nlines";
    return table;
}
const Attributes kFacts{{"dewbow:model", "mie"}, {"dewbow:sunRadiusDegrees", 0.25}};

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        lines.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return lines;
}

TEST(Csv, HasAHeadAndARowForEachWavelengthAndAngle) {
    const auto lines = lines_of(csv_of(small_table(), kFacts));
    std::vector<std::string> rows;
    std::string head;
    for (const std::string& line : lines)
        line.starts_with("# ") ? void(head += line + "\n") : rows.push_back(line);
    ASSERT_EQ(rows.size(), 7u);
    EXPECT_EQ(rows[0],
              "wavelength_nm,scattering_angle_deg,angle_from_antisolar_deg,P_unpolarised,"
              "P_perpendicular,P_parallel");
    EXPECT_EQ(rows[2], "450,137.5,42.5,101.5,101,102");
    EXPECT_EQ(rows[6], "650,180,0,211.5,211,212");
    for (const char* said :
         {"# model: mie\n", "# sunRadiusDegrees: 0.25\n", "# report: two lines\n",
          "integrates to 4 pi sr", "# 650 nm: Q_ext 2.2, Q_sca 2.1, g 0.9\n"})
        EXPECT_NE(head.find(said), std::string::npos) << said << head;
}

TEST(Json, HoldsTheSame) {
    ScatteringTable table = small_table();
    table.phase[1].perpendicular = NAN;
    const auto json = nlohmann::json::parse(json_of(table, kFacts));
    EXPECT_EQ(json["facts"]["model"], "mie");
    EXPECT_EQ(json["facts"]["report"], "two\nlines");
    EXPECT_EQ(json["scattering_angle_deg"], (std::vector<double>{0.0, 137.5, 180.0}));
    EXPECT_EQ(json["angle_from_antisolar_deg"], (std::vector<double>{180.0, 42.5, 0.0}));
    const auto& red = json["wavelengths"][1];
    EXPECT_EQ(red["wavelength_nm"], 650.0);
    EXPECT_EQ(red["P_parallel"], (std::vector<double>{12.0, 112.0, 212.0}));
    EXPECT_TRUE(red["P_perpendicular"][0].is_null());
    EXPECT_EQ(red["Q_sca"], 2.1);
}

TEST(ExrTable, HasAnglesAcrossAndWavelengthsDown) {
    const DecodedExr exr = decode_exr(exr_of(small_table(), kFacts), "table.exr");
    ASSERT_EQ(exr.image.width, 3);
    ASSERT_EQ(exr.image.height, 2);
    EXPECT_EQ(exr.image.find("P.perpendicular")->values[4], 111.0f);
    EXPECT_EQ(exr.image.find("P.parallel")->values[2], 202.0f);
    EXPECT_EQ(exr.image.find("Q.scattering")->values[5], 2.1f);
    const auto fact = [&](const std::string& name) {
        for (const Attribute& attribute : exr.attributes)
            if (attribute.name == name) return std::get<std::string>(attribute.value);
        return std::string("missing");
    };
    EXPECT_EQ(fact("dewbow:scatteringAnglesDegrees"), "0 137.5 180");
    EXPECT_EQ(fact("dewbow:wavelengthsNanometres"), "450 650");
    EXPECT_NE(fact("dewbow:meaning").find("4 pi sr"), std::string::npos);
}

}  // namespace
}  // namespace dewbow
