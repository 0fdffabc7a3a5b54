// SPDX-License-Identifier: Apache-2.0
#pragma once

// From what was said about a rainbow to all that is needed to compute it.

#include <array>
#include <string>
#include <vector>

#include "dewbow/image/image.h"
#include "dewbow/import/toml/storm_drops.h"
#include "dewbow/rainbow/scattering_table.h"
#include "dewbow/spectrum/spectrum.h"
#include "rainbow_command.h"

namespace dewbow {

struct RainbowSetup {
    Storm storm;                      ///< file and options together
    std::vector<std::string> models;  ///< at least one
    /// Of the first model and the first shower; wavelengths and angles as asked for, or empty.
    TableRequest request;
    std::vector<DropSizesPtr> showers;
    std::string drops;  ///< in a few words
    std::string light_name;
    SpectrumPtr white;  ///< what looks white
    SpectrumPtr light;  ///< what reaches the drops; differs from `white` where air reddens it
    Angle sun_altitude;
    Polarisation polarisation = Polarisation::unpolarised;
    bool cache = true;

    /// `request` by another model, and with these where nobody asked for others. Mie beside other
    /// models has all orders together.
    TableRequest request_for(const std::string& model, const std::vector<Wavelength>& wavelengths,
                             const std::vector<Angle>& angles) const;
    enum class Keep { nowhere, on_disk };
    /// The table of this request for all showers; from the disk if it is kept there, unless
    /// --no-cache was given. Throws InputError.
    ScatteringTable table_of(TableRequest request, Keep keep) const;
    /// What a file has to say about how it was made.
    Attributes facts() const;
};

/// Reads the storm file. Throws InputError, UsageError.
RainbowSetup set_up(const RainbowCommand& command);
/// File and options together.
Storm storm_of(const RainbowCommand& command);

}  // namespace dewbow
