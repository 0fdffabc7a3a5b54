// SPDX-License-Identifier: Apache-2.0
#pragma once

// What `dewbow spectrum -o FILE` writes, by the file's ending, and what it prints.

#include <string>
#include <vector>

#include "dewbow/image/image.h"
#include "spectrum_setup.h"

namespace dewbow {

const std::vector<std::string>& spectrum_output_endings();
/// ".csv, the curves as a table; …" for help.
std::string spectrum_outputs_described();
/// As they look: --gamma is of these.
bool output_shows_colours(const std::string& file);
/// The bytes of `file`.
std::string spectrum_output(const std::string& file, const SpectrumSetup& setup);

/// For people: the model, the samples and their sums.
std::string spectrum_text(const SpectrumSetup& setup);
/// The same for programs; `written` are files.
std::string spectrum_json(const SpectrumSetup& setup, const std::vector<std::string>& written);

/// What a file has to say about how it was made.
Attributes spectrum_facts(const SpectrumSetup& setup);

}  // namespace dewbow
