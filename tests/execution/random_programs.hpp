//! Random programs that call each other, in both languages: not sensible, but using everything.
#pragma once

#include "tests/support/analysed.hpp"
#include "tests/support/dice.hpp"

#include <vector>

namespace maclint::test {

/// A main program, some that it or they call, and calls of programs that are not there.
[[nodiscard]] std::vector<NamedText> random_fanuc_programs(Dice& dice);
[[nodiscard]] std::vector<NamedText> random_dinplus_programs(Dice& dice);

} // namespace maclint::test
