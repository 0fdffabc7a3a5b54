// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sampling in proportion to tabulated weights: piecewise constant densities on [0, 1) and [0, 1)².

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace dewbow {

/// A density on [0, 1) that is constant in each of n equal cells, and equally a choice among n
/// things.
///
/// Weights that are all zero say nothing: the density is then uniform, and was_all_zero() tells.
class Distribution1D {
public:
    struct Sample {
        std::size_t index;  ///< the cell
        double offset;      ///< place within the cell, in [0, 1)
        double pdf;         ///< density on [0, 1) there; > 0
    };

    /// @param weights  of the cells, in any unit: finite, none negative, at least one.
    explicit Distribution1D(std::span<const double> weights);

    /// The inverse of cdf. Cells of weight zero are never chosen.   @param u  in [0, 1).
    Sample sample(double u) const;
    /// Density on [0, 1) in a cell: its probability times size(). Exactly that of sample, rounding
    /// included: a weight too small to change the sum has density 0.
    double pdf(std::size_t index) const;
    /// Probability of a cell.
    double probability(std::size_t index) const { return cdf_[index + 1] - cdf_[index]; }
    /// Probability of what lies below x, x in [0, 1].
    double cdf(double x) const;

    std::size_t size() const { return cdf_.size() - 1; }
    /// Sum of the weights as given.
    double total() const { return total_; }
    bool was_all_zero() const { return total_ == 0.0; }

private:
    std::vector<double> cdf_;  // at the ends of the cells: n + 1, from 0 to exactly 1
    // The cells that the ends of equal parts of [0, 1] lie in, a power of two of parts: between
    // them there are few cells to search.
    std::vector<std::uint32_t> guide_;
    double total_ = 0.0;
};

/// A density on [0, 1)² that is constant in each of width × height equal cells.
class Distribution2D {
public:
    struct Sample {
        double x, y;  ///< in [0, 1)²; x runs along the rows
        double pdf;   ///< density on [0, 1)² there; > 0
    };

    /// @param weights  of the cells, [y][x] row-major, width × height of them; as Distribution1D's.
    Distribution2D(std::span<const double> weights, std::size_t width, std::size_t height);

    /// @param u0  chooses x.   @param u1  chooses y.   Both in [0, 1).
    Sample sample(double u0, double u1) const;
    /// Density on [0, 1)² at a point; 0 outside.
    double pdf(double x, double y) const;
    /// The numbers (u0, u1) by which sample() gives a point of [0, 1)².
    std::array<double, 2> inverse(double x, double y) const;

    /// Sum of the weights as given.
    double total() const { return rows_.total(); }
    bool was_all_zero() const { return rows_.was_all_zero(); }

private:
    std::vector<Distribution1D> within_row_;
    Distribution1D rows_;
};

}  // namespace dewbow
