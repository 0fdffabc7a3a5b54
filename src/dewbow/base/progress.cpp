// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/progress.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <utility>

namespace dewbow {

namespace {

using Seconds = std::chrono::duration<double>;

constexpr std::chrono::milliseconds kBarInterval{100};
constexpr std::chrono::seconds kLineInterval{1};
constexpr int kLinePercentStep = 5;
constexpr std::size_t kDefaultColumns = 80;
constexpr std::size_t kNarrowestBar = 10;
constexpr std::size_t kWidestBar = 40;
constexpr std::string_view kBarColour = "\x1b[36m";
constexpr std::string_view kPlainColour = "\x1b[0m";

bool is_set(const char* variable) {
    const char* value = std::getenv(variable);
    return value && *value;
}

bool is_smart_terminal(std::FILE* stream) {
    const char* terminal = std::getenv("TERM");
    return isatty(fileno(stream)) && terminal && std::string_view(terminal) != "dumb";
}

std::size_t columns_of(std::FILE* stream) {
    winsize size{};
    if (ioctl(fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
    return kDefaultColumns;
}

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

std::size_t character_count(std::string_view text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return !continues_character(c); }));
}

std::string first_characters(std::string_view text, std::size_t count) {
    std::size_t end = 0;
    for (; end < text.size(); ++end)
        if (!continues_character(text[end]) && count-- == 0) break;
    return std::string(text.substr(0, end));
}

/// A title on one line and without escape sequences, whatever the file in it is called.
std::string printable(std::string_view text) {
    std::string result(text);
    for (char& c : result) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 0x20 || code == 0x7f) c = '?';
    }
    return result;
}

/// Length in bytes of the well-formed UTF-8 character at the start of `text`, or 0. [RFC 3629, §4]
std::size_t character_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(0);
    const std::size_t length = first < 0x80                     ? 1
                               : first >= 0xc2 && first <= 0xdf ? 2
                               : first >= 0xe0 && first <= 0xef ? 3
                               : first >= 0xf0 && first <= 0xf4 ? 4
                                                                : 0;
    if (length == 0 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if (!continues_character(text[i])) return 0;
    const bool overlong = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xf0 && byte(1) < 0x90);
    const bool surrogate = first == 0xed && byte(1) > 0x9f;
    const bool beyond = first == 0xf4 && byte(1) > 0x8f;
    return overlong || surrogate || beyond ? 0 : length;
}

/// `text` as a JSON string with its quotes. File names need not be UTF-8, JSON must: what is not
/// becomes U+FFFD. [RFC 8259, §7, §8.1]
std::string json_string(std::string_view text) {
    constexpr std::string_view kHex = "0123456789abcdef";
    std::string result = "\"";
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        const auto code = static_cast<unsigned char>(text.front());
        if (length == 0) {
            result += "\xef\xbf\xbd";
        } else if (code == '"' || code == '\\') {
            result += '\\';
            result += text.front();
        } else if (code < 0x20) {
            result += "\\u00";
            result += kHex[code >> 4];
            result += kHex[code & 15];
        } else {
            result += text.substr(0, length);
        }
        text.remove_prefix(std::max<std::size_t>(1, length));
    }
    return result + '"';
}

/// Milliseconds are enough, and to_chars knows no locale.
std::string json_seconds(Seconds duration) {
    std::array<char, 64> buffer;
    const auto [end, status] = std::to_chars(buffer.data(), buffer.data() + buffer.size(),
                                             duration.count(), std::chars_format::fixed, 3);
    return status == std::errc{} ? std::string(buffer.data(), end) : "null";
}

/// How things stand at one moment.
struct State {
    std::uint64_t done;
    std::uint64_t total;
    std::uint64_t skipped;  ///< of those done: before the start
    Seconds elapsed;

    int percent() const {
        return static_cast<int>(100.0 * static_cast<double>(done) / static_cast<double>(total));
    }
    /// If the rest goes as fast as what was done; nothing before anything was.
    std::optional<Seconds> left() const {
        if (done <= skipped) return std::nullopt;
        return elapsed * (static_cast<double>(total - done) / static_cast<double>(done - skipped));
    }
};

/// "0:12 elapsed, 0:17 left"
std::string times_of(const State& state) {
    std::string text = format_duration(state.elapsed) + " elapsed";
    if (state.done < state.total && state.left())
        text += ", " + format_duration(*state.left()) + " left";
    return text;
}

std::string plain_line(const std::string& title, const State& state) {
    return printable(title) + ": " + std::to_string(state.percent()) + " % (" + times_of(state) +
           ")\n";
}

std::string json_line(const std::string& title, const State& state) {
    return "{\"event\":\"progress\",\"title\":" + json_string(title) +
           ",\"done\":" + std::to_string(state.done) + ",\"total\":" + std::to_string(state.total) +
           ",\"elapsed_s\":" + json_seconds(state.elapsed) +
           ",\"left_s\":" + (state.left() ? json_seconds(*state.left()) : "null") + "}\n";
}

