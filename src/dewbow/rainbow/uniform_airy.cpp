// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/uniform_airy.h"

#include <cmath>

#include "dewbow/rainbow/bow_model.h"
#include "dewbow/rainbow/uniform_bow.h"

namespace dewbow {
namespace {

class UniformAiry final : public BowModel {
public:
    explicit UniformAiry(const Orders& orders) : BowModel(orders, {2, 3, 4, 5, 6, 7}) {}
    std::string_view name() const override { return "uniform_airy"; }

private:
    std::unique_ptr<BowPattern> make_pattern(RelativeIndex n, int p) const override {
        return std::make_unique<UniformBow>(n, p);
    }
};

}  // namespace

std::unique_ptr<ScatteringModel> make_uniform_airy(const ModelOptions& options) {
    return std::make_unique<UniformAiry>(options.orders);
}

BowError uniform_airy_error(RelativeIndex n, int p, double x) {
    const double cosine = std::cos(bow_geometry(n, p).incidence);
    const double y = x * cosine * cosine * cosine;
    return {18.0 / (y * (y + 20.0)), 80.0 / (y * (y + 25.0))};
}

}  // namespace dewbow
