// SPDX-License-Identifier: Apache-2.0
#include "tiny_render.h"

#include <fmt/format.h>

#include <bit>
#include <fstream>
#include <iterator>

#include "dewbow/base/error.h"
#include "dewbow/base/hash.h"
#include "dewbow/image/exr.h"
#include "dewbow/image/png.h"
#include "dewbow/render/state.h"

namespace dewbow::faults {
namespace {

namespace fs = std::filesystem;

std::string hash_text(int width, int height, std::uint64_t hash) {
    return fmt::format("{}x{} {:016x}", width, height, hash);
}

std::string exr_pixels(const std::string& bytes) {
    const Image image = decode_exr(bytes, "picture").image;
    std::uint64_t hash = 0;
    for (const Channel& channel : image.channels) {
        hash = hash_combine(hash, hash_of_text(channel.name));
        for (const float value : channel.values)
            hash = hash_combine(hash, std::bit_cast<std::uint32_t>(value));
    }
    return hash_text(image.width, image.height, hash);
}

std::string png_pixels(const std::string& bytes) {
    const Image8 image = decode_png(bytes, "picture");
    return hash_text(
        image.width, image.height,
        hash_of_text({reinterpret_cast<const char*>(image.rgb.data()), image.rgb.size()}));
}

/// Kept for --resume after a failure.
bool is_whole_state(const fs::path& path) {
    if (path.extension() != kStateExtension) return false;
    try {
        return load_state(path).plan.finished_units() > 0;
    } catch (const InputError&) {
        return false;
    }
}

}  // namespace

const char* const kTinySceneText =
    "[camera]\nposition = [0, 0, 5]\nlook_at = [0, 0, 0]\n"
    "[materials.grey]\ntype = \"diffuse\"\nreflectance = 0.5\n"
    "[[shapes]]\ntype = \"sphere\"\nmaterial = \"grey\"\nradius_m = 1\n";

Words operator+(Words a, const Words& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

Words tiny_render(const Words& more) {
    return Words{"render", kTinyScene, "--size", "16x16", "--spp", "2"} + more;
}

std::string pixels_of_bytes(const std::string& bytes, const std::string& name) {
    try {
        return fs::path(name).extension() == ".exr" ? exr_pixels(bytes) : png_pixels(bytes);
    } catch (const InputError& error) {
        return error.what();
    }
}

std::string bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string pixels_of(const fs::path& picture) {
    return fs::exists(picture) ? pixels_of_bytes(bytes_of(picture), picture.string()) : "none";
}

std::string true_pixels(const std::string& name, const Words& more) {
    const RenderFolder folder;
    const std::string file = "true" + fs::path(name).extension().string();
    const Outcome outcome =
        run_program(DEWBOW_BINARY, tiny_render(more) + Words{"-o", file}, folder.path());
    if (outcome.exit_code != 0) return "cannot be rendered: " + outcome.standard_error;
    return pixels_of(folder.path() / file);
}

std::string losses(const std::map<std::string, std::string>& before, const Folder& folder,
                   const Outcome& outcome, const std::map<std::string, std::string>& outputs) {
    std::string lost;
    const auto after = folder.snapshot();
    const auto bytes_in = [](const auto& entries, const std::string& path) {
        const auto found = entries.find(path);
        return found == entries.end() ? std::string("none") : found->second;
    };
    if (outcome.signal != 0) lost += fmt::format("it was ended by signal {}\n", outcome.signal);
    for (const auto& [name, pixels] : outputs) {
        const std::string path = (folder.path() / name).string();
        const bool is_new = pixels_of(path) == pixels;
        if (!is_new && bytes_in(after, path) != bytes_in(before, path))
            lost +=
                name + " is neither the old file nor the new picture: " + pixels_of(path) + "\n";
        if (!is_new && outcome.exit_code == 0)
            lost += "the exit code is 0, but " + name + " is not the new picture\n";
    }
    const auto is_output = [&](const std::string& path) {
        return outputs.contains(fs::path(path).lexically_relative(folder.path()).string());
    };
    for (const auto& [path, bytes] : after)
        if (!is_output(path) && bytes_in(before, path) != bytes &&
            !(outcome.exit_code != 0 && is_whole_state(path)))
            lost += path + " came or changed\n";
    for (const auto& [path, bytes] : before)
        if (!is_output(path) && !after.contains(path)) lost += path + " is gone\n";
    return lost.empty() ? "" : lost + "It said: " + outcome.standard_error;
}

}  // namespace dewbow::faults