/// "\rrender ring.glb  42 % [####------]  0:12 elapsed, 0:17 left": exactly `columns` - 1 wide, so
/// that it covers what stood there and does not wrap.
std::string bar_line(const std::string& title, const State& state, std::size_t columns,
                     bool coloured) {
    const std::size_t width = columns - 1;
    const std::string percent = std::to_string(state.percent());
    const std::string number = std::string(3 - percent.size(), ' ') + percent + " %";
    const std::string times = times_of(state);
    std::string name = printable(title);

    const std::size_t fixed = 1 + number.size() + 2 + times.size();
    const std::size_t room = width > fixed ? width - fixed : 0;
    name = first_characters(name, room);
    const std::size_t free = room - character_count(name);
    const std::size_t brackets = 3;  // " []"
    const std::size_t cells =
        free >= brackets + kNarrowestBar ? std::min(free - brackets, kWidestBar) : 0;

    std::string bar;
    if (cells > 0) {
        const std::size_t full = cells * static_cast<std::size_t>(state.percent()) / 100;
        bar = " [" + std::string(coloured ? kBarColour : "") + std::string(full, '#') +
              std::string(coloured ? kPlainColour : "") + std::string(cells - full, '-') + "]";
    }
    const std::size_t used = fixed + character_count(name) + (cells > 0 ? cells + brackets : 0);
    if (used > width) return first_characters("\r" + number, width + 1);
    name.insert(0, 1, '\r');
    return name + " " + number + bar + "  " + times + std::string(width - used, ' ');
}

ProgressStyle chosen_style(ProgressStyle wish, std::FILE* stream) {
    if (wish != ProgressStyle::automatic) return wish;
    return is_smart_terminal(stream) ? ProgressStyle::bar : ProgressStyle::plain;
}

}  // namespace

Progress::Progress(std::string title, std::uint64_t total, ProgressStyle style, std::FILE* stream)
    : title_(std::move(title)),
      total_(std::max<std::uint64_t>(1, total)),
      style_(chosen_style(style, stream)),
      stream_(stream) {}

Progress::~Progress() { finish(); }

void Progress::advance(std::uint64_t units) {
    done_.fetch_add(units, std::memory_order_relaxed);
    if (style_ == ProgressStyle::none) return;
    // Whoever finds another thread printing leaves it to that one.
    const std::unique_lock lock(printing_, std::try_to_lock);
    if (lock && !finished_) print(false);
}

void Progress::skip(std::uint64_t units) {
    skipped_.fetch_add(units, std::memory_order_relaxed);
    advance(units);
}

void Progress::finish() {
    const std::scoped_lock lock(printing_);
    if (finished_) return;
    finished_ = true;
    if (style_ != ProgressStyle::none) print(true);
}

void Progress::print(bool last) {
    const Clock::time_point now = Clock::now();
    const std::uint64_t done = std::min(total_, done_.load(std::memory_order_relaxed));
    const State state{done, total_, skipped_.load(std::memory_order_relaxed), now - start_};
    const bool bar = style_ == ProgressStyle::bar;
    const bool first = last_print_ == Clock::time_point{};
    const bool late_enough = first || now - last_print_ >= (bar ? Clock::duration(kBarInterval)
                                                                : Clock::duration(kLineInterval));
    const bool far_enough = bar || state.percent() >= last_percent_ + kLinePercentStep;
    if (!last && !(late_enough && far_enough)) return;
    if (last && style_ == ProgressStyle::plain && state.percent() == last_percent_) return;  // said

    last_print_ = now;
    last_percent_ = state.percent();
    std::string text;
    if (style_ == ProgressStyle::json)
        text = json_line(title_, state);
    else if (bar)
        text = bar_line(title_, state, columns_of(stream_),
                        isatty(fileno(stream_)) && !is_set("NO_COLOR"));
    else
        text = plain_line(title_, state);
    if (bar && last) text += '\n';
    std::fwrite(text.data(), 1, text.size(), stream_);
    std::fflush(stream_);
}

std::string format_duration(std::chrono::duration<double> duration) {
    // Beyond this no estimate means anything, and a long long still holds it.
    constexpr double kLongest = 1e9;
    if (!(duration.count() >= 0.0) || duration.count() > kLongest) return "?";
    const long long seconds = std::llround(duration.count());
    const auto two_digits = [](long long n) { return std::to_string(100 + n).substr(1); };
    const long long hours = seconds / 3600, minutes = seconds / 60 % 60;
    if (hours == 0) return std::to_string(minutes) + ":" + two_digits(seconds % 60);
    return std::to_string(hours) + ":" + two_digits(minutes) + ":" + two_digits(seconds % 60);
}

}  // namespace dewbow
