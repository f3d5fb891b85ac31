//! Runs programs with chance for all that nobody can know, and holds the analysis against it.
#pragma once

#include "tests/support/analysed.hpp"
#include "tests/support/dice.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace maclint::test {

/// The first claim about the programs that a run refutes. `held` counts what was held against the runs.
[[nodiscard]] std::optional<std::string> refuted(const std::vector<NamedText>& files, Dice& dice,
                                                 std::map<std::string, std::size_t>& held);

} // namespace maclint::test
