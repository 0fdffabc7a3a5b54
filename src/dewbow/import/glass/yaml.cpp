// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/glass/yaml.h"

#include <fmt/format.h>

#include <algorithm>

#include "dewbow/base/error.h"

namespace dewbow::glass_import {
namespace {

constexpr int kMostLevels = 16;
constexpr std::string_view kSpaces = " \t\r";

struct Line {
    std::string_view text;  ///< without indentation and spaces at its end
    std::size_t indent = 0;
    std::size_t number = 0;
    std::string_view whole;
};

std::string_view trimmed(std::string_view text) {
    const std::size_t start = text.find_first_not_of(kSpaces);
    if (start == std::string_view::npos) return {};
    return text.substr(start, text.find_last_not_of(kSpaces) - start + 1);
}

std::string unquoted(std::string_view text) {
    text = trimmed(text);
    if (text.size() >= 2 && (text[0] == '"' || text[0] == '\'') && text.back() == text[0])
        return std::string(text.substr(1, text.size() - 2));
    return std::string(trimmed(text.substr(0, text.find(" #"))));
}

/// Where a key ends: at a colon that a space or the end follows.
std::size_t colon_of(std::string_view text) {
    for (std::size_t i = text.find(':'); i != std::string_view::npos; i = text.find(':', i + 1))
        if (i + 1 == text.size() || text[i + 1] == ' ') return i;
    return std::string_view::npos;
}

bool is_item(std::string_view text) { return text == "-" || text.starts_with("- "); }

class YamlParser {
public:
    YamlParser(std::string_view text, const std::string& file) : file_(file) {
        std::size_t number = 0;
        while (!text.empty()) {
            const std::size_t end = std::min(text.find('\n'), text.size());
            const std::string_view whole = text.substr(0, end);
            text.remove_prefix(std::min(end + 1, text.size()));
            const std::size_t indent = whole.find_first_not_of(' ');
            lines_.push_back(
                {trimmed(whole), indent == std::string_view::npos ? 0 : indent, ++number, whole});
        }
    }

    YamlNode parse() {
        skip_empty();
        if (at_ < lines_.size() && lines_[at_].text == "---") ++at_;
        skip_empty();
        if (at_ == lines_.size()) throw InputError(SourcePlace{file_, 0, 0, {}}, "nothing in it");
        YamlNode root = block(lines_[at_].indent, 0);
        skip_empty();
        if (at_ < lines_.size()) fail("expected a key as far to the left as the first");
        return root;
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        const Line& line = lines_[std::min(at_, lines_.size() - 1)];
        throw InputError(SourcePlace{file_, line.number, line.indent + 1, {}}, what,
                         std::string(line.whole));
    }

    void skip_empty() {
        while (at_ < lines_.size() &&
               (lines_[at_].text.empty() || lines_[at_].text.starts_with('#')))
            ++at_;
    }

    YamlNode block(std::size_t indent, int level) {
        if (level > kMostLevels) fail(fmt::format("more than {} levels", kMostLevels));
        if (lines_[at_].whole.find('\t') < lines_[at_].whole.find_first_not_of(kSpaces))
            fail("a tab as indentation; expected spaces");
        return is_item(lines_[at_].text) ? list(indent, level) : map(indent, level);
    }

    YamlNode list(std::size_t indent, int level) {
        YamlNode node{YamlNode::Kind::list, {}, {}, {}, lines_[at_].number};
        for (; at_ < lines_.size() && lines_[at_].indent == indent && is_item(lines_[at_].text);
             skip_empty()) {
            // What follows the dash is as if it stood alone, further in.
            Line& line = lines_[at_];
            const std::string_view rest = trimmed(line.text.substr(1));
            if (rest.empty()) fail("nothing after the dash; expected a key or a value");
            line.indent += static_cast<std::size_t>(rest.data() - line.text.data());
            line.text = rest;
            if (colon_of(rest) == std::string_view::npos) {
                node.items.push_back(scalar(rest));
                ++at_;
            } else {
                node.items.push_back(block(line.indent, level + 1));
            }
        }
        return node;
    }

    YamlNode map(std::size_t indent, int level) {
        YamlNode node{YamlNode::Kind::map, {}, {}, {}, lines_[at_].number};
        for (; at_ < lines_.size() && lines_[at_].indent == indent; skip_empty()) {
            const Line line = lines_[at_];
            const std::size_t colon = colon_of(line.text);
            if (colon == std::string_view::npos || is_item(line.text))
                fail("expected a key, a colon and a value");
            const std::string_view rest = trimmed(line.text.substr(colon + 1));
            std::string key = unquoted(line.text.substr(0, colon));
            node.entries.emplace_back(std::move(key), value(rest, indent, level));
        }
        if (at_ < lines_.size() && lines_[at_].indent > indent)
            fail("expected a key that stands under the one before");
        return node;
    }

    YamlNode value(std::string_view rest, std::size_t indent, int level) {
        if (rest.starts_with('|') || rest.starts_with('>')) return text_block(indent);
        if (!rest.empty() && !rest.starts_with('#')) {
            YamlNode node = scalar(rest);
            ++at_;
            return node;
        }
        const std::size_t number = lines_[at_].number;
        ++at_;
        skip_empty();
        if (at_ < lines_.size() && (lines_[at_].indent > indent ||
                                    (lines_[at_].indent == indent && is_item(lines_[at_].text))))
            return block(lines_[at_].indent, level + 1);
        return {YamlNode::Kind::scalar, {}, {}, {}, number};
    }

    YamlNode scalar(std::string_view text) const {
        return {YamlNode::Kind::scalar, unquoted(text), {}, {}, lines_[at_].number};
    }

    /// All lines that stand further in than the key.
    YamlNode text_block(std::size_t indent) {
        YamlNode node{YamlNode::Kind::scalar, {}, {}, {}, lines_[at_].number + 1};
        for (++at_; at_ < lines_.size(); ++at_) {
            if (!lines_[at_].text.empty() && lines_[at_].indent <= indent) break;
            node.text.append(lines_[at_].text).push_back('\n');
        }
        return node;
    }

    const std::string file_;
    std::vector<Line> lines_;
    std::size_t at_ = 0;
};

}  // namespace

const YamlNode* YamlNode::find(std::string_view key) const {
    for (const auto& [name, value] : entries)
        if (name == key) return &value;
    return nullptr;
}

YamlNode parse_yaml(std::string_view text, const std::string& file) {
    return YamlParser(text, file).parse();
}

}  // namespace dewbow::glass_import
