// SPDX-License-Identifier: Apache-2.0

// Absurd values for every option that takes one, by the list that the program's own help prints: an
// option that is new, and that this test does not know, turns it red.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "run_program.h"

namespace dewbow::faults {
namespace {

constexpr int kWrongUse = 2;

/// No number of any option, however it is read: no whole number from 0 on, no number with a unit.
const std::vector<std::string> kNoNumbers{
    "",
    " ",
    "nan",
    "NaN",
    "-nan",
    "inf",
    "-inf",
    "infinity",
    "1e308",
    "-1e308",
    "1,5",
    "0x10",
    "1_000",
    "1e",
    "1 ",
    " 1",
    "--1",
    "+-1",
    "1.5.2",
    "one",
    "true",
    "１",
    "½",
    "1;2",
    "1\n2",
    "\xff",
    "$(id)",
    "1e999",
    "%d",
    "-",
    "9223372036854775808e9999",
};

struct Option {
    std::string name;
    std::vector<std::string> words_before;  ///< another option that it needs
    std::vector<std::string> wrong;         ///< beside kNoNumbers
    std::string expected;                   ///< what every refusal says
};

const std::vector<Option> kRenderOptions{
    {"--camera", {}, {"main"}, "--camera"},
    {"--glass", {}, {"=", "a=", "=b", "a=N-BK7", "a=b=c"}, "--glass"},
    {"--env", {}, {"scene.toml", "gone.exr", "."}, "--env"},
    {"--set",
     {},
     {"=", "=1", "film", "film.width=", "film.width=0", "film.widht=8", "film=8", "film..width=8",
      "film.width=8=8", "shapes.2.type=\"sphere\"", "[film]width=8"},
     "--set"},
    {"--size",
     {},
     {"0x0", "0x8", "8x0", "-8x8", "8x-8", "70000x70000", "8", "8x", "x8", "8X8", "8x8x8", "8.5x8",
      "nanxnan", "2147483648x1", "8 x 8", "1e1x8"},
     "1 to 65536 pixels"},
    {"--spp",
     {},
     {"-1", "0", "-0", "0.5", "1e3", "2147483648", "9223372036854775808", "5e-324"},
     "1 to 16777216"},
    {"--time",
     {},
     {"-1", "0", "0s", "-0s", "s", "1d", "1ms", "1s30", "nans", "infh", "1e308h", "8761h", "-1m"},
     "a time such as 30s"},
    {"--noise", {}, {"-1", "0", "-0", "1.5", "1%", "5e-324"}, "1e-06 to 1"},
    {"--crop",
     {},
     {"-1", "0", "0,0", "0,0,0x0", "-1,0,4x4", "0,-1,4x4", "0,0,4", "0,0,4x", "4x4", "0,0,4x4,1",
      "0;0;4x4", "nan,0,4x4", "0,0,9x9", "8,8,1x1", "0,0,70000x1", "9223372036854775807,0,1x1"},
     "--crop is"},
    {"--slice",
     {},
     {"-1", "0", "1", "1/", "/1", "0/4", "5/4", "1/0", "-1/4", "1/-4", "1/1000001", "1/4/4",
      "1.0/4", "0x1/4", "1 /4", "9223372036854775808/9223372036854775808"},
     "K/N such as 2/8"},
    {"--threads", {}, {"-1", "0", "0.5", "1025", "2147483648", "9223372036854775808"}, "1 to 1024"},
    {"--seed", {}, {"-1", "0.5", "1e3", "18446744073709551616"}, "0 to 18446744073709551615"},
    {"--packet",
     {},
     {"-1", "0", "2", "3", "32", "4.0", "04", "2147483648"},
     "it must be 1, 4, 8 or 16"},
    {"--exposure", {}, {"64.5", "-65", "1stop"}, "-64 to 64"},
    {"--spectral-bins", {}, {"-1", "0.5", "941", "2147483648"}, "0 to 940"},
    {"--max-depth", {}, {"-1", "0.5", "100001", "2147483648"}, "0 to 100000"},
    {"--pixel",
     {"--sample", "0"},
     {"-1", "0", "0,", ",0", "-1,0", "0,-1", "8,0", "0,8", "0,0,0", "0x0", "65536,0", "nan,nan"},
     "--pixel is"},
    {"--sample",
     {"--pixel", "0,0"},
     {"-1", "0.5", "16777216", "9223372036854775808"},
     "0 to 16777215"},
    {"--frame", {}, {"-1", "1e10", "one", "0x1"}, "0 to 1000000000"},
    {"--fps", {"--frame", "1"}, {"-24", "0", "1e10", "24fps"}, "0.001 to 1000000000"},
    {"--gamut", {}, {"0", "-1", "Clip", "towards_white"}, "--gamut is"},
    {"--wavelengths", {}, {"0", "Visual", "visible", "550"}, "--wavelengths is"},
    {"--checkpoint", {}, {"0", "dewbow", "a.dewbow/", "a.exr", "/", "."}, "ends in .dewbow"},
    {"--checkpoint-every", {}, {"-1", "0", "0s", "s", "1d", "1ms", "8761h"}, "a time such as 30s"},
    {"--resume", {}, {"0", "dewbow", "a.dewbow/", "a.exr", "/", "."}, "ends in .dewbow"},
    {"--estimator", {}, {"0", "PATH", "path "}, "--estimator is"},
    {"--progress", {}, {"0", "Auto", "bars"}, "--progress is"},
    {"--output", {}, {"0", "png", "a.PNGG", "a.exr/", "/", ".", ".."}, "ends in .exr or .png"},
};
const std::vector<Option> kGlassOptions{
    {"--at", {}, {"-1", "0", "199.9", "3001", "550 nm", "5e-324", "0.1um", "x"}, "200 to 3000"},
    {"--plot", {}, {"0", "svg", "a.svgz", "a.png", "/", "."}, "ends in .svg"},
};

const std::vector<Option> kGlassPaperOptions{
    {"--eta-red", {}, {"-1", "0", "1", "10.1", "1,5"}, "--eta-red"},
    {"--w", {}, {"-0.1", "1001", "0.5.5"}, "--w"},
    {"--spacing", {}, {"Frequency", "lambda", "frequency,wavelength"}, "--spacing"},
    {"--plot", {}, {"0", "svg", "a.png", "/", "."}, "ends in .svg"},
};

const std::vector<Option> kRainbowOptions{
    {"--model", {}, {"MIE", "mie,", ",", "mie,mei"}, "--model"},
    {"--order", {}, {"-1", "8", "2,", "2,9", "1.5"}, "from 0 to 7"},
    {"--tolerance", {}, {"0", "-1", "1", "2%"}, "between 0.0001 and 0.5"},
    {"--radius",
     {},
     {"0", "0mm", "-1mm", "1m", "11mm", "0.1nm", "nanmm", "infum", "mm", "0.3", "0.3 mm", "0.3in"},
     "from 1nm to 10mm"},
    {"--sizes",
     {},
     {"0", "0mm", "1m", "normal", "normal:", "normal:mean=1mm", "normal:mean=1mm,width=-1",
      "normal:mean=1mm,width=nan", "rain:marshall-palmer,rate=0mm/h", "sleet:rate=1mm/h"},
     "--sizes"},
    {"--shape", {}, {"0", "round", "Oblate"}, "--shape is"},
    {"--oscillation", {"--shape", "oblate"}, {"-0.1", "1.1"}, "between 0 and 1"},
    {"--tilt", {"--shape", "oblate"}, {"-1", "31", "3rad"}, "between 0 and 30"},
    {"--haze", {"--redden"}, {"-0.1", "5.1"}, "between 0 and 5"},
    {"--clock-angle", {}, {"-181", "181"}, "between -180 and 180"},
    {"--water", {}, {"F55", "water@", "water@200C", "fluid/"}, "--water"},
    {"--air", {}, {"F55", "water@", "aether"}, "--air"},
    {"--index",
     {},
     {"0", "0.9", "1", "-1.3", "11", "i", "+i", "1.3+i", "1.3-0.1i", "1.3+11i", "1.3+nani", "1.3j"},
     "n above 1 and at most 10"},
    {"--size-parameter", {"--index", "1.3"}, {"0", "-1", "50001", "1e-4"}, "0.001 and 50000"},
    {"--sun-altitude", {}, {"-1", "90.1", "20rad"}, "between 0 and 90"},
    {"--sun-radius", {}, {"-0.1", "5.1"}, "between 0 and 5"},
    {"--limb-darkening", {}, {"-0.1", "1.1"}, "between 0 and 1"},
    {"--illuminant", {}, {"D66", "sun", "5500K"}, "--illuminant"},
    {"--wavelengths",
     {},
     {"0", "-500", "99", "20001", "500,400", "500,500", "500,", "400:700", "400:700:0", "700:400:5",
      "400:700:5:1", "400:700:-5", "400:700:1e-9", "green"},
     "between 100 and 20000 nm"},
    {"--angles",
     {},
     {"-1", "180.1", "20,10", "0:180", "0:180:0", "180:0:1", "0:180:1e-9", "0..180"},
     "between 0 and 180 deg"},
    {"--polarisation", {}, {"0", "s", "Parallel", "both"}, "--polarisation is"},
    {"--polariser", {}, {"361", "-361", "90rad"}, "between -360 and 360"},
    {"--output", {}, {"0", "csv", "a.csvv", "a.exr/", "/", ".", ".."}, "ends in .csv"},
    {"--plot", {}, {"=", "rays", "rays=", "=a.svg", "rays=a.png", "rais=a.svg"}, "--plot is"},
    {"--threads", {}, {"-1", "0", "0.5", "1025"}, "1 to 1024"},
};

const std::vector<Option> kSpectrumOptions{
    {"--colours", {}, {"0", "Linear", "rgb", "linear,cie"}, "--colours is"},
    {"--monitor", {}, {"0", "sRGB", "rodgers", "crt"}, "--monitor is"},
    {"--negative", {"--colours", "empirical"}, {"0", "clip", "Clamp"}, "--negative is"},
    {"--spacing", {}, {"0", "even", "f"}, "--spacing is"},
    {"--samples", {}, {"-1", "0", "0.5", "1001", "2147483648", "9223372036854775808"}, "1 to 1000"},
    {"--jitter", {}, {"0", "Both", "index,colour"}, "--jitter is"},
    {"--sets", {}, {"-1", "0", "0.5", "1000001", "2147483648"}, "1 to 1000000"},
    {"--seed", {}, {"-1", "0.5", "1e3", "18446744073709551616"}, "0 to 18446744073709551615"},
    {"--gamma", {}, {"0", "-2.2", "0.09", "10.1", "5e-324"}, "0.1 to 10"},
    {"--output", {}, {"0", "csv", "a.exr", "a.exr/", "/", ".", ".."}, "ends in .csv"},
    {"--plot",
     {},
     {"=", "curves", "curves=", "=a.svg", "curves=a.png", "curvs=a.svg", "white=a.json"},
     "--plot is"},
};

/// Names of the options that take a value: in lines such as "  -o,--output FILE   A picture".
std::set<std::string> options_of_help(const std::vector<std::string>& subcommand) {
    const Folder folder;
    std::vector<std::string> arguments = subcommand;
    arguments.push_back("--help");
    const std::string help = run_program(DEWBOW_BINARY, arguments, folder.path()).standard_output;
    std::set<std::string> names;
    for (std::size_t at = 0; at < help.size(); at = help.find('\n', at) + 1) {
        const std::string line = help.substr(at, help.find('\n', at) - at);
        const std::size_t name = line.find("--");
        if (!line.starts_with("  -") || name == std::string::npos) continue;
        const std::size_t end = std::min(line.find(' ', name), line.size());
        const bool takes_value = end + 1 < line.size() && line[end + 1] != ' ';
        if (takes_value) names.insert(line.substr(name, end - name));
    }
    return names;
}

std::set<std::string> names_of(const std::vector<Option>& options) {
    std::set<std::string> names;
    for (const Option& option : options) names.insert(option.name);
    return names;
}

/// Written --name=value where the value would else look like an option.
void refuses(const std::vector<std::string>& command, const Option& option,
             const std::string& value, const Folder& folder) {
    std::vector<std::string> arguments = command;
    arguments.insert(arguments.end(), option.words_before.begin(), option.words_before.end());
    if (value.starts_with("-")) {
        arguments.push_back(option.name + "=" + value);
    } else {
        arguments.insert(arguments.end(), {option.name, value});
    }
    const Outcome outcome = run_program(DEWBOW_BINARY, arguments, folder.path());
    EXPECT_EQ(faults_of_answer(outcome, kWrongUse, {option.name, option.expected}), "")
        << option.name << " \"" << value << '"';
}

/// Of kNoNumbers, what some options take: lists of two numbers, and no file for --resume.
const std::set<std::pair<std::string, std::string>> right_after_all{
    {"--resume", ""}, {"--pixel", "1,5"}, {"--order", "1,5"}, {"--angles", "1,5"}};

void refuse_all(const std::vector<std::string>& command, const std::vector<Option>& options) {
    const Folder folder;
    folder.put("scene.toml", "[film]\nwidth = 8\nheight = 8\n[render]\nsamples_per_pixel = 1\n");
    folder.put("scene.png", "an older picture");
    const auto before = folder.snapshot();
    for (const Option& option : options) {
        for (const std::string& value : kNoNumbers) {
            const bool is_right = right_after_all.contains({option.name, value});
            if (!is_right) refuses(command, option, value, folder);
        }
        for (const std::string& value : option.wrong) refuses(command, option, value, folder);
    }
    EXPECT_EQ(folder.snapshot(), before);
}

TEST(Options, AllAreInTheTable) {
    EXPECT_EQ(options_of_help({"render"}), names_of(kRenderOptions));
    EXPECT_EQ(options_of_help({"glass", "show"}), names_of(kGlassOptions));
    EXPECT_EQ(options_of_help({"glass", "paper"}), names_of(kGlassPaperOptions));
    EXPECT_EQ(options_of_help({"rainbow"}), names_of(kRainbowOptions));
    EXPECT_EQ(options_of_help({"spectrum"}), names_of(kSpectrumOptions));
    for (const std::string& name : options_of_help({"scene", "check"}))
        EXPECT_TRUE(names_of(kRenderOptions).contains(name)) << name;
}

TEST(Options, OfRenderRefuseAbsurdValues) { refuse_all({"render", "scene.toml"}, kRenderOptions); }

TEST(Options, OfGlassRefuseAbsurdValues) { refuse_all({"glass", "show", "N-BK7"}, kGlassOptions); }

TEST(Options, OfPapersIndexRefuseAbsurdValues) {
    refuse_all({"glass", "paper", "--eta-red", "2", "--w", "0.1"}, kGlassPaperOptions);
}

TEST(Options, OfRainbowRefuseAbsurdValues) { refuse_all({"rainbow"}, kRainbowOptions); }

TEST(Options, OfSpectrumRefuseAbsurdValues) { refuse_all({"spectrum"}, kSpectrumOptions); }

TEST(Options, OfSpectrumThatContradictEachOther) {
    const Folder folder;
    const auto before = folder.snapshot();
    const auto check = [&](const std::vector<std::string>& arguments, const std::string& phrase) {
        const Outcome outcome = run_program(DEWBOW_BINARY, arguments, folder.path());
        EXPECT_EQ(faults_of_answer(outcome, kWrongUse, {phrase}), "");
    };
    check({"spectrum", "--negative", "keep", "-o", "a.csv"},
          "--negative is of --colours empirical");
    check({"spectrum", "--correlated", "-o", "a.csv"}, "--jitter is missing");
    check({"spectrum", "--sets", "5", "-o", "a.csv"}, "--sets and --seed are of samples");
    check({"spectrum", "--jitter", "index", "--seed", "5"}, "--sets and --seed are of samples");
    check({"spectrum", "--gamma", "2.2"}, "--gamma is of files that show colours");
    check({"spectrum", "--gamma", "2.2", "-o", "a.csv", "-o", "a.json"},
          "--gamma is of files that show colours");
    check({"spectrum", "--gamma", "2.2", "--jitter", "both", "--plot", "white=a.svg"},
          "--gamma is of files that show colours");
    check({"spectrum", "--samples", "1", "-o", "a.csv"}, "--samples: spectral samples of fixed");
    EXPECT_EQ(folder.snapshot(), before);
}

/// The least and the most that an option takes is taken: the limits that messages state are true.
TEST(Options, LimitsAreTaken) {
    const std::vector<std::vector<std::string>> right{
        {"--seed", "18446744073709551615"},
        {"--seed", "0"},
        {"--threads", "1024"},
        {"--packet", "16"},
        {"--packet", "1"},
        {"--exposure", "-64"},
        {"--exposure", "64"},
        {"--spectral-bins", "0"},
        {"--spectral-bins", "940"},
        {"--max-depth", "0"},
        {"--max-depth", "100000"},
        {"--crop", "7,7,1x1"},
        {"--noise", "1"},
        {"--time", "5e-324s"},
        {"--size", "1x1"},
    };
    for (const std::vector<std::string>& words : right) {
        const Folder folder;
        folder.put("scene.toml",
                   "[film]\nwidth = 8\nheight = 8\n[render]\nsamples_per_pixel = 1\n");
        std::vector<std::string> arguments{"render",  "scene.toml", "-o",
                                           "new.exr", "-o",         "new.png"};
        arguments.insert(arguments.end(), words.begin(), words.end());
        const Outcome outcome = run_program(DEWBOW_BINARY, arguments, folder.path());
        EXPECT_EQ(outcome.exit_code, 0) << words[0] << ' ' << words[1] << outcome.standard_error;
        EXPECT_EQ(folder.snapshot().size(), 3u) << words[0] << ' ' << words[1];
    }
}

TEST(Options, LimitsOfThePapersModelsAreTaken) {
    const std::vector<std::vector<std::string>> right{
        {"spectrum", "--samples", "1", "--jitter", "both", "--sets", "1", "--seed", "0"},
        {"spectrum", "--samples", "1000"},
        {"spectrum", "--json", "--quiet", "--gamma", "0.1", "-o", "a.png"},
        {"spectrum", "--json", "--quiet", "--gamma", "10", "--plot", "sums=a.svg"},
        {"spectrum", "--colours", "cie", "--jitter", "colour", "--sets", "1"},
        {"glass", "paper", "--eta-red", "1.0001", "--w", "0"},
        {"glass", "paper", "--eta-red", "10", "--w", "1000"},
    };
    for (const std::vector<std::string>& words : right) {
        const Folder folder;
        const Outcome outcome = run_program(DEWBOW_BINARY, words, folder.path());
        EXPECT_EQ(outcome.exit_code, 0) << words[0] << ' ' << words[2] << outcome.standard_error;
        EXPECT_EQ(outcome.standard_error, "");
        EXPECT_NE(outcome.standard_output, "");
    }
}

}  // namespace
}  // namespace dewbow::faults
