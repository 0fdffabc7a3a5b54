// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/mesh/mtl.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "dewbow/base/parse_number.h"
#include "dewbow/import/mesh/words.h"
#include "dewbow/import/range.h"

namespace dewbow {
namespace {

struct NumberWord {
    std::string_view word;
    Range range;
};
constexpr NumberWord kNumberWords[] = {
    {"Ns", {0.0, 1e6}},     {"Ni", {1.0, 10.0}},  {"d", kShareRange},  {"Tr", kShareRange},
    {"illum", {0.0, 10.0}}, {"Pr", kShareRange},  {"Pm", kShareRange}, {"Ps", kShareRange},
    {"Pc", kShareRange},    {"Pcr", kShareRange},
};
constexpr NumberWord kColourWords[] = {
    {"Kd", kShareRange}, {"Ks", kShareRange}, {"Ke", kAmountRange}, {"Tf", kShareRange}};

/// Statements of maps, and what MtlMaterial::maps calls them.
constexpr std::pair<std::string_view, std::string_view> kMapWords[] = {
    {"map_Kd", "Kd"}, {"map_Ks", "Ks"},     {"map_Ke", "Ke"},     {"map_d", "d"},
    {"map_Pr", "Pr"}, {"map_Pm", "Pm"},     {"map_Bump", "bump"}, {"map_bump", "bump"},
    {"bump", "bump"}, {"map_norm", "norm"}, {"norm", "norm"},
};
/// Light that comes from nowhere, which a path tracer finds itself.
constexpr std::string_view kPassedOver[] = {"Ka", "map_Ka"};

/// Options of maps and how many words follow; −1: one to three numbers.
constexpr std::pair<std::string_view, int> kMapOptions[] = {
    {"-blendu", 1}, {"-blendv", 1},  {"-boost", 1}, {"-bm", 1},     {"-cc", 1},
    {"-clamp", 1},  {"-imfchan", 1}, {"-mm", 2},    {"-texres", 1}, {"-type", 1},
    {"-o", -1},     {"-s", -1},      {"-t", -1},
};

template <class Rows>
auto row_of(const Rows& rows, std::string_view word) {
    return std::find_if(std::begin(rows), std::end(rows), [&](const auto& row) {
        const auto& [name, value] = row;
        return name == word;
    });
}

class MtlReader {
public:
    MtlReader(const std::string& file, std::string_view text, Diagnostics& diagnostics)
        : file_(file), text_(text), diagnostics_(diagnostics) {}

    std::vector<MtlMaterial> read() {
        LineReader lines(text_);
        while (lines.next()) {
            line_ = lines.number();
            words_.clear();
            split_words(lines.line(), words_);
            if (!words_.empty()) read_statement();
        }
        return std::move(materials_);
    }

private:
    [[noreturn]] void fail(const std::string& sentence, const std::string& hint = {}) const {
        throw InputError({file_, line_, 0, {}}, sentence, std::string(line_of(text_, line_)), hint);
    }
    void note_once(const std::string& subject, const std::string& text) {
        if (noted_.insert(subject).second) diagnostics_.push_back({{file_, line_, 0, {}}, text});
    }

    void read_statement() {
        const std::string_view word = words_[0];
        if (word[0] == '#') return read_comment();
        if (word == "newmtl") {
            if (words_.size() < 2) fail("\"newmtl\" needs a name");
            materials_.push_back({rest_from(1), line_, {}, {}, {}, {}, 0});
            return;
        }
        const auto number = row_of(kNumberWords, word), colour = row_of(kColourWords, word);
        const auto map = row_of(kMapWords, word);
        if (number != std::end(kNumberWords)) {
            read_number_of(*number);
        } else if (colour != std::end(kColourWords)) {
            read_colour_of(*colour);
        } else if (map != std::end(kMapWords)) {
            material().maps[std::string(map->second)] = read_map();
        } else if (std::find(std::begin(kPassedOver), std::end(kPassedOver), word) ==
                   std::end(kPassedOver)) {
            const std::string shown(word.substr(0, 40));
            note_once(shown, fmt::format("statements \"{}\" are not used", shown));
        }
    }

    MtlMaterial& material() {
        if (materials_.empty()) fail(fmt::format("\"{}\" needs a newmtl above it", words_[0]));
        return materials_.back();
    }

    /// What stands from word `first` to the end of the line.
    std::string rest_from(std::size_t first) const {
        return {words_[first].data(), words_.back().data() + words_.back().size()};
    }

