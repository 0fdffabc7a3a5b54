// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the paper's rainbow gets wrong, measured: each erratum as numbers and curves, as published
// beside what is right. The numbering is that of docs/rainbow-errata.md.

#include <string>
#include <vector>

namespace dewbow {

struct ErratumRow {
    std::string quantity, unit;  ///< no unit: a ratio
    double as_published = 0.0, right = 0.0;
};

struct ErratumCurve {
    std::string label;
    std::vector<double> x, y;  ///< y not finite: a gap
    bool as_published = false;
};

struct Erratum {
    std::string name;        ///< "E13"
    std::string subject;     ///< a few words
    std::string paper_says;  ///< and what is meant by `as_published`
    std::string right;
    std::vector<ErratumRow> rows;
    std::string x_label, y_label;
    bool logarithmic = false;  ///< y is to be shown so
    std::vector<ErratumCurve> curves;
};

/// E11 to E17, E22 and E23. Takes about a second.
std::vector<Erratum> paper_errata();

/// As comma-separated values with a header: erratum, quantity, unit, as published, right.
std::string csv_of(const std::vector<Erratum>& errata);

}  // namespace dewbow
