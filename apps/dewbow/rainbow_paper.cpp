// SPDX-License-Identifier: Apache-2.0
#include "rainbow_paper.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "dewbow/rainbow/paper/errata.h"
#include "dewbow/rainbow/paper/fog_table.h"

namespace dewbow {

std::string paper_text() {
    std::string text;
    for (const Erratum& erratum : paper_errata()) {
        text += fmt::format("{}  {}\n     the paper: {}\n     right: {}\n", erratum.name,
                            erratum.subject, erratum.paper_says, erratum.right);
        text += fmt::format("     {:>12} {:>12}\n", "as published", "right");
        for (const ErratumRow& row : erratum.rows)
            text += fmt::format("     {:>12.5g} {:>12.5g}  {}{}\n", row.as_published, row.right,
                                row.quantity, row.unit.empty() ? "" : " (" + row.unit + ")");
        text += "\n";
    }
    return text;
}

std::string paper_json() {
    using Json = nlohmann::ordered_json;
    Json errata = Json::array();
    for (const Erratum& erratum : paper_errata()) {
        Json rows = Json::array();
        for (const ErratumRow& row : erratum.rows)
            rows.push_back({{"quantity", row.quantity},
                            {"unit", row.unit},
                            {"as_published", row.as_published},
                            {"right", row.right}});
        errata.push_back({{"erratum", erratum.name},
                          {"subject", erratum.subject},
                          {"paper_says", erratum.paper_says},
                          {"right", erratum.right},
                          {"sizes", std::move(rows)}});
    }
    return Json{{"version", DEWBOW_VERSION}, {"errata", std::move(errata)}}.dump() + "\n";
}

std::string paper_csv() {
    const FogTable published = make_fog_table({}),
                   corrected = make_fog_table(paper_method_corrected());
    std::string text =
        "# fogs of Musgrave 1989, 4.3.2: transmittances, 1 where the bow is brightest\n"
        "angle from the antisolar point (deg),red as published,green as published,"
        "blue as published,red corrected,green corrected,blue corrected\n";
    for (std::size_t k = 0; k < published.transmittance.size(); ++k) {
        text += fmt::format("{:.2f}", (double(k) + 0.5) * kPaperBucket.to(unit::deg));
        for (const FogTable* table : {&published, &corrected})
            for (double t : table->transmittance[k].v) text += fmt::format(",{:.7g}", t);
        text += "\n";
    }
    return text;
}

}  // namespace dewbow
