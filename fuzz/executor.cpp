//! Flow and data flow of random programs, which the input throws, held against running them.
#include "fuzz/harness.hpp"
#include "tests/execution/random_programs.hpp"
#include "tests/execution/soundness.hpp"

using namespace maclint;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    test::Dice dice(std::span(data, size));
    const auto files =
        dice.one_in(2) ? test::random_fanuc_programs(dice) : test::random_dinplus_programs(dice);
    std::map<std::string, std::size_t> held;
    if (const auto claim = test::refuted(files, dice, held)) {
        std::string texts;
        for (const auto& [path, text] : files) texts.append("--- ").append(path).append("\n").append(text);
        fuzz::fail(*claim + "\n" + texts);
    }
    return 0;
}
