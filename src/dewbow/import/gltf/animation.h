// SPDX-License-Identifier: Apache-2.0
#pragma once

// Animations: where they put nodes at one time.  [glTF 2.0, 3.11 and appendix C]

#include <map>
#include <string>
#include <vector>

#include "dewbow/import/gltf/document.h"

namespace dewbow::gltf {

/// What the animations of a file make of its nodes at one time.
class Pose {
public:
    /// At rest: nothing is animated.
    Pose() = default;
    /// All animations at `time_s` seconds, each held at its ends. Where two move the same thing the
    /// first counts, which is noted. Throws InputError.
    Pose(Document& document, double time_s);

    /// The value of `path` ("translation", "rotation", "scale" or "weights") of node `node`, as
    /// many finite numbers as it has, or nullptr if no animation changes it.
    const std::vector<double>* find(std::size_t node, const std::string& path) const;

private:
    std::map<std::pair<std::size_t, std::string>, std::vector<double>> values_;
};

}  // namespace dewbow::gltf
