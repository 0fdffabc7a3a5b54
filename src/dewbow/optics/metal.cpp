// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/metal.h"

#include <vector>

#include "dewbow/base/named.h"
#include "dewbow/optics/embedded_data.h"
#include "dewbow/spectrum/csv_table.h"

namespace dewbow {
namespace {

constexpr std::string_view kHeader = "name,symbol,description,lambda_nm,n,k,source,licence";
enum Column { kName, kSymbol, kDescription, kLambda, kN, kK, kSource, kLicence };

std::vector<Metal> load_metals() {
    std::vector<Metal> metals;
    for (const auto& row : rows_of_csv(optics::data::metals_csv(), kHeader)) {
        const std::vector<double> lambda_nm = numbers_of_field(row[kLambda]);
        const auto tabulated = [&](Column column) {
            return make_tabulated(lambda_nm, numbers_of_field(row[column]), OutsideTable::hold);
        };
        metals.push_back({row[kName], row[kSymbol], row[kDescription], row[kSource], row[kLicence],
                          lambda_nm.front(), lambda_nm.back(), tabulated(kN), tabulated(kK)});
    }
    return metals;
}

/// What find_metal knows: each metal by its name, and by its symbol if it has one.
struct KnownNames {
    std::vector<std::string> names;
    std::vector<const Metal*> metals;  ///< [name]

    void add(std::string name, const Metal& metal) {
        names.push_back(std::move(name));
        metals.push_back(&metal);
    }
};

KnownNames names_and_symbols() {
    KnownNames known;
    for (const Metal& metal : metal_catalogue()) known.add(metal.name, metal);
    for (const Metal& metal : metal_catalogue()) {
        if (!metal.symbol.empty()) known.add("metal/" + metal.symbol, metal);
    }
    return known;
}

}  // namespace

std::span<const Metal> metal_catalogue() {
    static const std::vector<Metal> kMetals = load_metals();
    return kMetals;
}

const Metal& find_metal(std::string_view name) {
    static const KnownNames kKnown = names_and_symbols();
    return *kKnown.metals[find_named("metal", name, kKnown.names)];
}

}  // namespace dewbow
