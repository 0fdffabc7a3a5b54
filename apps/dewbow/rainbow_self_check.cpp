// SPDX-License-Identifier: Apache-2.0
#include "rainbow_self_check.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "command.h"
#include "console.h"
#include "dewbow/rainbow/self_test.h"

namespace dewbow {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::string json_of(const std::vector<SelfTestRow>& rows) {
    Json list = Json::array();
    for (const SelfTestRow& row : rows)
        list.push_back({{"source", row.source},
                        {"quantity", row.quantity},
                        {"expected", number(row.expected)},
                        {"computed", number(row.computed)},
                        {"error", number(row.error)},
                        {"allowed", number(row.allowed)},
                        {"ok", row.ok()}});
    return list.dump() + "\n";
}

}  // namespace

int run_rainbow_self_check(bool json) {
    const std::vector<SelfTestRow> rows = run_self_test();
    print_data(json ? json_of(rows) : self_test_report(rows));
    const bool all =
        std::all_of(rows.begin(), rows.end(), [](const auto& row) { return row.ok(); });
    return all ? kDone : kFailed;
}

}  // namespace dewbow
