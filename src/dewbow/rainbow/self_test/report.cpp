// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "dewbow/rainbow/self_test/comparison.h"

namespace dewbow {

std::vector<SelfTestRow> run_self_test() {
    using namespace self_test;
    Rows rows;
    for (const auto check : {check_miev0, check_bohren_huffman, check_50_digits, check_conservation,
                             check_debye, check_uniform_airy, check_descartes_rays})
        check(rows);
    return rows;
}

std::string self_test_report(std::span<const SelfTestRow> rows) {
    std::string text;
    std::size_t agree = 0;
    const std::string* source = nullptr;
    for (const SelfTestRow& row : rows) {
        if (source == nullptr || *source != row.source) {
            text += fmt::format("{}{}\n  {:60}{:>16}{:>16}{:>9}{:>9}\n", source ? "\n" : "",
                                row.source, "", "expected", "computed", "error", "allowed");
            source = &row.source;
        }
        text +=
            fmt::format("  {:60}{:>16.9g}{:>16.9g}{:>9.1e}{:>9.1e}{}\n", row.quantity, row.expected,
                        row.computed, row.error, row.allowed, row.ok() ? "" : "  WRONG");
        agree += row.ok();
    }
    return text + fmt::format("\n{} of {} agree.\n", agree, rows.size());
}

}  // namespace dewbow
