// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/table_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string_view>
#include <system_error>

#include "dewbow/base/error.h"
#include "dewbow/base/file.h"

namespace dewbow {
namespace {

using namespace unit;

constexpr std::string_view kMagic = "dewbow scattering table 1\n";
/// To be raised whenever the same request gives other numbers.
constexpr std::uint64_t kPhysics = 2;
constexpr std::size_t kKeyDigits = 32, kChecksumBytes = 16;

/// FNV-1a with 64 bits from two starts: not against malice, only against chance.
///                                                        [Fowler, Noll & Vo; RFC 9923]
class Hash {
public:
    void add_bytes(std::string_view bytes) {
        for (const char c : bytes)
            for (std::uint64_t& part : parts_)
                part = (part ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
        // The second start alone would keep the first's collisions.
        parts_[1] ^= parts_[1] >> 29;
    }
    template <class Number>
    void add(Number number) {
        char bytes[sizeof number];
        std::memcpy(bytes, &number, sizeof number);
        add_bytes({bytes, sizeof number});
    }
    std::string digits() const { return fmt::format("{:016x}{:016x}", parts_[0], parts_[1]); }
    std::string bytes() const {
        std::string result(sizeof parts_, '\0');
        std::memcpy(result.data(), parts_, sizeof parts_);
        return result;
    }

private:
    std::uint64_t parts_[2] = {0xcbf29ce484222325u, 0x84222325cbf29ce4u};
};

/// Appends numbers to bytes, and takes them off again.
class Writer {
public:
    template <class Number>
    void put(Number number) {
        bytes_.append(reinterpret_cast<const char*>(&number), sizeof number);
    }
    void put_text(std::string_view text) {
        put(std::uint64_t(text.size()));
        bytes_.append(text);
    }
    const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};
class Reader {
public:
    explicit Reader(std::string_view bytes) : bytes_(bytes) {}
    template <class Number>
    Number get() {
        Number number{};
        take(reinterpret_cast<char*>(&number), sizeof number);
        return number;
    }
    std::string get_text() {
        std::string text(std::min<std::size_t>(get<std::uint64_t>(), bytes_.size()), '\0');
        take(text.data(), text.size());
        return text;
    }
    bool complete() const { return !short_ && bytes_.empty(); }

private:
    void take(char* to, std::size_t count) {
        if (count > bytes_.size()) {
            short_ = true, bytes_ = {};
            return;
        }
        std::memcpy(to, bytes_.data(), count);
        bytes_.remove_prefix(count);
    }
    std::string_view bytes_;
    bool short_ = false;
};

/// What a table has that its request does not say.
std::string encoded(const ScatteringTable& table) {
    Writer writer;
    for (const Intensities& each : table.phase)
        writer.put(each.perpendicular), writer.put(each.parallel);
    for (const Efficiencies& each : table.efficiencies)
        writer.put(each.extinction), writer.put(each.scattering), writer.put(each.asymmetry);
    writer.put(table.mean_cross_section.base_value());
    writer.put(table.stated_error);
    writer.put_text(table.report);
    return writer.bytes();
}

bool decode(std::string_view bytes, ScatteringTable& table) {
    Reader reader(bytes);
    for (Intensities& each : table.phase)
        each.perpendicular = reader.get<double>(), each.parallel = reader.get<double>();
    for (Efficiencies& each : table.efficiencies) {
        each.extinction = reader.get<double>(), each.scattering = reader.get<double>();
        each.asymmetry = reader.get<double>();
    }
    table.mean_cross_section = Area::from_base(reader.get<double>());
    table.stated_error = reader.get<double>();
    table.report = reader.get_text();
    return reader.complete();
}

/// Reads `file`; says what is wrong with it, or nothing.
std::string read_table(const std::filesystem::path& file, const std::string& key,
                       ScatteringTable& table) {
    const std::string bytes = read_file(file);
    std::string_view rest = bytes;
    if (!rest.starts_with(kMagic)) return "it is no table of this program";
    rest.remove_prefix(kMagic.size());
    if (rest.size() < kKeyDigits + kChecksumBytes) return "it is cut off";
    const std::string_view found_key = rest.substr(0, kKeyDigits);
    const std::string_view checksum = rest.substr(kKeyDigits, kChecksumBytes);
    rest.remove_prefix(kKeyDigits + kChecksumBytes);
    if (found_key != key) return "it is another request's";
    Hash hash;
    hash.add_bytes(rest);
    if (hash.bytes() != checksum || !decode(rest, table)) return "its checksum is wrong";
    return {};
}

void write_table(const std::filesystem::path& file, const std::string& key,
                 const ScatteringTable& table) {
    const std::string body = encoded(table);
    Hash hash;
    hash.add_bytes(body);
    std::filesystem::create_directories(file.parent_path());
    write_file_atomically(file, std::string(kMagic) + key + hash.bytes() + body);
}

void add_sizes(Hash& hash, const DropSizes& sizes) {
    hash.add_bytes(sizes.describe());
    hash.add(sizes.smallest().base_value());
    hash.add(sizes.largest().base_value());
    // Descriptions are rounded: the distribution itself, at some radii, is not.
    constexpr int kSamples = 16;
    for (int k = 0; k <= kSamples && !sizes.is_single(); ++k) {
        const double t = double(k) / kSamples;
        hash.add(sizes.density(sizes.smallest() + t * (sizes.largest() - sizes.smallest())));
    }
}

void add_falling(Hash& hash, const std::optional<FallingShape>& falling) {
    hash.add(falling.has_value());
    if (!falling) return;
    hash.add(falling->spread.oscillation);
    hash.add(falling->spread.tilt.base_value());
    hash.add(falling->place.sun_altitude.base_value());
    hash.add(falling->place.clock.base_value());
}

}  // namespace

std::filesystem::path default_cache_directory() {
    const auto folder = [](const char* name) -> std::filesystem::path {
        const char* value = std::getenv(name);
        return value && *value ? value : "";
    };
    if (const auto cache = folder("XDG_CACHE_HOME"); cache.is_absolute()) return cache / "dewbow";
    if (const auto home = folder("HOME"); home.is_absolute()) return home / ".cache" / "dewbow";
    return {};
}

std::string cache_key(const TableRequest& request) {
    Hash hash;
    hash.add_bytes(DEWBOW_VERSION);
    hash.add(kPhysics);
    hash.add_bytes(request.model);
    hash.add(request.orders.size());
    for (const int p : request.orders) hash.add(p);
    hash.add(request.tolerance);
    add_sizes(hash, *request.sizes);
    hash.add(request.optics.extinction);
    hash.add(request.wavelengths.size());
    for (const Wavelength lambda : request.wavelengths) {
        hash.add(lambda.base_value());
        hash.add((*request.optics.drop)(lambda).value);
        hash.add((*request.optics.around)(lambda).value);
    }
    hash.add(request.angles.size());
    for (const Angle angle : request.angles) hash.add(angle.base_value());
    hash.add(request.disc.radius.base_value());
    hash.add(request.disc.limb_darkening);
    add_falling(hash, request.falling);
    return hash.digits();
}

CachedTable cached_scattering_table(const TableRequest& request,
                                    const std::filesystem::path& directory) {
    check(request);
    CachedTable result;
    if (directory.empty()) {
        result.table = make_scattering_table(request);
        return result;
    }
    const std::string key = cache_key(request);
    const std::filesystem::path file = directory / ("table-" + key);
    try {
        if (std::filesystem::exists(file)) {
            ScatteringTable& table = result.table;
            table.angles = request.angles;
            table.wavelengths = request.wavelengths;
            table.phase.resize(request.angles.size() * request.wavelengths.size());
            table.efficiencies.resize(request.wavelengths.size());
            const std::string wrong = read_table(file, key, table);
            if (wrong.empty()) {
                result.from_cache = true;
                return result;
            }
            result.note = fmt::format("{}: {}; the table is made anew", file.string(), wrong);
        }
    } catch (const std::exception& error) {  // not readable: as if it were not there
        result.note = error.what();
    }
    result.table = make_scattering_table(request);
    try {
        write_table(file, key, result.table);
    } catch (const std::exception& error) {
        result.note = fmt::format("the table is not kept: {}", error.what());
    }
    return result;
}

}  // namespace dewbow
