// SPDX-License-Identifier: Apache-2.0
#pragma once

// A glass, gem, plastic or fluid with what is known of it.

#include <optional>
#include <string>
#include <vector>

#include "dewbow/optics/dispersion.h"
#include "dewbow/spectrum/spectrum.h"

namespace dewbow {

/// The extinction coefficient k, the imaginary part of the index, at one wavelength.
struct Extinction {
    double lambda_nm = 0.0;
    double k = 0.0;
};

struct Glass {
    std::string name;                  ///< "schott/N-BK7", "gem/diamond", "fluid/water"
    std::vector<std::string> aliases;  ///< other names: "BK7"
    std::string description;
    DispersionData data;    ///< with the range of the measurements
    double n_d = 0.0;       ///< as published, against `data.reference`; 0 = not published
    double v_d = 0.0;       ///< as published; 0 = not published
    double accuracy = 0.0;  ///< of the index within the range, as far as is known; 0 = not known
    double lambda_min_nm = 0.0, lambda_max_nm = 0.0;  ///< range of the data; 0: unknown
    bool birefringent = false;  ///< a crystal that doubles what is seen through it
    bool extraordinary =
        false;                  ///< of such a crystal's two rays, the data are of the extraordinary
    std::vector<Extinction> k;  ///< by rising wavelength; empty where it is not known
    std::string source;         ///< citation
    std::string licence;        ///< of its numbers
    std::string k_source;       ///< where k is from, if not from `source`
};

/// What has to be said about a glass whose data do not cover the visible range, 360–830 nm:
/// "schott/SF11: data of 390 to 2500 nm; 360 to 390 nm is extrapolated".
std::optional<std::string> range_warning(const Glass& glass);

/// What has to be said about a birefringent crystal, one of whose rays is followed alone.
std::optional<std::string> birefringence_note(const Glass& glass);

/// Absorption coefficient in 1/m, 4πk/λ: linear between the wavelengths of k, and held beyond them.
/// Null where k is not known.
SpectrumPtr absorption_of(const Glass& glass);

}  // namespace dewbow