    /// "# dewbow: glass NAME"
    void read_comment() {
        std::size_t first = words_[0] == "#" ? 1 : 0;
        if (words_.size() <= first) return;
        if (words_[first] != "dewbow:" && words_[first] != "#dewbow:") return;
        if (words_.size() < first + 3 || words_[first + 1] != "glass")
            fail("this comment is for dewbow, which does not understand it",
                 "expected: # dewbow: glass NAME");
        if (materials_.empty()) fail("a glass needs a newmtl above it");
        materials_.back().glass = rest_from(first + 2);
        materials_.back().glass_line = line_;
    }

    double read_number(std::size_t word, const Range& range) {
        const std::string_view text = words_[word];
        const auto number = parse_number<double>(text);
        if (!number || std::isnan(*number))
            fail(fmt::format("\"{}\" is no number", text.substr(0, 40)));
        const double held = std::clamp(*number, range.low, range.high);
        if (held != *number)
            note_once(fmt::format("range of {}", words_[0]),
                      fmt::format("{} is {}; it must be {}, and {} is taken", words_[0], *number,
                                  range.text(), held));
        return held;
    }

    void read_number_of(const NumberWord& row) {
        const std::size_t at = words_.size() > 2 && words_[1] == "-halo" ? 2 : 1;
        if (at == 2) note_once("-halo", "the option -halo of d is not used");
        if (words_.size() <= at) fail(fmt::format("\"{}\" needs a number", row.word));
        const double value = read_number(at, row.range);
        auto& numbers = material().numbers;
        if (row.word != "Tr") {
            numbers[std::string(row.word)] = value;
        } else {  // where both are there, d is right: some programs write Tr = d
            numbers.try_emplace("d", 1.0 - value);
        }
    }

    void read_colour_of(const NumberWord& row) {
        if (words_.size() > 1 && (words_[1] == "spectral" || words_[1] == "xyz"))
            return note_once(fmt::format("{} {}", row.word, words_[1]),
                             fmt::format("{} as {} is not used", row.word, words_[1]));
        if (words_.size() != 2 && words_.size() < 4)
            fail(fmt::format("\"{}\" needs one or three numbers", row.word));
        MtlColour colour;
        for (std::size_t c = 0; c < 3; ++c)
            colour[c] = read_number(words_.size() == 2 ? 1 : c + 1, row.range);
        material().colours[std::string(row.word)] = colour;
    }

    MtlMap read_map() {
        MtlMap map;
        map.line = line_;
        std::size_t at = 1;
        while (at < words_.size() && words_[at].starts_with('-')) {
            const auto option = row_of(kMapOptions, words_[at]);
            if (option == std::end(kMapOptions)) break;  // a name may begin so
            at = read_option(map, at, option->second);
        }
        if (at >= words_.size()) fail(fmt::format("\"{}\" needs the name of a file", words_[0]));
        map.file = rest_from(at);
        std::replace(map.file.begin(), map.file.end(), '\\', '/');
        return map;
    }

    /// Reads the option at word `at`; returns where the next begins.
    std::size_t read_option(MtlMap& map, std::size_t at, int count) {
        const std::string_view option = words_[at++];
        const auto is_number = [&](std::size_t word) {
            return word < words_.size() && parse_number<double>(words_[word]).has_value();
        };
        std::size_t end = at + std::size_t(std::max(count, 0));
        if (count < 0)
            while (end < at + 3 && is_number(end)) ++end;
        if (end > words_.size() || end == at)
            fail(fmt::format("the option {} needs a value", option));
        if (option == "-o" || option == "-s") {
            auto& pair = option == "-o" ? map.offset : map.scale;
            for (std::size_t i = 0; i < 2 && at + i < end; ++i)
                pair[i] = read_number(at + i, kCoordinateRange);
        } else if (option == "-bm") {
            map.bump = read_number(at, kCoordinateRange);
        } else if (option == "-clamp") {
            map.clamp = words_[at] == "on";
        } else if (option == "-imfchan") {
            map.channel = words_[at][0];
        } else {
            note_once(std::string(option), fmt::format("the option {} is not used", option));
        }
        return end;
    }

    const std::string& file_;
    std::string_view text_;
    Diagnostics& diagnostics_;
    std::set<std::string> noted_;
    std::size_t line_ = 0;
    std::vector<std::string_view> words_;
    std::vector<MtlMaterial> materials_;
};

}  // namespace

std::vector<MtlMaterial> parse_mtl(const std::string& file, std::string_view text,
                                   Diagnostics& diagnostics) {
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)
        throw InputError(SourcePlace{file, 0, 0, fmt::format("byte {}", zero)},
                         "this is no text, which MTL files are");
    return MtlReader(file, text, diagnostics).read();
}

}  // namespace dewbow
