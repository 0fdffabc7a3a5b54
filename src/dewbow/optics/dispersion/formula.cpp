// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/dispersion/formula.h"

#include <fmt/format.h>

#include "dewbow/base/error.h"

namespace dewbow::dispersion {

void refuse_index(const std::string& form, double lambda_nm, double n) {
    throw InputError(
        fmt::format("{}: the index of refraction at {} nm is {:.6g}; expected {} to {}", form,
                    lambda_nm, n, kLeastIndex, kMostIndex));
}

DataRange range_of(const DispersionData& data) {
    if (!data.range) return {kLambdaMin_nm, kLambdaMax_nm};
    const DataRange& range = *data.range;
    if (!(range.min_nm > 0.0 && range.max_nm >= range.min_nm && std::isfinite(range.max_nm)))
        throw InputError(fmt::format("{}: the range is {} to {} nm; expected rising wavelengths",
                                     data.form, range.min_nm, range.max_nm));
    return range;
}

Coefficients padded(const Coefficients& coefficients, std::size_t count) {
    Coefficients result = coefficients;
    result.resize(count, 0.0);
    return result;
}

}  // namespace dewbow::dispersion
