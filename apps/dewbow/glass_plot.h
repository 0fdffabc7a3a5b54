// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "glass_facts.h"

namespace dewbow {

/// n over the wavelength and the Abbe diagram with the whole catalogue, as one SVG.
std::string glass_plot(std::span<const GlassFacts> glasses);

}  // namespace dewbow
