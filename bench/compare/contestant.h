// SPDX-License-Identifier: Apache-2.0
#pragma once

// What takes part in the comparison: a program with an estimator. A new one is a class over
// Contestant and a row of contestants().

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "picture.h"
#include "plain_scene.h"

namespace dewbow::bench {

struct BenchScene {
    std::string name;            ///< of the file, without ending
    std::filesystem::path file;  ///< absolute
    Scene scene;                 ///< the film has the size that is asked for
    PlainScene plain;            ///< the same
};

/// What can be turned up to make a picture better.
struct Knobs {
    int spectral_samples =
        0;  ///< into how many rays glass splits one; 0: the contestant has no such number
    int samples_per_pixel = 1;
    std::uint64_t seed = 0;  ///< ignored by contestants without random numbers
};

struct Order {
    const BenchScene& scene;
    Knobs knobs;
    int threads = 1;
    std::filesystem::path folder;  ///< absolute, there, and for this picture alone
};

class Contestant {
public:
    virtual ~Contestant() = default;
    /// Unique, of letters, digits, '-', '_' and '.': also a name of files.
    virtual std::string name() const = 0;
    /// Of the program that was found, as it calls itself.
    virtual std::string version() const = 0;
    /// Whether it takes part in this scene: scenes of images, where nothing else is said.
    virtual bool shows(const PlainScene& scene) const { return !scene.has_caustics(); }
    /// Whether Knobs::spectral_samples means anything to it.
    virtual bool splits_spectrum() const = 0;
    /// Whether more samples lead to the true picture. Others have colours or an index of their own,
    /// and are also compared with their own limit (400 spectral samples).
    virtual bool converges_to_truth() const = 0;
    /// Contestants of one limit say the same: it is rendered once, by the first of them.
    virtual std::string limit_name() const { return name(); }
    /// Whether another seed gives another picture.
    virtual bool uses_seed() const { return true; }
    /// What it does instead when asked for `wanted` samples a pixel (a square, a power of two…).
    virtual int possible_samples_per_pixel(int wanted) const { return wanted; }
    /// Writes what its program needs into the folder; neither counted nor timed. Returns the words
    /// of the command that then makes the picture, the program's path first; it runs in the folder.
    virtual std::vector<std::string> write(const Order& order) const = 0;
    /// The picture that the command left there. Brightness is as the scene's radiances say: nothing
    /// is fitted. Throws InputError where there is none.
    virtual Picture read(const Order& order) const = 0;
};

/// Where programs are: named on the command line, else on the PATH.
class Programs {
public:
    explicit Programs(std::map<std::string, std::filesystem::path> named)
        : named_(std::move(named)) {}
    /// Absolute path of an executable file, or nothing.
    std::optional<std::filesystem::path> find(const std::string& name) const;

private:
    std::map<std::string, std::filesystem::path> named_;
};

struct ContestantRow {
    std::string name, description;
    std::string
        program;  ///< whose absence makes `find` give nullptr: for the list of who is not here
    std::unique_ptr<Contestant> (*find)(const Programs& programs);
};
/// All there are, whether their programs are here or not.
const std::vector<ContestantRow>& contestants();

}  // namespace dewbow::bench
