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

/// Of the environment; `usual` where it says nothing.
unsigned number(const char* name, unsigned usual) {
    const char* said = std::getenv(name);
    return said == nullptr ? usual : static_cast<unsigned>(std::strtoul(said, nullptr, 10));
}

/// ./dev random throws more of them, from another seed on.
template<class Generate>
void expect_sound(unsigned usual_programs, const Generate& generate) {
    std::map<std::string, std::size_t> held;
    const unsigned first = number("SOUNDNESS_SEED", 0);
    const unsigned programs = number("SOUNDNESS_PROGRAMS", usual_programs);
    for (unsigned thrown = 0; thrown < programs; ++thrown) {
        const unsigned seed = first + thrown;
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

TEST(Soundness, WhatRunsOfMacrosShowIsWhatTheAnalysisAllows) { expect_sound(1500, random_fanuc_programs); }

TEST(Soundness, WhatRunsOfDinPlusShowIsWhatTheAnalysisAllows) { expect_sound(1000, random_dinplus_programs); }

} // namespace
} // namespace maclint::test
