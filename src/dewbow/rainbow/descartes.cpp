// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/descartes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "dewbow/base/error.h"
#include "dewbow/rainbow/geometric_flux.h"

namespace dewbow {
namespace {

Orders checked(Orders orders) {
    if (orders.empty()) {
        orders.resize(kHighestOrder + 1);
        std::iota(orders.begin(), orders.end(), 0);
    }
    for (int p : orders)
        if (p < 0 || p > kHighestOrder)
            throw InputError(
                fmt::format("descartes has no order {}; expected 0 to {}", p, kHighestOrder));
    std::sort(orders.begin(), orders.end());
    orders.erase(std::unique(orders.begin(), orders.end()), orders.end());
    return orders;
}

RelativeIndex real_index(ComplexIndex index) {
    if (!index.is_real())
        throw InputError(
            fmt::format("descartes cannot treat a drop that absorbs (k = {}); "
                        "expected k = 0, or the model mie",
                        index.k));
    return {index.n};
}

void check_size(const Drop& drop) {
    if (!(drop.size_parameter > 0.0 && std::isfinite(drop.size_parameter)))
        throw InputError(
            fmt::format("size parameter {}; expected a positive number", drop.size_parameter));
}

class Descartes final : public ScatteringModel {
public:
    explicit Descartes(Orders orders) : orders_(std::move(orders)) {}
    std::string_view name() const override { return "descartes"; }

    void intensities(ComplexIndex index, std::span<const Drop> drops, std::span<const Angle> theta,
                     std::span<Intensities> out) const override {
        const RelativeIndex n = real_index(index);
        const std::vector<Angle> edges = cell_edges(theta);
        std::vector<Intensities> of_unit_size;
        for (std::size_t d = 0; d < drops.size(); ++d) {
            check_size(drops[d]);
            if (d == 0 || drops[d].shifts != drops[d - 1].shifts)
                of_unit_size = cell_means(n, edges, drops[d].shifts);
            const double x2 = drops[d].size_parameter * drops[d].size_parameter;
            for (std::size_t k = 0; k < theta.size(); ++k)
                out[d * theta.size() + k] = {x2 * of_unit_size[k].perpendicular,
                                             x2 * of_unit_size[k].parallel};
        }
    }

    Efficiencies efficiencies(ComplexIndex index, const Drop& drop) const override {
        const RelativeIndex n = real_index(index);
        check_size(drop);
        double scattering = 0.0, forward = 0.0;
        for (int p : orders_) {
            const OrderFlux order = order_flux(n, p);
            scattering += order.flux.unpolarised();
            forward += order.flux_times_cosine.unpolarised();
        }
        return {1.0, scattering, forward / scattering};
    }

private:
    /// |S|² / x² = π (dσ/dΩ) / πa², the mean over each cell.
    std::vector<Intensities> cell_means(RelativeIndex n, const std::vector<Angle>& edges,
                                        const BowShifts& shifts) const {
        std::vector<Intensities> cells(edges.size() - 1);
        std::vector<Angle> moved(edges.size());
        for (int p : orders_) {
            for (std::size_t k = 0; k < edges.size(); ++k) {
                moved[k] = angle_without_shift(edges[k], shifts[std::size_t(p)]);
                // Beyond 20° the taper would fold back.
                if (k > 0) moved[k] = std::max(moved[k], moved[k - 1]);
            }
            add_geometric_flux(n, p, moved, cells);
        }
        for (std::size_t k = 0; k < cells.size(); ++k) {
            const double per_sr =
                std::numbers::pi / cell_solid_angle(edges[k], edges[k + 1]).to(unit::sr);
            cells[k] = {per_sr * cells[k].perpendicular, per_sr * cells[k].parallel};
        }
        return cells;
    }

    Orders orders_;
};

}  // namespace

std::unique_ptr<ScatteringModel> make_descartes(const ModelOptions& options) {
    return std::make_unique<Descartes>(checked(options.orders));
}

}  // namespace dewbow
