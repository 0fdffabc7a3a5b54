// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/spectrum.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dewbow/base/check.h"
#include "dewbow/base/error.h"
#include "dewbow/spectrum/lanewise.h"

namespace dewbow {

void Spectrum::eval_lanes(std::span<const double> lambda_nm, std::span<double> out) const {
    DEWBOW_CHECK(lambda_nm.size() == out.size(), "one value for each wavelength");
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = eval(lambda_nm[i]);
}

namespace {

/// Steps of a table may differ from each other by this part of a step and still count as equal: far
/// above rounding (1e-13 for wavelengths of 1e3 nm), far below what moves an interpolated value.
constexpr double kRegularStepTolerance = 1e-9;

class ConstantSpectrum final : public Lanewise<ConstantSpectrum> {
public:
    explicit ConstantSpectrum(double value) : value_(value) {}
    double value_at(double) const { return value_; }
    double max_value() const override { return value_; }
    bool is_constant() const override { return true; }

private:
    double value_;
};

/// Largest value of `spectrum` in the visible range, when it is linear between the `knots`.
template <class Kind>
double max_at_knots(const Kind& spectrum, std::span<const double> knots) {
    double largest = std::max(spectrum.value_at(kLambdaMin_nm), spectrum.value_at(kLambdaMax_nm));
    for (double lambda_nm : knots) {
        if (lambda_nm < kLambdaMin_nm || lambda_nm > kLambdaMax_nm) continue;
        largest = std::max(largest, spectrum.value_at(lambda_nm));
    }
    return largest;
}

/// Equally spaced values: the place in the table is found by arithmetic.
class RegularTable final : public Lanewise<RegularTable> {
public:
    /// At least two values.
    RegularTable(std::span<const double> lambda_nm, std::vector<double> values,
                 OutsideTable outside)
        : values_(std::move(values)),
          first_nm_(lambda_nm.front()),
          last_nm_(lambda_nm.back()),
          cells_(double(values_.size() - 1)),
          cells_per_nm_(cells_ / (last_nm_ - first_nm_)),
          zero_outside_(outside == OutsideTable::zero) {
        max_value_ = max_at_knots(*this, lambda_nm);
    }

    double value_at(double lambda_nm) const {
        const double place = (lambda_nm - first_nm_) * cells_per_nm_;
        // In this form a NaN becomes 0.
        const double inside = place > 0.0 ? (place < cells_ ? place : cells_) : 0.0;
        const std::size_t i = std::min(std::size_t(inside), values_.size() - 2);
        const double value = values_[i] + (inside - double(i)) * (values_[i + 1] - values_[i]);
        const bool is_outside = lambda_nm < first_nm_ || lambda_nm > last_nm_;
        return zero_outside_ && is_outside ? 0.0 : value;
    }
    double max_value() const override { return max_value_; }

private:
    std::vector<double> values_;
    double first_nm_, last_nm_;
    double cells_, cells_per_nm_;
    bool zero_outside_;
    double max_value_ = 0.0;
};

/// Values at any wavelengths: the place in the table is found by bisection.
class IrregularTable final : public Lanewise<IrregularTable> {
public:
    IrregularTable(std::vector<double> lambda_nm, std::vector<double> values, OutsideTable outside)
        : lambda_nm_(std::move(lambda_nm)),
          values_(std::move(values)),
          zero_outside_(outside == OutsideTable::zero) {
        max_value_ = max_at_knots(*this, lambda_nm_);
    }

