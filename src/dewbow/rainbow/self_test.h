// SPDX-License-Identifier: Apache-2.0
#pragma once

// The models against answers that others have published, against arithmetic with 50 digits, and
// against each other: what `dewbow rainbow --self-test` prints, in the manner of Wiscombe's MIEV0.

#include <span>
#include <string>
#include <vector>

namespace dewbow {

struct SelfTestRow {
    std::string source;    ///< of what is expected; rows of one source stand together
    std::string quantity;  ///< "case 7, x = 10, m = 0.75: Q_ext"
    double expected = 0.0, computed = 0.0;
    double error = 0.0;    ///< relative, unless the quantity says otherwise
    double allowed = 0.0;  ///< of the error: what the printed digits and the two methods leave
    bool ok() const { return error <= allowed; }  // false for NaN
};

/// All comparisons, in about a second. Where a quantity has many values (amplitudes at many
/// angles), its row shows the one with the largest error.
std::vector<SelfTestRow> run_self_test();

/// As a table of text, a heading for each source and a last line that says how many agree.
std::string self_test_report(std::span<const SelfTestRow> rows);

}  // namespace dewbow
