// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/paper_index.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "dewbow/base/error.h"
#include "dewbow/optics/dispersion/formula.h"
#include "dewbow/optics/equivalents.h"

namespace dewbow {
namespace {

/// What is nearer to air than this bends no ray of the paper's.
constexpr double kGas = 1e-3;

double index_against_air(const Dispersion& dispersion, Wavelength lambda) {
    return (dispersion(lambda) / (*air())(lambda)).value;
}

/// c + s x with x = 1/λ or λ, in µm.
struct StraightLine {
    double c = 1.0, s = 0.0;
    SpectralSpacing spacing = SpectralSpacing::frequency;

    StraightLine(const LinearIndex& index, SpectralSpacing over) : spacing(over) {
        const double red_um = 1e-3 * kPaperRed.to(unit::nm);
        const double violet_um = 1e-3 * kPaperViolet.to(unit::nm);
        const double red = over == SpectralSpacing::frequency ? 1.0 / red_um : red_um;
        const double violet = over == SpectralSpacing::frequency ? 1.0 / violet_um : violet_um;
        s = index.slope / (violet - red);
        c = index.at_red - s * red;
    }
    template <class V>
    V index(V lambda_um) const {
        return c + s * (spacing == SpectralSpacing::frequency ? 1.0 / lambda_um : lambda_um);
    }
    bool is_constant() const { return false; }
};

/// A line that is against air at vacuum wavelengths.
class PaperIndex final : public Dispersion {
public:
    explicit PaperIndex(DispersionPtr line) : line_(std::move(line)), air_(air()) {}

    void eval_lanes(std::span<const double> lambda_nm, std::span<double> n_out) const override {
        constexpr std::size_t kBlock = 16;
        line_->eval_lanes(lambda_nm, n_out);
        for (std::size_t first = 0; first < n_out.size(); first += kBlock) {
            const std::size_t count = std::min(kBlock, n_out.size() - first);
            std::array<double, kBlock> n_air;
            air_->eval_lanes(lambda_nm.subspan(first, count), {n_air.data(), count});
            for (std::size_t i = 0; i < count; ++i) n_out[first + i] *= n_air[i];
        }
    }

protected:
    double eval(double lambda_nm) const override {
        return (*line_)(lambda_nm * unit::nm).value * (*air_)(lambda_nm * unit::nm).value;
    }

private:
    DispersionPtr line_, air_;
};

double exact_slope(double eta_red, double w, SpectralSpacing spacing) {
    const double f_C = paper_coordinate(kLineC, spacing);
    const double f_D = paper_coordinate(kLineD, spacing);
    const double f_F = paper_coordinate(kLineF, spacing);
    const double share = f_F - f_C;
    if (!(w * f_D < share))
        throw InputError(
            fmt::format(
                "w is {:g}; a straight line has that dispersive power below w = {:.3f} only", w,
                share / f_D),
            "the reading \"intended\" takes any w");
    return w * (eta_red - 1.0) / (share - w * f_D);
}

}  // namespace

const std::vector<std::string>& index_reading_names() {
    static const std::vector<std::string> kNames{"printed", "intended", "exact"};
    return kNames;
}

LinearIndex linear_index(double eta_red, double w, IndexReading reading, SpectralSpacing spacing) {
    switch (reading) {
        case IndexReading::printed:
            return {0.0, (w * (eta_red - 1.0) - eta_red) / kPaperShare};
        case IndexReading::intended:
            return {eta_red, w * (eta_red - 1.0) / kPaperShare};
        case IndexReading::exact:
            break;
    }
    return {eta_red, exact_slope(eta_red, w, spacing)};
}

DispersionPtr paper_index(double eta_red, double w, IndexReading reading, SpectralSpacing spacing) {
    if (reading == IndexReading::printed)
        throw InputError(
            fmt::format("eq. 9 as printed gives no index of a medium: {:.3g} at the far violet for "
                        "eta_red {:g} and w {:g}",
                        linear_index(eta_red, w, reading, spacing).at(1.0), eta_red, w),
            "use the reading \"intended\" or \"exact\"");
    const LinearIndex line = linear_index(eta_red, w, reading, spacing);
    if (eta_red == 1.0) return air();
    if (line.slope == 0.0) return make_dispersion({"constant", {eta_red}, IndexReference::air});
    constexpr DataRange kPaperRange{kPaperViolet.to(unit::nm), kPaperRed.to(unit::nm)};
    return std::make_shared<const PaperIndex>(
        dispersion::checked("eta_red and w", StraightLine(line, spacing), kPaperRange));
}

bool disperses_in_air(const DispersionPtr& dispersion) {
    return !dispersion->is_constant() &&
           std::abs(index_against_air(*dispersion, kLineD) - 1.0) >= kGas;
}

DispersionPtr paper_index_of(const DispersionPtr& real, IndexReading reading,
                             SpectralSpacing spacing) {
    if (!disperses_in_air(real) || std::dynamic_pointer_cast<const PaperIndex>(real)) return real;
    return paper_index(index_against_air(*real, kPaperRed), dispersive_power(index_in_air(real)),
                       reading, spacing);
}

}  // namespace dewbow