    double value_at(double lambda_nm) const {
        if (lambda_nm < lambda_nm_.front()) return zero_outside_ ? 0.0 : values_.front();
        if (lambda_nm > lambda_nm_.back()) return zero_outside_ ? 0.0 : values_.back();
        const auto above = std::upper_bound(lambda_nm_.begin(), lambda_nm_.end(), lambda_nm);
        if (above == lambda_nm_.end()) return values_.back();
        const std::size_t i = std::size_t(above - lambda_nm_.begin()) - 1;
        const double t = (lambda_nm - lambda_nm_[i]) / (lambda_nm_[i + 1] - lambda_nm_[i]);
        return values_[i] + t * (values_[i + 1] - values_[i]);
    }
    double max_value() const override { return max_value_; }

private:
    std::vector<double> lambda_nm_, values_;
    bool zero_outside_;
    double max_value_ = 0.0;
};

void require_table(std::span<const double> lambda_nm, std::span<const double> values) {
    if (lambda_nm.empty()) throw InputError("a spectrum's table needs at least one wavelength");
    if (lambda_nm.size() != values.size()) {
        throw InputError("a spectrum's table has " + std::to_string(lambda_nm.size()) +
                         " wavelengths but " + std::to_string(values.size()) + " values");
    }
    for (std::size_t i = 0; i < lambda_nm.size(); ++i) {
        if (!std::isfinite(lambda_nm[i]) || !std::isfinite(values[i])) {
            throw InputError("row " + std::to_string(i + 1) +
                             " of a spectrum's table is not finite");
        }
        if (i > 0 && lambda_nm[i] <= lambda_nm[i - 1]) {
            throw InputError("wavelengths of a spectrum's table must ascend, but row " +
                             std::to_string(i + 1) + " does not lie above the row before it");
        }
    }
}

bool is_regular(std::span<const double> lambda_nm) {
    if (lambda_nm.size() < 2) return false;
    const double step = (lambda_nm.back() - lambda_nm.front()) / double(lambda_nm.size() - 1);
    for (std::size_t i = 0; i < lambda_nm.size(); ++i) {
        const double expected = lambda_nm.front() + double(i) * step;
        if (std::abs(lambda_nm[i] - expected) > kRegularStepTolerance * step) return false;
    }
    return true;
}

/// Lines as a staircase: `values_[i]` from `edges_nm_[i]` (included) to the next edge (excluded).
class LineSpectrum final : public Lanewise<LineSpectrum> {
public:
    LineSpectrum(std::span<const Line> lines, double width_nm) {
        for (const Line& line : lines) {
            edges_nm_.push_back(line.centre.to(unit::nm) - 0.5 * width_nm);
            edges_nm_.push_back(line.centre.to(unit::nm) + 0.5 * width_nm);
        }
        std::sort(edges_nm_.begin(), edges_nm_.end());
        edges_nm_.erase(std::unique(edges_nm_.begin(), edges_nm_.end()), edges_nm_.end());
        for (double edge : edges_nm_) values_.push_back(sum_from(edge, lines, width_nm));
        for (std::size_t i = 0; i + 1 < edges_nm_.size(); ++i) {
            const bool visible = edges_nm_[i] <= kLambdaMax_nm && edges_nm_[i + 1] > kLambdaMin_nm;
            if (visible) max_value_ = std::max(max_value_, values_[i]);
        }
    }

    double value_at(double lambda_nm) const {
        const auto above = std::upper_bound(edges_nm_.begin(), edges_nm_.end(), lambda_nm);
        return above == edges_nm_.begin() ? 0.0
                                          : values_[std::size_t(above - edges_nm_.begin()) - 1];
    }
    double max_value() const override { return max_value_; }

private:
    /// Sum of the boxes that cover the step beginning at `edge_nm`.
    static double sum_from(double edge_nm, std::span<const Line> lines, double width_nm) {
        double sum = 0.0;
        for (const Line& line : lines) {
            const double begin = line.centre.to(unit::nm) - 0.5 * width_nm;
            const double end = line.centre.to(unit::nm) + 0.5 * width_nm;
            if (begin <= edge_nm && edge_nm < end) sum += line.strength / width_nm;
        }
        return sum;
    }

    std::vector<double> edges_nm_, values_;
    double max_value_ = 0.0;
};

class ScaledSpectrum final : public Spectrum {
public:
    ScaledSpectrum(SpectrumPtr spectrum, double factor)
        : spectrum_(std::move(spectrum)), factor_(factor) {}

    void eval_lanes(std::span<const double> lambda_nm, std::span<double> out) const override {
        spectrum_->eval_lanes(lambda_nm, out);
        for (double& value : out) value *= factor_;
    }
    double max_value() const override { return factor_ * spectrum_->max_value(); }
    bool is_constant() const override { return spectrum_->is_constant(); }

protected:
    double eval(double lambda_nm) const override {
        return (*spectrum_)(lambda_nm * unit::nm) * factor_;
    }

private:
    SpectrumPtr spectrum_;
    double factor_;
};

}  // namespace

SpectrumPtr make_constant(double value) { return std::make_shared<ConstantSpectrum>(value); }

SpectrumPtr make_tabulated(std::vector<double> lambda_nm, std::vector<double> values,
                           OutsideTable outside) {
    require_table(lambda_nm, values);
    if (is_regular(lambda_nm)) {
        return std::make_shared<RegularTable>(lambda_nm, std::move(values), outside);
    }
    return std::make_shared<IrregularTable>(std::move(lambda_nm), std::move(values), outside);
}

SpectrumPtr make_lines(std::vector<Line> lines, Wavelength width) {
    const double width_nm = width.to(unit::nm);
    if (!(width_nm > 0.0) || !std::isfinite(width_nm)) {
        throw InputError("the width of a spectral line must be positive");
    }
    for (const Line& line : lines) {
        if (!std::isfinite(line.centre.to(unit::nm)) || !std::isfinite(line.strength)) {
            throw InputError("centre and strength of a spectral line must be finite");
        }
    }
    return std::make_shared<LineSpectrum>(lines, width_nm);
}

SpectrumPtr make_scaled(SpectrumPtr spectrum, double factor) {
    DEWBOW_CHECK(spectrum != nullptr, "a spectrum to scale");
    DEWBOW_CHECK(factor >= 0.0 && std::isfinite(factor),
                 "a spectrum is scaled by a finite factor >= 0");
    if (spectrum->is_constant()) return make_constant(factor * spectrum->max_value());
    return std::make_shared<ScaledSpectrum>(std::move(spectrum), factor);
}

}  // namespace dewbow
