// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/progress.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <regex>
#include <thread>
#include <vector>

namespace dewbow {
namespace {

/// A stream that remembers what was written.
class Recorder {
public:
    Recorder() : file_(std::tmpfile()) {}
    ~Recorder() { std::fclose(file_); }
    std::FILE* stream() const { return file_; }
    std::string text() const {
        std::string result(static_cast<std::size_t>(std::ftell(file_)), '\0');
        std::rewind(file_);
        EXPECT_EQ(std::fread(result.data(), 1, result.size(), file_), result.size());
        return result;
    }

private:
    std::FILE* file_;
};

/// A terminal of a given width whose screen the test reads.
class Terminal {
public:
    explicit Terminal(unsigned short columns) : master_(posix_openpt(O_RDWR | O_NOCTTY)) {
        grantpt(master_);
        unlockpt(master_);
        const int slave = open(ptsname(master_), O_RDWR | O_NOCTTY);
        const winsize size{24, columns, 0, 0};
        ioctl(slave, TIOCSWINSZ, &size);
        stream_ = fdopen(slave, "w");
    }
    ~Terminal() {
        std::fclose(stream_);
        close(master_);
    }
    std::FILE* stream() const { return stream_; }
    std::string text() const {
        std::string result;
        pollfd ready{master_, POLLIN, 0};
        char buffer[4096];
        while (poll(&ready, 1, 50) == 1) {
            const ssize_t n = read(master_, buffer, sizeof buffer);
            if (n <= 0) break;
            result.append(buffer, static_cast<std::size_t>(n));
        }
        return result;
    }

private:
    int master_;
    std::FILE* stream_;
};

/// An environment variable that is as before afterwards.
class Variable {
public:
    Variable(const char* name, const char* value) : name_(name) {
        if (const char* old = std::getenv(name)) old_ = old;
        had_ = std::getenv(name) != nullptr;
        value ? setenv(name, value, 1) : unsetenv(name);
    }
    ~Variable() { had_ ? setenv(name_, old_.c_str(), 1) : unsetenv(name_); }

private:
    const char* name_;
    std::string old_;
    bool had_;
};

TEST(FormatDuration, HoursOnlyWhenThereAreAny) {
    using Seconds = std::chrono::duration<double>;
    EXPECT_EQ(format_duration(Seconds(0)), "0:00");
    EXPECT_EQ(format_duration(Seconds(0.6)), "0:01");
    EXPECT_EQ(format_duration(Seconds(59.6)), "1:00");
    EXPECT_EQ(format_duration(Seconds(245)), "4:05");
    EXPECT_EQ(format_duration(Seconds(3599)), "59:59");
    EXPECT_EQ(format_duration(Seconds(3723)), "1:02:03");
    EXPECT_EQ(format_duration(Seconds(360000)), "100:00:00");
    EXPECT_EQ(format_duration(Seconds(-1)), "?");
    EXPECT_EQ(format_duration(Seconds(std::numeric_limits<double>::quiet_NaN())), "?");
    EXPECT_EQ(format_duration(Seconds(std::numeric_limits<double>::infinity())), "?");
}

TEST(Progress, PlainLines) {
    const Recorder recorder;
    {
        Progress progress("render ring.glb", 100, ProgressStyle::plain, recorder.stream());
        progress.advance(42);
        progress.advance(58);  // within the same second: left to finish
    }
    EXPECT_TRUE(std::regex_match(
        recorder.text(), std::regex("render ring\\.glb: 42 % \\(0:00 elapsed, 0:00 left\\)\n"
                                    "render ring\\.glb: 100 % \\(0:00 elapsed\\)\n")))
        << recorder.text();
}

TEST(Progress, SmallStepsPrintNoLine) {
    const Recorder recorder;
    Progress progress("a", 1000, ProgressStyle::plain, recorder.stream());
    for (int i = 0; i < 39; ++i) progress.advance();
    EXPECT_EQ(recorder.text(), "");
}

TEST(Progress, JsonLinesAreEscaped) {
    const Recorder recorder;
    {
        // U+00E9 well-formed; a lone continuation, an overlong slash, a surrogate and a cut-off
        // character.
        Progress progress("a\"b\\c\n\x01 \xc3\xa9 \x80 \xc0\xaf \xed\xa0\x80 \xf0\x9f", 4,
                          ProgressStyle::json, recorder.stream());
        progress.advance(2);
        progress.finish();
        progress.finish();  // once is enough
    }
    const std::string text = recorder.text();
    const std::string bad = "\xef\xbf\xbd";
    EXPECT_EQ(text.find("{\"event\":\"progress\",\"title\":\"a\\\"b\\\\c\\u000a\\u0001 \xc3\xa9 " +
                        bad + " " + bad + bad + " " + bad + bad + bad + " " + bad + bad +
                        "\",\"done\":2,\"total\":4,\"elapsed_s\":0.0"),
              0u)
        << text;
    EXPECT_TRUE(std::regex_search(text, std::regex(",\"left_s\":0\\.[0-9]{3}\\}\n"))) << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
}

TEST(Progress, NothingDoneHasNoTimeLeft) {
    const Recorder json, plain;
    { Progress progress("a", 4, ProgressStyle::json, json.stream()); }
    { Progress progress("a", 4, ProgressStyle::plain, plain.stream()); }
    EXPECT_NE(json.text().find("\"done\":0,\"total\":4,\"elapsed_s\":0.000,\"left_s\":null}"),
              std::string::npos)
        << json.text();
    EXPECT_EQ(plain.text(), "a: 0 % (0:00 elapsed)\n");
}

TEST(Progress, TimesAreEstimatedFromWhatWasDone) {
    const Recorder recorder;
    {
        Progress progress("a", 4, ProgressStyle::json, recorder.stream());
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        progress.advance(1);
    }
    std::smatch match;
    const std::string text = recorder.text();
    ASSERT_TRUE(std::regex_search(text, match,
                                  std::regex("\"elapsed_s\":([0-9.]+),\"left_s\":([0-9.]+)\\}")));
    const double elapsed = std::stod(match[1]), left = std::stod(match[2]);
    EXPECT_GE(elapsed, 0.2);
    EXPECT_NEAR(left, 3.0 * elapsed, 0.005);  // printed to a millisecond
}

TEST(Progress, MoreThanAllIsAll) {
    const Recorder recorder;
    {
        Progress progress("a", 4, ProgressStyle::plain, recorder.stream());
        progress.advance(1000);
    }
    EXPECT_NE(recorder.text().find("a: 100 %"), std::string::npos);
}

TEST(Progress, NoneIsSilent) {
    const Recorder recorder;
    {
        Progress progress("a", 1, ProgressStyle::none, recorder.stream());
        progress.advance();
    }
    EXPECT_EQ(recorder.text(), "");
}

TEST(Progress, AutomaticIsPlainOutsideATerminal) {
    const Recorder recorder;
    {
        Progress progress("a", 1, ProgressStyle::automatic, recorder.stream());
        progress.advance();
    }
    EXPECT_EQ(recorder.text().find("a: 100 %"), 0u);
}

TEST(Progress, AutomaticIsABarOnATerminal) {
    const Variable terminal_kind("TERM", "xterm"), no_colour("NO_COLOR", "1");
    const Terminal terminal(60);
    {
        Progress progress("render", 2, ProgressStyle::automatic, terminal.stream());
        progress.advance();
    }
    // 60 columns less one; 30 cells are what title, number and the longer times leave.
    const std::string text = terminal.text();
    EXPECT_TRUE(
        std::regex_search(text, std::regex("\rrender  50 % \\[#+-+\\]  0:00 elapsed, 0:00 left *")))
        << text;
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_TRUE(text.ends_with("\n"));
    // Every state covers the one before and does not wrap.
    EXPECT_EQ(text.find('\r', 1), 60u) << text;
}

TEST(Progress, BarIsColouredUnlessNotWanted) {
    const Variable terminal_kind("TERM", "xterm"), no_colour("NO_COLOR", nullptr);
    const Terminal terminal(80);
    {
        Progress progress("render", 2, ProgressStyle::bar, terminal.stream());
        progress.advance(2);
    }
    EXPECT_NE(terminal.text().find("\x1b[36m"), std::string::npos);
}

TEST(Progress, DumbTerminalGetsLines) {
    const Variable terminal_kind("TERM", "dumb");
    const Terminal terminal(80);
    {
        Progress progress("render", 2, ProgressStyle::automatic, terminal.stream());
        progress.advance(2);
    }
    EXPECT_EQ(terminal.text().find("render: 100 %"), 0u);
}

TEST(Progress, NarrowTerminalsAndLongTitlesDoNotWrap) {
    const Variable terminal_kind("TERM", "xterm"), no_colour("NO_COLOR", "1");
    for (const unsigned short columns : {1, 2, 5, 20, 40, 200}) {
        const Terminal terminal(columns);
        {
            Progress progress(std::string(100, 'r'), 2, ProgressStyle::bar, terminal.stream());
            progress.advance(1);
        }
        const std::string text = terminal.text();
        std::size_t width = 0;
        for (const char c : text) {
            width = c == '\r' || c == '\n' ? 0 : width + 1;
            ASSERT_LT(width, columns) << text;
        }
    }
}

TEST(Progress, TitlesAreCutBetweenCharacters) {
    const Variable terminal_kind("TERM", "xterm"), no_colour("NO_COLOR", "1");
    const Terminal terminal(40);
    std::string title;
    for (int i = 0; i < 50; ++i) title += "\xc3\xa9";
    {
        Progress progress(title, 2, ProgressStyle::bar, terminal.stream());
        progress.advance(1);
    }
    EXPECT_TRUE(std::regex_search(terminal.text(), std::regex("\r(\xc3\xa9)+  50 %")));
}

TEST(Progress, ManyThreadsLoseNothing) {
    const Recorder recorder;
    {
        Progress progress("a", 40'000, ProgressStyle::json, recorder.stream());
        std::vector<std::jthread> threads;
        for (int t = 0; t < 4; ++t)
            threads.emplace_back([&] {
                for (int i = 0; i < 10'000; ++i) progress.advance();
            });
        threads.clear();
    }
    EXPECT_NE(recorder.text().find("\"done\":40000,\"total\":40000"), std::string::npos);
}

}  // namespace
}  // namespace dewbow
