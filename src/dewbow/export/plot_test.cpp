// SPDX-License-Identifier: Apache-2.0
#include "dewbow/export/plot.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dewbow {
namespace {

TEST(RoundTicks, AreRoundAndInside) {
    const auto expect = [](std::vector<double> ticks, std::vector<double> expected) {
        ASSERT_EQ(ticks.size(), expected.size());
        for (std::size_t i = 0; i < ticks.size(); ++i) EXPECT_NEAR(ticks[i], expected[i], 1e-12);
    };
    expect(round_ticks(0.0, 1.0, 5), {0.0, 0.2, 0.4, 0.6, 0.8, 1.0});
    expect(round_ticks(360.0, 830.0, 7), {400.0, 500.0, 600.0, 700.0, 800.0});
    expect(round_ticks(-1.0, 1.0, 4), {-1.0, -0.5, 0.0, 0.5, 1.0});
    expect(round_ticks(2.0, 2.0, 4), {2.0});
}

PlotPanel panel() {
    PlotPanel p;
    p.title = "n < 2 & more";
    p.x = {"wavelength (nm)", 400.0, 700.0};
    p.y = {"n", 1.0, 2.0};
    p.curves.push_back({"", plot_colour(0), {{400.0, 1.5}, {700.0, 1.4}}, false});
    return p;
}

TEST(Svg, PutsPointsWhereTheAxesSay) {
    const PlotPanel p = panel();
    const std::string svg = svg_of({&p, 1});
    // The area is 78…598 by 46…406 pixels.
    EXPECT_NE(svg.find("points=\"78.00,226.00 598.00,262.00 \""), std::string::npos) << svg;
    EXPECT_NE(svg.find("n &lt; 2 &amp; more"), std::string::npos);
}

TEST(Svg, SetsLettersBelowTheLine) {
    PlotPanel p = panel();
    p.x.label = "n_d";
    p.y.label = "(n_F − n_C) < 1";
    p.marks.push_back({{550.0, 1.7}, "glass_2 n_red _x", "#000"});
    const std::string svg = svg_of({&p, 1});
    const std::string below = "<tspan dy=\"4\" font-size=\"10\">";
    EXPECT_NE(svg.find(">n" + below + "d</tspan></text>"), std::string::npos) << svg;
    EXPECT_NE(svg.find(">(n" + below +
                       "F</tspan><tspan dy=\"-4\" xml:space=\"preserve\"> − n</tspan>" + below +
                       "C</tspan><tspan dy=\"-4\" xml:space=\"preserve\">) &lt; 1</tspan></text>"),
              std::string::npos)
        << svg;
    EXPECT_NE(svg.find(">glass_2 n_red _x<"), std::string::npos) << svg;
}

TEST(Svg, TurnsAnAxisRound) {
    PlotPanel p = panel();
    std::swap(p.x.from, p.x.to);
    EXPECT_NE(svg_of({&p, 1}).find("points=\"598.00,226.00 78.00,262.00 \""), std::string::npos);
}

/// Labels of marks that lie on top of each other stand at different places.
TEST(Svg, KeepsLabelsApart) {
    PlotPanel p = panel();
    for (int i = 0; i < 6; ++i) p.marks.push_back({{550.0, 1.7}, "label", "#000"});
    const std::string svg = svg_of({&p, 1});
    std::vector<std::string> places;
    for (std::size_t at = svg.find(">label<"); at != std::string::npos;
         at = svg.find(">label<", at + 1))
        places.push_back(svg.substr(svg.rfind("<text", at), at - svg.rfind("<text", at)));
    ASSERT_EQ(places.size(), 6u);
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_NE(places[i], places[j]);
}

/// Labels of curves that end near each other stand in lines of their own, in the curves' order.
TEST(Svg, KeepsLabelsOfCurvesInOrder) {
    PlotPanel p = panel();
    for (const char* label : {"first", "second", "third"})
        p.curves.push_back({label, "#000", {{400.0, 1.5}, {700.0, 1.4 - 0.001 * label[0]}}, false});
    const std::string svg = svg_of({&p, 1});
    const auto y_of = [&](const char* label) {
        const std::size_t at = svg.find(std::string(">") + label + "<");
        const std::size_t y = svg.rfind(" y=\"", at) + 4;
        return std::stod(svg.substr(y, svg.find('"', y) - y));
    };
    // f, s, t: each a little lower than the one before.
    EXPECT_GE(y_of("second") - y_of("first"), 14.9);
    EXPECT_GE(y_of("third") - y_of("second"), 14.9);
}

TEST(DecadeTicks, ArePowersOfTen) {
    const auto expect = [](std::vector<double> ticks, std::vector<double> expected) {
        ASSERT_EQ(ticks.size(), expected.size());
        for (std::size_t i = 0; i < ticks.size(); ++i)
            EXPECT_NEAR(ticks[i], expected[i], 1e-12 * expected[i]);
    };
    expect(decade_ticks(1e-3, 1.0), {1e-3, 1e-2, 1e-1, 1.0});
    expect(decade_ticks(0.5, 30.0), {1.0, 10.0});
    expect(decade_ticks(1.5, 9.0), {2.0, 5.0});
    EXPECT_LE(decade_ticks(1e-20, 1e20).size(), 13u);
}

TEST(Svg, HasLogarithmicAxes) {
    PlotPanel p = panel();
    p.y = {"P", 1e-2, 1.0, true};
    p.curves[0].points = {{400.0, 0.1}, {700.0, 1.0}};
    const std::string svg = svg_of({&p, 1});
    EXPECT_NE(svg.find("points=\"78.00,226.00 598.00,46.00 \""), std::string::npos) << svg;
    EXPECT_NE(svg.find(">10⁻²<"), std::string::npos);
}

/// What is not a number leaves a gap, and what lies on a line takes no room.
TEST(Svg, LeavesGapsAndDropsWhatNobodyWouldMiss) {
    PlotPanel p = panel();
    p.curves[0].points.clear();
    for (int i = 0; i <= 300; ++i) p.curves[0].points.push_back({400.0 + i, i == 100 ? NAN : 1.5});
    const std::string svg = svg_of({&p, 1});
    EXPECT_NE(svg.find("points=\"78.00,226.00 249.60,226.00 \""), std::string::npos) << svg;
    EXPECT_NE(svg.find("points=\"253.07,226.00 598.00,226.00 \""), std::string::npos) << svg;
}

TEST(Svg, PutsPanelsInRows) {
    const std::vector<PlotPanel> panels(5, panel());
    const std::string svg = svg_of(panels, 2);
    EXPECT_NE(svg.find("width=\"1240\" height=\"1410\""), std::string::npos) << svg.substr(0, 99);
    EXPECT_NE(svg.find("translate(0 940)"), std::string::npos);
    EXPECT_NE(svg_of(panels).find("width=\"3100\" height=\"470\""), std::string::npos);
}

/// By the test vectors of RFC 4648, section 10.
TEST(Svg, HoldsPictures) {
    const auto holds = [](const std::string& bytes, const std::string& base64) {
        PlotPanel p = panel();
        p.picture = PlotPicture{bytes, 400.0, 700.0, 1.0, 2.0};
        return svg_of({&p, 1}).find("base64," + base64 + "\"") != std::string::npos;
    };
    EXPECT_TRUE(holds("foobar", "Zm9vYmFy"));
    EXPECT_TRUE(holds("fooba", "Zm9vYmE="));
    EXPECT_TRUE(holds("foob", "Zm9vYg=="));
}

}  // namespace
}  // namespace dewbow
