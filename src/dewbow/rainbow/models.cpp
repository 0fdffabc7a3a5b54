// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/models.h"

#include <fmt/format.h>

#include "dewbow/base/error.h"
#include "dewbow/rainbow/airy.h"
#include "dewbow/rainbow/automatic.h"
#include "dewbow/rainbow/debye.h"
#include "dewbow/rainbow/descartes.h"
#include "dewbow/rainbow/mie/mie_model.h"
#include "dewbow/rainbow/uniform_airy.h"

namespace dewbow {

const std::vector<ScatteringModelRow>& scattering_models() {
    static const std::vector<ScatteringModelRow> rows = {
        {"descartes", "rays of orders 0 to 7 without their phases: any size, no fringes",
         make_descartes},
        {"airy", "Airy's bow, absolute and for each polarisation: orders 2 to 7, near the bow",
         make_airy},
        {"uniform_airy", "bows from the two rays beside them, orders 2 to 7: index 1.30 to 1.36",
         make_uniform_airy},
        {"debye", "all waves of a sphere, by orders of light: real index, x from 0.001 to 20000",
         make_debye},
        {"mie", "all waves of a sphere of any index: exact, x from 0.001 to 50000", make_mie},
        {"auto", "the cheapest that holds a stated error, from 0 to 180 degrees", make_automatic},
    };
    return rows;
}

std::unique_ptr<ScatteringModel> make_scattering_model(std::string_view name,
                                                       const ModelOptions& options) {
    std::vector<std::string> names;
    for (const ScatteringModelRow& row : scattering_models()) {
        if (row.name == name) return row.make(options);
        names.push_back(row.name);
    }
    throw InputError(fmt::format("unknown model \"{}\"", name), hint_for(name, names));
}

}  // namespace dewbow
