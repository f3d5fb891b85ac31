//! What the analysis claims of random programs, held against running them.
#include "tests/execution/random_programs.hpp"
#include "tests/execution/soundness.hpp"

#include <cstdlib>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace maclint::test {
namespace {

template<class Generate>
void expect_sound(unsigned programs, const Generate& generate) {
    std::map<std::string, std::size_t> held;
    const char* only = std::getenv("SOUNDNESS_SEED");
    for (unsigned seed = only != nullptr ? static_cast<unsigned>(std::atoi(only)) : 0; seed < programs;
         ++seed) {
        Dice dice(seed);
        const std::vector<NamedText> files = generate(dice);
        if (const auto what = refuted(files, dice, held)) {
            std::string texts;
            for (const auto& [path, text] : files)
                texts.append("--- ").append(path).append("\n").append(text);
            ADD_FAILURE() << "seed " << seed << ": " << *what << "\n" << texts;
            return;
        }
    }
    if (std::getenv("SOUNDNESS_STATISTICS") != nullptr)
        for (const auto& [kind, times] : held) std::cout << times << ' ' << kind << '\n';
}

/// More of them on demand, to look for what is rare.
unsigned count(unsigned usual) {
    const char* more = std::getenv("SOUNDNESS_PROGRAMS");
    return more == nullptr ? usual : static_cast<unsigned>(std::atoi(more));
}

TEST(Soundness, WhatRunsOfMacrosShowIsWhatTheAnalysisAllows) {
    expect_sound(count(1500), random_fanuc_programs);
}

TEST(Soundness, WhatRunsOfDinPlusShowIsWhatTheAnalysisAllows) {
    expect_sound(count(1000), random_dinplus_programs);
}

} // namespace
} // namespace maclint::test
