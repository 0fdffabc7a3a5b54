// SPDX-License-Identifier: Apache-2.0
#include "scene_references.h"

#include <fmt/format.h>

#include <bit>
#include <set>

#include "child_process.h"
#include "dewbow/base/error.h"
#include "dewbow/base/file.h"
#include "dewbow/base/hash.h"
#include "dewbow/base/parallel.h"
#include "dewbow/base/random.h"
#include "dewbow/image/exr.h"
#include "exact_picture.h"
#include "forward_picture.h"
#include "scratch_folder.h"

namespace dewbow::bench {
namespace {

/// No contestant's seed: those count from 1.
constexpr std::uint64_t kFirstHalfSeed = 1'000'001, kSecondHalfSeed = 2'000'003;

class Key {
public:
    Key& add(double value) {
        hash_ = hash_combine(hash_, std::bit_cast<std::uint64_t>(value));
        return *this;
    }
    Key& add(Vec3 v) { return add(v.x).add(v.y).add(v.z); }
    Key& add(std::string_view text) {
        hash_ = hash_combine(hash_, hash_of_text(text));
        return *this;
    }
    std::string text() const { return fmt::format("{:016x}", hash_); }

private:
    std::uint64_t hash_ = 0;
};

/// All that the picture depends on.
Key key_of(const PlainScene& scene) {
    Key key;
    const PlainCamera& camera = scene.camera;
    key.add(camera.eye).add(camera.right).add(camera.up).add(camera.forward);
    key.add(camera.tan_half_vertical_fov).add(double(camera.width)).add(double(camera.height));
    for (const PlainBody& body : scene.bodies) {
        for (const Vec3 vertex : body.vertices) key.add(vertex);
        for (const auto& triangle : body.triangles)
            for (const std::uint32_t corner : triangle) key.add(double(corner));
        if (body.sphere) key.add(body.sphere->centre).add(body.sphere->radius);
        key.add(double(body.priority));
    }
    for (const PlainLamp& lamp : scene.lamps) {
        key.add(double(lamp.shape)).add(double(lamp.two_sided));
        key.add(lamp.centre).add(lamp.half_u).add(lamp.half_v);
    }
    for (const PlainReceiver& receiver : scene.receivers)
        key.add(receiver.centre)
            .add(receiver.half_u)
            .add(receiver.half_v)
            .add(receiver.reflectance);
    for (const PlainSpot& spot : scene.spots)
        key.add(spot.position).add(spot.direction).add(spot.half_angle_rad);
    for (const PlainSun& sun : scene.suns) key.add(sun.direction).add(sun.angular_radius_rad);
    for (double nm = kLambdaMin_nm; nm <= kLambdaMax_nm; nm += 5.0) {
        const Wavelength lambda = nm * unit::nm;
        for (const PlainBody& body : scene.bodies) key.add((*body.index)(lambda).value);
        key.add((*scene.surrounding_index)(lambda).value);
        for (const PlainLamp& lamp : scene.lamps) key.add((*lamp.radiance)(lambda));
        for (const PlainSpot& spot : scene.spots) key.add((*spot.intensity)(lambda));
        for (const PlainSun& sun : scene.suns) key.add((*sun.irradiance)(lambda));
        if (scene.surroundings) key.add((*scene.surroundings)(lambda));
    }
    return key.add(scene.film_from_xyz);
}

/// The picture of `path`, or the one that `make` gives, which is written there.
template <class Make>
Picture kept(const std::filesystem::path& path, const Make& make) {
    if (std::filesystem::exists(path))
        return picture_of(decode_exr(read_file(path), path.string()).image, path.string());
    const Picture picture = make();
    std::filesystem::create_directories(path.parent_path());
    write_file_atomically(path, encode_exr(image_of(picture), {}, {}));
    return picture;
}

/// @param equal  the seed makes no difference: one half will do, and the reference does not know
/// its own error.
template <class Make>
Reference two_halves(const std::filesystem::path& folder, const std::string& name, bool equal,
                     const Make& make) {
    const auto half = [&](int number, std::uint64_t seed) {
        return kept(folder / fmt::format("{}-{}.exr", name, number), [&] { return make(seed); });
    };
    const Picture first = half(1, kFirstHalfSeed);
    return make_reference(first, equal ? first : half(2, kSecondHalfSeed));
}

/// As many rays for contestants that do not split them.
Knobs limit_knobs(const Contestant& contestant, const ReferenceSettings& settings) {
    const int splits = settings.limit_spectral_samples, spp = settings.limit_samples_per_pixel;
    if (contestant.splits_spectrum())
        return {splits, contestant.possible_samples_per_pixel(spp), 0};
    return {0, contestant.possible_samples_per_pixel(splits * spp), 0};
}

/// What the contestant is told, all but the seed, and the bytes of its program.
Key key_of(const BenchScene& scene, const Contestant& contestant, const Knobs& knobs) {
    const ScratchFolder folder;
    const std::vector<std::string> words = contestant.write({scene, knobs, 1, folder.path()});
    Key key = key_of(scene.plain);
    key.add(read_file(words.front())).add(contestant.version());
    const auto add_without_folder = [&](std::string text) {
        const std::string name = folder.path().string();
        for (auto at = text.find(name); at != std::string::npos; at = text.find(name))
            text.erase(at, name.size());
        key.add(text);
    };
    for (const std::string& word : words) add_without_folder(word);
    std::set<std::filesystem::path> files;
    for (const auto& file : std::filesystem::recursive_directory_iterator(folder.path()))
        if (file.is_regular_file()) files.insert(file.path());
    for (const auto& file : files) add_without_folder(read_file(file));
    return key;
}

}  // namespace

Reference true_picture(const BenchScene& scene, const ReferenceSettings& settings) {
    const int samples = settings.truth_samples;
    const std::string key = key_of(scene.plain).text();
    return two_halves(settings.folder, fmt::format("{}-{}-truth-{}", scene.name, key, samples),
                      false, [&](std::uint64_t seed) {
                          return scene.plain.has_caustics()
                                     ? lit_picture(scene.plain, samples, seed)
                                     : exact_picture(scene.plain, samples, seed);
                      });
}

Reference own_limit(const BenchScene& scene, const Contestant& contestant,
                    const ReferenceSettings& settings) {
    Knobs knobs = limit_knobs(contestant, settings);
    const auto render = [&](std::uint64_t seed) {
        const ScratchFolder folder;
        knobs.seed = seed;
        const Order order{scene, knobs, hardware_threads(), folder.path()};
        const ChildUsage usage = run_child(contestant.write(order), folder.path());
        if (usage.exit_code != 0)
            throw InputError(fmt::format("{} ended with {} at its own limit of {}: {}",
                                         contestant.name(), usage.exit_code, scene.name,
                                         log_tail(folder.path())));
        return contestant.read(order);
    };
    const Key key = key_of(scene, contestant, knobs);
    return two_halves(settings.folder,
                      fmt::format("{}-{}-{}-{}-{}", scene.name, key.text(), contestant.limit_name(),
                                  knobs.spectral_samples, knobs.samples_per_pixel),
                      !contestant.uses_seed(), render);
}

}  // namespace dewbow::bench
