// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "dewbow/rainbow/self_test.h"

namespace dewbow {

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
