// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/animation.h"

#include <fmt/format.h>

#include <algorithm>

#include "dewbow/import/gltf/animation_sampler.h"

namespace dewbow::gltf {
namespace {

constexpr std::string_view kPaths[] = {"translation", "rotation", "scale", "weights"};

std::string name_of(const Json& animation) {
    const std::string number = animation.pointer().substr(animation.pointer().rfind('/') + 1);
    return fmt::format("animation \"{}\"", animation.text("name", number));
}

/// "rotation"; nothing where the channel moves what is not read, which is noted.
std::optional<std::string> path_of(Document& document, const Json& target, const std::string& who) {
    const Json path = target.require("path");
    if (path.text() == "pointer") {
        document.notes().add(path.place(),
                             "what {} changes but places and weights (KHR_animation_pointer) stays "
                             "as it is",
                             who);
        return std::nullopt;
    }
    if (std::find(std::begin(kPaths), std::end(kPaths), path.text()) == std::end(kPaths)) {
        path.fail(fmt::format("\"{}\" is nothing that can be animated", path.text()),
                  "expected translation, rotation, scale or weights");
    }
    return path.text();
}

}  // namespace

Pose::Pose(Document& document, double time_s) {
    const auto animations = document.root().find("animations");
    for (std::size_t a = 0; animations && a < animations->size(); ++a) {
        const Json animation = (*animations)[a];
        const std::string who = name_of(animation);
        const Json channels = animation.require("channels");
        const Json samplers = animation.require("samplers");
        const std::size_t count = samplers.size();
        for (std::size_t c = 0; c < channels.size(); ++c) {
            const Json channel = channels[c], target = channel.require("target");
            const auto path = path_of(document, target, who);
            const auto node = target.find("node");
            if (!path || !node) continue;
            document.item("nodes", *node);  // that there is one
            const Json index = channel.require("sampler");
            if (count == 0) index.fail("there are no samplers");
            const AnimationSampler sampler(document, samplers[index.whole(count - 1)], *path);
            const std::size_t which = node->whole(document.count("nodes") - 1);
            if (values_.try_emplace({which, *path}, sampler.at(time_s)).second) continue;
            document.notes().add(animation.place(),
                                 "{} moves what an earlier one moves, and is not used there", who);
        }
    }
}

const std::vector<double>* Pose::find(std::size_t node, const std::string& path) const {
    if (values_.empty()) return nullptr;
    const auto found = values_.find({node, path});
    return found != values_.end() ? &found->second : nullptr;
}

}  // namespace dewbow::gltf
