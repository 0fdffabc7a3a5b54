// SPDX-License-Identifier: Apache-2.0
#include "dewbow_contestants.h"

#include "child_process.h"

#include "dewbow/base/error.h"
#include "dewbow/base/file.h"
#include "dewbow/image/exr.h"

namespace dewbow::bench {
namespace {

constexpr const char* kPicture = "picture.exr";

/// `dewbow render` with an estimator and its settings.
class DewbowContestant : public Contestant {
public:
    DewbowContestant(std::string name, std::filesystem::path program)
        : name_(std::move(name)), program_(std::move(program)) {}
    std::string name() const override { return name_; }
    std::string version() const override { return first_line_of({program_.string(), "--version"}); }
    bool splits_spectrum() const override { return false; }
    bool converges_to_truth() const override { return true; }

    std::vector<std::string> write(const Order& order) const override {
        const Film& film = order.scene.scene.film;
        return {program_.string(),
                "render",
                order.scene.file.string(),
                "--output",
                kPicture,
                "--estimator",
                "path",
                "--size",
                std::to_string(film.width) + 'x' + std::to_string(film.height),
                "--spp",
                std::to_string(order.knobs.samples_per_pixel),
                "--seed",
                std::to_string(order.knobs.seed),
                "--threads",
                std::to_string(order.threads),
                "--no-checkpoint",
                "--quiet"};
    }

    Picture read(const Order& order) const override {
        const auto path = order.folder / kPicture;
        return picture_of(decode_exr(read_file(path), path.string()).image, path.string());
    }

private:
    std::string name_;
    std::filesystem::path program_;
};

}  // namespace

std::unique_ptr<Contestant> find_path(const Programs& programs) {
    const auto program = programs.find("dewbow");
    if (!program) return nullptr;
    return std::make_unique<DewbowContestant>("path", *program);
}

}  // namespace dewbow::bench
