// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/ies/ies.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "dewbow/import/ies/ies_text.h"

namespace dewbow {
namespace {

using ies::Text;

/// More than any goniophotometer steps through; intensities are bounded by the bytes of the file.
constexpr int kMaxAngles = 1'000'000;
constexpr Range kPositive{0.0, kHuge, true};
constexpr Range kVerticalRange{0.0, 180.0};
constexpr Range kHorizontalRange{0.0, 360.0};

struct Version {
    std::string_view first_line;
    bool has_ballast_lamp_factor;
};
constexpr std::array kVersions{Version{"IESNA91", true}, Version{"IESNA:LM-63-1995", true},
                               Version{"IESNA:LM-63-2002", false},
                               Version{"IES:LM-63-2019", false}};
constexpr std::string_view kOldestVersion = "LM-63-1986";
constexpr std::string_view kTilt = "TILT=";

void note(IesFile& ies, const Text& text, std::string sentence) {
    ies.diagnostics.push_back({text.place(), std::move(sentence)});
}

bool has_ballast_lamp_factor(std::string_view version) {
    const auto known = std::find_if(kVersions.begin(), kVersions.end(),
                                    [&](const Version& row) { return row.first_line == version; });
    return known != kVersions.end() ? known->has_ballast_lamp_factor : version == kOldestVersion;
}

void read_version(std::string_view first_line, const Text& text, IesFile& ies) {
    if (!first_line.starts_with("IES")) {
        ies.version = kOldestVersion;
        return;
    }
    ies.version = first_line;
    for (const Version& row : kVersions) {
        if (row.first_line == first_line) return;
    }
    note(ies, text,
         fmt::format("version \"{}\" is not known; it is read as LM-63-2002", first_line));
}

/// Reads up to the TILT line, and returns what that says.
std::string_view read_labels(Text& text, IesFile& ies) {
    bool first = true;
    while (const auto line = text.next_line()) {
        if (line->starts_with(kTilt)) {
            if (first) ies.version = kOldestVersion;
            return line->substr(kTilt.size());
        }
        if (first) read_version(*line, text, ies);
        first = false;
    }
    text.fail("there is no line that begins with TILT=: this is no IESNA LM-63 file");
}

/// The table scales the light of a lamp that burns in another position than in the test. Here no
/// luminaire does.
void read_tilt(std::string_view tilt, Text& text, IesFile& ies) {
    if (tilt == "NONE") return;
    if (tilt.empty()) text.fail("TILT= names nothing; expected NONE, INCLUDE or a file");
    note(ies, text, fmt::format("TILT={} is not used: the lamp burns as in the test", tilt));
    if (tilt != "INCLUDE") return;
    text.whole_number("the lamp-to-luminaire geometry", 1, 3);
    const auto pairs = std::size_t(text.whole_number("the number of tilt angles", 1, kMaxAngles));
    text.ascending_numbers("tilt angle", pairs, kVerticalRange);
    text.numbers("tilt factor", pairs, kAmountRange);
}

void check_type(Text& text) {
    constexpr const char* kRotated = "only type C, angles about the vertical axis, is read";
    const int type = text.whole_number("the photometric type", 1, 3);
    if (type == 2) text.fail("the photometry is of type B, as for floodlights", kRotated);
    if (type == 3) text.fail("the photometry is of type A, as for headlamps", kRotated);
}

/// Lumens per lamp; -1 says that the candela are absolute.
std::optional<double> read_lumens(Text& text) {
    constexpr double kAbsolutePhotometry = -1.0;
    const double lumens = text.number("the lumens per lamp", {kAbsolutePhotometry, kHuge});
    if (lumens == kAbsolutePhotometry) return std::nullopt;
    if (lumens >= 0.0) return lumens;
    text.fail(
        fmt::format("the lumens per lamp are {}; they must not be negative, or -1 for "
                    "absolute photometry",
                    lumens));
}

struct Counts {
    std::size_t vertical, horizontal;
};

/// The ten numbers of the luminaire and the three of its ballast.
Counts read_facts(Text& text, IesFile& ies) {
    ies.lamps = text.whole_number("the number of lamps", 1, kMaxAngles);
    ies.lumens_per_lamp = read_lumens(text);
    ies.multiplier = text.number("the multiplier", kPositive);
    const int vertical = text.whole_number("the number of vertical angles", 2, kMaxAngles);
    const int horizontal = text.whole_number("the number of horizontal angles", 1, kMaxAngles);
    check_type(text);
    text.whole_number("the type of units", 1, 2);
    // Negative sizes say that the luminous opening is round.
    for (const char* size : {"the width", "the length", "the height"}) {
        text.number(size, kCoordinateRange);
    }
    ies.ballast_factor = text.number("the ballast factor", kPositive);
    const double next = text.number("the ballast-lamp factor", kAmountRange);
    if (has_ballast_lamp_factor(ies.version)) {
        if (next == 0.0) text.fail("the ballast-lamp factor is 0; it must be greater than 0");
        ies.ballast_lamp_factor = next;
    }
    text.number("the input watts", kAmountRange);
    return {std::size_t(vertical), std::size_t(horizontal)};
}

IesSymmetry symmetry_of(const std::vector<double>& horizontal_deg, const Text& text) {
    const double first = horizontal_deg.front(), last = horizontal_deg.back();
    if (horizontal_deg.size() == 1) return IesSymmetry::axial;
    if (first == 90.0 && last == 270.0) return IesSymmetry::bilateral_90;
    if (first == 0.0 && last == 90.0) return IesSymmetry::quadrant;
    if (first == 0.0 && last == 180.0) return IesSymmetry::bilateral;
    if (first == 0.0 && last > 180.0) return IesSymmetry::none;
    text.fail(fmt::format("horizontal angles go from {} to {} deg", first, last),
              "they go from 0 to 0, 90, 180 or 360 deg, or from 90 to 270 deg");
}

/// A horizontal angle of the whole circle, and the row of the file that holds there.
struct Row {
    double phi_deg;
    std::size_t source;
};

/// Continues `rows`, which begin at 0 deg, by their mirror image behind their last one.
void mirror_at_last(std::vector<Row>& rows) {
    const double last = rows.back().phi_deg;
    for (std::size_t i = rows.size() - 1; i-- > 0;) {
        rows.push_back({2.0 * last - rows[i].phi_deg, rows[i].source});
    }
}

/// 90 to 270 deg: what is there from 180 deg on, seen in the mirror that stands along 90–270 deg.
std::vector<Row> unfolded_at_90(const std::vector<Row>& rows, const Text& text) {
    const auto middle =
        std::find_if(rows.begin(), rows.end(), [](const Row& row) { return row.phi_deg == 180.0; });
    if (middle == rows.end()) text.fail("horizontal angles from 90 to 270 deg must include 180");
    std::vector<Row> circle;
    for (auto row = middle; row > rows.begin(); --row) {
        circle.push_back({180.0 - row->phi_deg, row->source});
    }
    circle.insert(circle.end(), rows.begin(), rows.end());
    for (auto row = rows.end() - 2; row >= middle; --row) {
        circle.push_back({540.0 - row->phi_deg, row->source});
    }
    return circle;
}

std::vector<Row> circle_of(const std::vector<double>& horizontal_deg, const Text& text,
                           IesFile& ies) {
    std::vector<Row> rows;
    for (double phi_deg : horizontal_deg) rows.push_back({phi_deg, rows.size()});
    switch (ies.symmetry) {
        case IesSymmetry::axial:
            return {{0.0, 0}};
        case IesSymmetry::bilateral_90:
            return unfolded_at_90(rows, text);
        case IesSymmetry::quadrant:
            mirror_at_last(rows);
            [[fallthrough]];
        case IesSymmetry::bilateral:
            mirror_at_last(rows);
            return rows;
        case IesSymmetry::none:
            break;
    }
    if (rows.back().phi_deg == 360.0) {
        rows.back().source = 0;
    } else {
        note(ies, text,
             fmt::format("horizontal angles end at {} deg; those of 0 are repeated at "
                         "360",
                         rows.back().phi_deg));
        rows.push_back({360.0, 0});
    }
    return rows;
}

/// The rows at 0 and 360 deg say the same of the same direction, or should.
void compare_ends(const std::vector<double>& horizontal_deg, const std::vector<double>& candela,
                  std::size_t vertical, const Text& text, IesFile& ies) {
    if (ies.symmetry != IesSymmetry::none || horizontal_deg.back() != 360.0) return;
    const auto columns = std::ptrdiff_t(vertical);
    if (!std::equal(candela.begin(), candela.begin() + columns, candela.end() - columns)) {
        note(ies, text, "intensities at 0 and at 360 deg differ; those at 0 are used");
    }
}

std::shared_ptr<const PhotometricWeb> read_web(const Counts& counts, Text& text, IesFile& ies) {
    PhotometricTable table;
    table.vertical_deg = text.ascending_numbers("vertical angle", counts.vertical, kVerticalRange);
    const std::vector<double> horizontal_deg =
        text.ascending_numbers("horizontal angle", counts.horizontal, kHorizontalRange);
    ies.symmetry = symmetry_of(horizontal_deg, text);
    const std::vector<Row> circle = circle_of(horizontal_deg, text, ies);

    const std::vector<double> candela =
        text.numbers("intensity", counts.vertical * counts.horizontal, kAmountRange);
    compare_ends(horizontal_deg, candela, counts.vertical, text, ies);
    if (std::all_of(candela.begin(), candela.end(), [](double cd) { return cd == 0.0; })) {
        text.fail("all intensities are 0");
    }
    text.expect_end();

    const double factor = ies.multiplier * ies.ballast_factor * ies.ballast_lamp_factor;
    table.intensity_cd.reserve(circle.size() * counts.vertical);
    for (const Row& row : circle) {
        table.horizontal_deg.push_back(row.phi_deg);
        for (std::size_t v = 0; v < counts.vertical; ++v) {
            table.intensity_cd.push_back(factor * candela[row.source * counts.vertical + v]);
        }
    }
    return std::make_shared<const PhotometricWeb>(std::move(table));
}

}  // namespace

IesFile parse_ies(const std::string& file, std::string_view bytes) {
    Text text(file, bytes);
    IesFile ies;
    read_tilt(read_labels(text, ies), text, ies);
    const Counts counts = read_facts(text, ies);
    ies.web = read_web(counts, text, ies);
    return ies;
}

}  // namespace dewbow
