// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/dispersion.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "dewbow/base/check.h"
#include "dewbow/base/error.h"

namespace dewbow {
namespace {

/// An index that was measured against air at wavelengths in air.
class AgainstAir final : public Dispersion {
public:
    explicit AgainstAir(DispersionPtr relative) : relative_(std::move(relative)), air_(air()) {}

    void eval_lanes(std::span<const double> lambda_nm, std::span<double> n_out) const override {
        DEWBOW_CHECK(n_out.size() == lambda_nm.size(), "one index for each wavelength");
        constexpr std::size_t kBlock = 16;
        for (std::size_t first = 0; first < lambda_nm.size(); first += kBlock) {
            const std::size_t count = std::min(kBlock, lambda_nm.size() - first);
            std::array<double, kBlock> n_air, lambda_air_nm;
            air_->eval_lanes(lambda_nm.subspan(first, count), {n_air.data(), count});
            for (std::size_t i = 0; i < count; ++i)
                lambda_air_nm[i] = lambda_nm[first + i] / n_air[i];
            relative_->eval_lanes({lambda_air_nm.data(), count}, n_out.subspan(first, count));
            for (std::size_t i = 0; i < count; ++i) n_out[first + i] *= n_air[i];
        }
    }

protected:
    double eval(double lambda_nm) const override {
        const double n_air = (*air_)(lambda_nm * unit::nm).value;
        return (*relative_)(lambda_nm / n_air * unit::nm).value * n_air;
    }

private:
    DispersionPtr relative_, air_;
};

DispersionPtr against_air(DispersionPtr relative) {
    if (!relative->is_constant()) return std::make_shared<const AgainstAir>(std::move(relative));
    return make_dispersion(
        {"constant", {(*relative)(kLined).value * (*air())(kLined).value}, IndexReference::vacuum});
}

// ---- coefficients ----

const DispersionForm& form_named(const std::string& name) {
    for (const DispersionForm& form : dispersion_forms())
        if (form.name == name) return form;
    std::vector<std::string> names;
    for (const DispersionForm& form : dispersion_forms()) names.push_back(form.name);
    throw InputError(fmt::format("unknown dispersion formula \"{}\"", name), hint_for(name, names));
}

std::string expected_count(const DispersionForm& form) {
    if (form.least_coefficients == form.most_coefficients)
        return fmt::format("{}", form.least_coefficients);
    return fmt::format("{} to {}", form.least_coefficients, form.most_coefficients);
}

/// `data` without the zeros that glass files fill their lines up with.
DispersionData checked_data(const DispersionForm& form, DispersionData data) {
    std::vector<double>& c = data.coefficients;
    const std::size_t given = c.size();
    while (c.size() > form.most_coefficients && c.back() == 0.0) c.pop_back();
    if (c.size() < form.least_coefficients || c.size() > form.most_coefficients)
        throw InputError(
            fmt::format("{}: {} coefficients; expected {}", form.name, given, expected_count(form)),
            form.formula);
    for (const double value : c)
        if (!std::isfinite(value))
            throw InputError(
                fmt::format("{}: coefficient {}; expected a finite number", form.name, value));
    return data;
}

}  // namespace

void Dispersion::eval_lanes(std::span<const double> lambda_nm, std::span<double> n_out) const {
    DEWBOW_CHECK(n_out.size() == lambda_nm.size(), "one index for each wavelength");
    for (std::size_t i = 0; i < lambda_nm.size(); ++i) n_out[i] = eval(lambda_nm[i]);
}

DispersionPtr make_dispersion(const DispersionData& data) {
    const DispersionForm& form = form_named(data.form);
    DispersionPtr dispersion = form.make(checked_data(form, data));
    return data.reference == IndexReference::air ? against_air(std::move(dispersion)) : dispersion;
}

DispersionPtr vacuum() {
    static const DispersionPtr nothing =
        make_dispersion({"constant", {1.0}, IndexReference::vacuum});
    return nothing;
}

DispersionPtr medium_of(IndexReference reference) {
    return reference == IndexReference::air ? air() : vacuum();
}

double abbe_number(const Dispersion& dispersion, const Dispersion& medium) {
    const auto relative = [&](Wavelength lambda) {
        return dispersion(lambda).value / medium(lambda).value;
    };
    const double spread = relative(kLineF) - relative(kLineC);
    if (spread == 0.0) return std::numeric_limits<double>::infinity();
    return (relative(kLined) - 1.0) / spread;
}

}  // namespace dewbow
