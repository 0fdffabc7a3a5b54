// SPDX-License-Identifier: Apache-2.0
#pragma once

// For writers of a new kind of spectrum: one formula gives both forms of evaluation.

#include "dewbow/base/check.h"
#include "dewbow/spectrum/spectrum.h"

namespace dewbow {

/// A spectrum whose class `Kind` has `double value_at(double lambda_nm) const`: lanes then cost one
/// virtual call together, and give bit for bit what single wavelengths give.
template <class Kind>
class Lanewise : public Spectrum {
public:
    void eval_lanes(std::span<const double> lambda_nm, std::span<double> out) const final {
        DEWBOW_CHECK(lambda_nm.size() == out.size(), "one value for each wavelength");
        const Kind& kind = static_cast<const Kind&>(*this);
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = kind.value_at(lambda_nm[i]);
    }

protected:
    double eval(double lambda_nm) const final {
        return static_cast<const Kind&>(*this).value_at(lambda_nm);
    }
};

}  // namespace dewbow
