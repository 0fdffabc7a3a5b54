// SPDX-License-Identifier: Apache-2.0

// Wrong drops, suns, models and storm files, given to `dewbow rainbow`.

#include <gtest/gtest.h>

#include "run_program.h"

namespace dewbow::faults {
namespace {

constexpr int kWrongInput = 1, kWrongUse = 2;
using Words = std::vector<std::string>;

struct Row {
    Words arguments;  ///< after "rainbow"
    int exit_code;
    Words phrases;
    std::string storm = {};  ///< what is in storm.toml
};

void check(const std::vector<Row>& rows) {
    for (const Row& row : rows) {
        const Folder folder;
        folder.put("storm.toml", row.storm);
        folder.put("old.csv", "an older curve");
        Words arguments{"rainbow"};
        arguments.insert(arguments.end(), row.arguments.begin(), row.arguments.end());
        const auto before = folder.snapshot();
        const Outcome outcome = run_program(DEWBOW_BINARY, arguments, folder.path());
        std::string shown;
        for (const std::string& word : arguments) shown += word + ' ';
        EXPECT_EQ(faults_of_answer(outcome, row.exit_code, row.phrases), "") << shown;
        EXPECT_EQ(folder.snapshot(), before) << shown;
    }
}

TEST(RainbowWrongInput, Drops) {
    check({
        {{"--radius", "0mm"}, kWrongUse, {"--radius is \"0mm\"", "from 1nm to 10mm"}},
        {{"--radius=-1mm"}, kWrongUse, {"--radius is \"-1mm\""}},
        {{"--radius", "nanmm"}, kWrongUse, {"--radius is \"nanmm\""}},
        {{"--radius", "1m"}, kWrongUse, {"--radius is \"1m\""}},
        {{"--radius", "0.3"}, kWrongUse, {"a length with its unit such as 0.3mm"}},
        {{"--sizes", "gama:mean=1mm,width=0.1"}, kWrongUse, {"--sizes: ", "gamma"}},
        {{"--sizes", "gamma:mean=1mm,width=0"}, kWrongUse, {"--sizes: "}},
        {{"--sizes", ""}, kWrongUse, {"--sizes: "}},
        {{"--radius", "1mm", "--sizes", "1mm"}, kWrongUse, {"contradict each other; keep one"}},
        {{"--index", "0.9"}, kWrongUse, {"--index is 0.9", "n above 1"}},
        {{"--index", "1.33-1e-8i"}, kWrongUse, {"--index is \"1.33-1e-8i\"", "1.33+1e-8i"}},
        {{"--index", "1.3", "--water", "water"}, kWrongUse, {"keep one or the others"}},
        {{"--water", "watr"}, kWrongUse, {"--water: unknown glass \"watr\"", "fluid/water"}},
        {{"--water", "gone.agf#A"}, kWrongInput, {"gone.agf: cannot read"}},
        {{"--shape", "oblate"}, kWrongUse, {"\"auto\" does not know flattened drops of one size"}},
        {{"--shape", "oblate", "--model", "mie"}, kWrongUse, {"\"mie\" does not know flattened"}},
        {{"--tilt", "3"}, kWrongUse, {"flattened drops", "--shape oblate"}},
        {{"--air", "water"}, kWrongInput, {"have the index 0.9", "above 1"}},
        {{"--water", "vacuum"}, kWrongInput, {"have the index 0.9", "above 1"}},
    });
}

TEST(RainbowWrongInput, LightAndAngles) {
    check({
        {{"--wavelengths", "1500", "-o", "old.csv"},
         kWrongInput,
         {"no index of fluid/water@20C at 1500 nm", "data are of 200 to 1100 nm"}},
        {{"--wavelengths", "400:700:0"}, kWrongUse, {"--wavelengths is"}},
        {{"--wavelengths", "900", "--plot", "strip=a.png"}, kWrongInput, {"visible"}},
        {{"--angles", "181"}, kWrongUse, {"--angles is", "between 0 and 180 deg"}},
        {{"--angles", "30,20"}, kWrongUse, {"ascending"}},
        {{"--angles", "0:180:1e-9"}, kWrongUse, {"at most 100000 steps"}},
        {{"--angles", "30", "--plot", "intensity=a.svg"}, kWrongInput, {"two angles or more"}},
        {{"--illuminant", "D66"}, kWrongUse, {"--illuminant: unknown lamp \"D66\""}},
        {{"--haze", "0.2"}, kWrongUse, {"haze counts where the sun is reddened", "--redden"}},
        {{"--point-sun", "--sun-radius", "1"}, kWrongUse, {"--point-sun contradicts"}},
        {{"--sun-altitude", "95"}, kWrongUse, {"--sun-altitude is 95", "between 0 and 90 deg"}},
        {{"--polarisation", "parallel", "--polariser", "0"}, kWrongUse, {"contradict"}},
    });
}

TEST(RainbowWrongInput, ModelsAndFiles) {
    check({
        {{"--model", "mei"}, kWrongUse, {"--model is \"mei\"", "did you mean \"mie\"?"}},
        {{"--model", ""}, kWrongUse, {"--model is \"\""}},
        {{"--model", "mie,"}, kWrongUse, {"--model is \"mie,\""}},
        {{"--order", "8"}, kWrongUse, {"--order is 8", "from 0 to 7"}},
        {{"--model", "mie", "--order", "2"}, kWrongInput, {"order"}},
        {{"--plot", "lee"}, kWrongUse, {"--plot is \"lee\"", "KIND=FILE"}},
        {{"--plot", "ray=a.svg"}, kWrongUse, {"unknown plot \"ray\"", "did you mean \"rays\"?"}},
        {{"--plot", "rays=a.png"}, kWrongUse, {"--plot is \"a.png\"", "ends in .svg"}},
        {{"--plot", "rays=a.svg", "--order", "1"}, kWrongInput, {"no bow of order 1"}},
        {{"-o", "a.txt"}, kWrongUse, {"--output is \"a.txt\"", ".csv"}},
        {{"-o", "missing/a.csv"}, kWrongInput, {"missing/a.csv"}},
        {{"gone.toml"}, kWrongInput, {"gone.toml"}},
        {{"storm.toml"}, kWrongInput, {"storm.toml:1:1: unknown key \"rain\""}, "rain = 1"},
        {{"storm.toml"}, kWrongInput, {"storm.toml:1:9: not TOML"}, "model = "},
        {{"storm.toml", "second.toml"}, kWrongUse, {"second.toml"}},
        {{"--paper", "--model", "mie"}, kWrongUse, {"--paper is a rainbow of its own", "--model"}},
        {{"storm.toml", "--paper"}, kWrongUse, {"--paper is a rainbow of its own", "storm"}},
        {{"--paper", "-o", "a.exr"}, kWrongUse, {"expected -o FILE.csv, found \"a.exr\""}},
        {{"--redius", "1mm"}, kWrongUse, {"--redius", "--radius"}},
    });
}

TEST(RainbowWrongInput, OneSphere) {
    const auto sphere = [](Words words) {
        words.insert(words.begin(), {"--size-parameter", "10"});
        return words;
    };
    check({
        {{"--size-parameter", "0", "--index", "1.3"}, kWrongUse, {"--size-parameter is 0"}},
        {{"--size-parameter", "nan", "--index", "1.3"}, kWrongUse, {"between 0.001 and 50000"}},
        {{"--size-parameter", "1e6", "--index", "1.3"}, kWrongUse, {"between 0.001 and 50000"}},
        {sphere({}), kWrongUse, {"needs its index", "--index 1.333"}},
        {{"--amplitudes"}, kWrongUse, {"--size-parameter is missing"}},
        {sphere({"--index", "1.3", "--amplitudes", "-o", "a.csv"}), kWrongUse, {"neither -o"}},
        {sphere({"--index", "1.3", "--sun-altitude", "5"}),
         kWrongUse,
         {"neither sun nor sizes", "--sun-altitude"}},
        {sphere({"--index", "1.3", "--radius", "1mm"}), kWrongUse, {"contradict"}},
        {sphere({"--index", "1.3", "--model", "mie,descartes"}), kWrongUse, {"expected one"}},
        {sphere({"--index", "1.3", "--model", "descartes", "--amplitudes"}),
         kWrongUse,
         {"\"descartes\" has no amplitudes"}},
        {sphere({"--index", "1.3+0.1i", "--model", "debye", "--order", "2"}),
         kWrongInput,
         {"do not absorb"}},
        {sphere({"--wavelengths", "400,500", "--plot", "intensity=a.svg"}),
         kWrongUse,
         {"--size-parameter is of one wavelength"}},
    });
}

}  // namespace
}  // namespace dewbow::faults
