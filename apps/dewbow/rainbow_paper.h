// SPDX-License-Identifier: Apache-2.0
#pragma once

// `dewbow rainbow --paper`: the rainbow of Musgrave 1989, as published and corrected.

#include <string>

namespace dewbow {

/// What is wrong in it, line by line.
std::string paper_text();
/// The same as one JSON object.
std::string paper_json();
/// Its table of fogs as published and with all corrected, by angle from the antisolar point:
/// transmittances of red, green and blue, `inf` where there is no fog.
std::string paper_csv();

}  // namespace dewbow
