// SPDX-License-Identifier: Apache-2.0
#include "dewbow_contestants.h"

#include "child_process.h"

#include "dewbow/base/error.h"
#include "dewbow/base/file.h"
#include "dewbow/image/exr.h"

namespace dewbow::bench {
namespace {

constexpr const char* kPicture = "picture.exr";

/// An estimator of `dewbow render`, and how it is set.
struct Method {
    std::string name, estimator;
    std::vector<std::string> settings;  ///< for --set
    /// Key that takes the number of spectral samples; empty: it does not split.
    std::string splits_key{};
    /// Whose limit it has; empty: the truth.
    std::string limit{};
    /// Which scenes it takes part in.
    bool images = true, caustics = false;
};

class DewbowContestant : public Contestant {
public:
    DewbowContestant(Method method, std::filesystem::path program)
        : method_(std::move(method)), program_(std::move(program)) {}
    std::string name() const override { return method_.name; }
    std::string version() const override { return first_line_of({program_.string(), "--version"}); }
    bool shows(const PlainScene& scene) const override {
        return scene.has_caustics() ? method_.caustics : method_.images;
    }
    bool splits_spectrum() const override { return !method_.splits_key.empty(); }
    bool converges_to_truth() const override { return method_.limit.empty(); }
    std::string limit_name() const override {
        return method_.limit.empty() ? method_.name : method_.limit;
    }

    std::vector<std::string> write(const Order& order) const override {
        const Film& film = order.scene.scene.film;
        std::vector<std::string> words = {
            program_.string(),
            "render",
            order.scene.file.string(),
            "--output",
            kPicture,
            "--estimator",
            method_.estimator,
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
        std::vector<std::string> settings = method_.settings;
        if (splits_spectrum())
            settings.push_back(method_.splits_key + '=' +
                               std::to_string(order.knobs.spectral_samples));
        for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
        return words;
    }

    Picture read(const Order& order) const override {
        const auto path = order.folder / kPicture;
        return picture_of(decode_exr(read_file(path), path.string()).image, path.string());
    }

private:
    Method method_;
    std::filesystem::path program_;
};

std::unique_ptr<Contestant> find(const Programs& programs, Method method) {
    const auto program = programs.find("dewbow");
    if (!program) return nullptr;
    return std::make_unique<DewbowContestant>(std::move(method), *program);
}

constexpr const char* kTable = "render.distributed_1989.";

Method method_of_1989(const std::string& stem, SamplesLie lie) {
    Method method{stem, "distributed_1989", {}, std::string(kTable) + "samples"};
    switch (lie) {
        case SamplesLie::fixed:
            method.name += "-fixed";
            method.settings = {"jitter=\"none\""};
            break;
        case SamplesLie::jittered:
            method.name += "-jittered";
            method.settings = {"jitter=\"both\""};
            break;
        case SamplesLie::correlated:
            method.name += "-correlated";
            method.settings = {"jitter=\"both\"", "correlated=true"};
            break;
    }
    return method;
}

std::unique_ptr<Contestant> find_1989(const Programs& programs, Method method) {
    for (std::string& setting : method.settings) setting = kTable + setting;
    return find(programs, std::move(method));
}

}  // namespace

std::unique_ptr<Contestant> find_path(const Programs& programs) {
    Method method{"path", "path", {}};
    method.caustics = true;
    return find(programs, std::move(method));
}

std::unique_ptr<Contestant> find_caustics(const Programs& programs, const std::string& name,
                                          std::vector<std::string> settings) {
    Method method{name, "caustics", std::move(settings)};
    method.images = false;
    method.caustics = true;
    return find(programs, std::move(method));
}

template <SamplesLie lie>
std::unique_ptr<Contestant> find_published_1989(const Programs& programs) {
    Method method = method_of_1989("1989", lie);
    method.limit = "1989";
    return find_1989(programs, std::move(method));
}

template <SamplesLie lie>
std::unique_ptr<Contestant> find_corrected_1989(const Programs& programs) {
    Method method = method_of_1989("1989-corrected", lie);
    method.settings.insert(method.settings.end(),
                           {"colours=\"cie\"", "index=\"scene\"", "reflectance=\"spectral\"",
                            "transport=\"spectral\"", "sum=\"free\"", "least_weight=1e-4"});
    return find_1989(programs, std::move(method));
}

template std::unique_ptr<Contestant> find_published_1989<SamplesLie::fixed>(const Programs&);
template std::unique_ptr<Contestant> find_published_1989<SamplesLie::jittered>(const Programs&);
template std::unique_ptr<Contestant> find_published_1989<SamplesLie::correlated>(const Programs&);
template std::unique_ptr<Contestant> find_corrected_1989<SamplesLie::fixed>(const Programs&);
template std::unique_ptr<Contestant> find_corrected_1989<SamplesLie::jittered>(const Programs&);
template std::unique_ptr<Contestant> find_corrected_1989<SamplesLie::correlated>(const Programs&);

}  // namespace dewbow::bench
