// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/nodes.h"

#include <fmt/format.h>

#include <cmath>

namespace dewbow::gltf {
namespace {

/// Column-major, as glTF writes it.
Affine affine_of_matrix(const Json& matrix) {
    const std::vector<double> v = matrix.numbers(16, kCoordinateRange);
    if (v[3] != 0.0 || v[7] != 0.0 || v[11] != 0.0 || v[15] != 1.0) {
        matrix.fail("is not affine: its last row must be 0, 0, 0, 1");
    }
    Affine affine;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 4; ++column)
            affine.m[row][column] = v[column * 4 + row];
    }
    return affine;
}

/// The value of `path` in `pose`, or else in the file, or else nothing.
std::optional<std::vector<double>> member_of(const Json& node, std::size_t index, const Pose& pose,
                                             const char* path, std::size_t size) {
    if (const auto* animated = pose.find(index, path)) return *animated;
    const auto member = node.find(path);
    return member ? std::optional(member->numbers(size, kCoordinateRange)) : std::nullopt;
}

Affine local_transform(const Json& node, std::size_t index, const Pose& pose) {
    if (const auto matrix = node.find("matrix")) {
        for (const char* path : {"translation", "rotation", "scale"})
            if (pose.find(index, path)) matrix->fail("a node that is animated has no matrix");
        return affine_of_matrix(*matrix);
    }
    Affine result;
    if (const auto t = member_of(node, index, pose, "translation", 3))
        result = translation({(*t)[0], (*t)[1], (*t)[2]});
    if (const auto q = member_of(node, index, pose, "rotation", 4)) {
        const auto turn = rotation_of(*q);
        if (!turn) {
            const auto stated = node.find("rotation");
            (stated ? *stated : node).fail("is zero; a rotation is a unit quaternion");
        }
        result = result * *turn;
    }
    if (const auto s = member_of(node, index, pose, "scale", 3))
        result = result * scaling({(*s)[0], (*s)[1], (*s)[2]});
    return result;
}

bool is_hidden(const Json& node) {
    const auto extension = find_extension(node, "KHR_node_visibility");
    const auto visible = extension ? extension->find("visible") : std::nullopt;
    return visible && !visible->boolean();
}

bool is_finite(const Affine& affine) {
    for (const auto& row : affine.m) {
        for (const double value : row) {
            if (!std::isfinite(value)) return false;
        }
    }
    return true;
}

/// References to the nodes at the top of the scene that is shown.
std::vector<Json> root_references(Document& document) {
    std::vector<Json> roots;
    if (document.count("scenes") == 0) document.root().fail("has no scene that could be shown");
    const auto chosen = document.root().find("scene");
    const Json scene =
        chosen ? document.item("scenes", *chosen) : (*document.root().find("scenes"))[0];
    note_extensions(document, scene, {}, "the scene");
    const auto nodes = scene.find("nodes");
    for (std::size_t i = 0; nodes && i < nodes->size(); ++i) roots.push_back((*nodes)[i]);
    return roots;
}

class Walk {
public:
    Walk(Document& document, const Pose& pose, const std::function<void(const PlacedNode&)>& visit)
        : document_(document), pose_(pose), visit_(visit), seen_(document.count("nodes"), false) {}

    void run() {
        const std::vector<Json> roots = root_references(document_);
        for (std::size_t i = roots.size(); i-- > 0;) open_.push_back({roots[i], {}, 1, true});
        while (!open_.empty()) {
            const Step step = std::move(open_.back());
            open_.pop_back();
            enter(step);
        }
    }

private:
    struct Step {
        Json reference;
        Affine world_from_parent;
        int depth;
        bool visible;
    };

    void enter(const Step& step) {
        const Json node = document_.item("nodes", step.reference);
        const std::size_t index = step.reference.whole(seen_.size() - 1);
        if (seen_[index])
            step.reference.fail(fmt::format("node {} has two parents, or is its own", index));
        if (step.depth > kMaxNodeDepth) {
            step.reference.fail(fmt::format("nodes are nested more than {} deep", kMaxNodeDepth));
        }
        seen_[index] = true;
        const Affine world = step.world_from_parent * local_transform(node, index, pose_);
        if (!is_finite(world)) node.fail("its transform, with those above it, is not finite");
        const bool visible = step.visible && !is_hidden(node);
        visit_({node, world, node.text("name", ""), index, visible});
        const auto children = node.find("children");
        if (!children) return;
        for (std::size_t i = children->size(); i-- > 0;) {
            open_.push_back({(*children)[i], world, step.depth + 1, visible});
        }
    }

    Document& document_;
    const Pose& pose_;
    const std::function<void(const PlacedNode&)>& visit_;
    std::vector<bool> seen_;
    std::vector<Step> open_;
};

}  // namespace

void for_each_node(Document& document, const Pose& pose,
                   const std::function<void(const PlacedNode&)>& visit) {
    Walk(document, pose, visit).run();
}

std::optional<Affine> rotation_of(const std::vector<double>& q) {
    const double size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (!(size > 1e-12)) return std::nullopt;
    return rotation_of_quaternion(q[0] / size, q[1] / size, q[2] / size, q[3] / size);
}

}  // namespace dewbow::gltf
