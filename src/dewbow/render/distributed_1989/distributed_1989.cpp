// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/distributed_1989/distributed_1989.h"

#include "dewbow/base/check.h"
#include "dewbow/base/error.h"
#include "dewbow/render/distributed_1989/ray_tree.h"

namespace dewbow {

namespace {

using distributed_1989::Method;
using distributed_1989::RayTree;
using distributed_1989::Workspace;

/// That of this thread for `method`.
Workspace& workspace_of(const Method& method) {
    thread_local std::unique_ptr<Workspace> workspace;
    if (!workspace || workspace->serial != method.prepared().serial)
        workspace = std::make_unique<Workspace>(method);
    return *workspace;
}

class Distributed1989Estimator : public Estimator {
public:
    explicit Distributed1989Estimator(const Scene& scene)
        : method_(scene), aerial_(scene.aerial != nullptr) {
        if (scene.camera.polariser)
            throw InputError(
                "the camera has a polariser, and distributed_1989 knows no polarised light",
                "the estimators path and caustics do");
    }

    std::string leaves_out() const override {
        return aerial_ ? "the veil of the air before what is far (aerial_perspective)" : "";
    }

    void render(const Unit& unit, FilmSums& film) const override {
        const std::uint64_t seed = method_.prepared().scene.render.seed;
        Workspace& workspace = workspace_of(method_);
        for_each_sample(unit, seed, [&](int x, int y, std::int64_t i) {
            const SampleKey key(stream_key(seed, std::uint32_t(x), std::uint32_t(y)),
                                std::uint32_t(i));
            film.add(x, y, RayTree(method_, key, workspace).grow(x, y), i);
        });
    }

private:
    Method method_;
    bool aerial_;
};

}  // namespace

std::unique_ptr<Estimator> make_distributed_1989_estimator(const Scene& scene) {
    return std::make_unique<Distributed1989Estimator>(scene);
}

std::string distributed_1989_settings(const RenderSettings& settings) {
    return "max depth " + std::to_string(settings.max_depth) + ", " +
           text_of(settings.distributed_1989);
}

}  // namespace dewbow
