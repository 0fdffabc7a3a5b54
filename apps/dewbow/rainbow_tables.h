// SPDX-License-Identifier: Apache-2.0
#pragma once

// The tables that the files of one run are made of, each computed once.

#include <list>

#include "rainbow_setup.h"

namespace dewbow {

class RainbowTables {
public:
    explicit RainbowTables(RainbowSetup setup) : setup_(std::move(setup)) {}
    const RainbowSetup& setup() const { return setup_; }

    /// By `model`, at the wavelengths and angles that were asked for, or else these. Throws
    /// InputError.
    const ScatteringTable& get(const std::string& model, const std::vector<Wavelength>& wavelengths,
                               const std::vector<Angle>& angles);
    /// The same by the first model.
    const ScatteringTable& get(const std::vector<Wavelength>& wavelengths,
                               const std::vector<Angle>& angles) {
        return get(setup_.models.front(), wavelengths, angles);
    }

private:
    struct Entry {
        std::string model;
        ScatteringTable table;
    };
    RainbowSetup setup_;
    std::list<Entry> entries_;
};

/// 0 to 180° by 0.1°.
std::vector<Angle> whole_circle();
/// From 25° to 65° around the antisolar point, where the two bows are.
std::vector<Angle> around_the_bows();
/// From `nearest` to the antisolar point to 90° around it, by 0.05°.
std::vector<Angle> half_the_sky(Angle nearest);
/// 380 to 780 nm by 5 nm: enough of them that no rings of colour appear between wavelengths.
std::vector<Wavelength> visible_wavelengths();

}  // namespace dewbow
