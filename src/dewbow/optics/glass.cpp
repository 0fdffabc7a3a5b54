// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/glass.h"

#include <fmt/format.h>

#include <numbers>

namespace dewbow {

std::optional<std::string> range_warning(const Glass& glass) {
    const double from = glass.lambda_min_nm, to = glass.lambda_max_nm;
    if (to == 0.0) return glass.name + ": it does not say of which wavelengths its data are";
    const auto span = [](double a, double b) { return fmt::format("{:.4g} to {:.4g} nm", a, b); };
    std::string missing;
    if (from > kLambdaMin_nm) missing = span(kLambdaMin_nm, std::min(from, kLambdaMax_nm));
    const bool two = !missing.empty() && to < kLambdaMax_nm;
    if (two) missing += " and ";
    if (to < kLambdaMax_nm) missing += span(std::max(to, kLambdaMin_nm), kLambdaMax_nm);
    if (missing.empty()) return std::nullopt;
    return fmt::format("{}: data of {}; {} {} extrapolated", glass.name, span(from, to), missing,
                       two ? "are" : "is");
}

std::optional<std::string> birefringence_note(const Glass& glass) {
    if (!glass.birefringent) return std::nullopt;
    return fmt::format(
        "{} is birefringent: its {} ray is followed alone, and nothing is seen double", glass.name,
        glass.extraordinary ? "extraordinary" : "ordinary");
}

SpectrumPtr absorption_of(const Glass& glass) {
    if (glass.k.empty()) return nullptr;
    std::vector<double> lambda_nm, per_m;
    for (const Extinction& at : glass.k) {
        lambda_nm.push_back(at.lambda_nm);
        per_m.push_back(4.0 * std::numbers::pi * at.k / (1e-9 * at.lambda_nm));
    }
    return make_tabulated(std::move(lambda_nm), std::move(per_m), OutsideTable::hold);
}

}  // namespace dewbow
