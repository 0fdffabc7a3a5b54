// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/paper/errata.h"

#include <fmt/format.h>

#include "dewbow/rainbow/paper/errata_parts.h"

namespace dewbow {

std::vector<Erratum> paper_errata() {
    using namespace errata;
    return {ring_index(),       cauchy_fit(),     air_counted_twice(),
            geometry(),         ray_weights(),    kernel_of_the_sun(),
            thirteen_samples(), beyond_the_fit(), fog_and_order()};
}

std::string csv_of(const std::vector<Erratum>& errata) {
    std::string text = "erratum,quantity,unit,as published,right\n";
    for (const Erratum& erratum : errata)
        for (const ErratumRow& row : erratum.rows)
            text += fmt::format("{},\"{}\",{},{:.6g},{:.6g}\n", erratum.name, row.quantity,
                                row.unit, row.as_published, row.right);
    return text;
}

}  // namespace dewbow
