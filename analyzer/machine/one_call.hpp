//! What is known of a program where only one call of it is looked at.
#pragma once

#include "analyzer/program/ids.hpp"

#include <optional>
#include <unordered_map>
#include <vector>

namespace maclint::machine {

struct OneCall {
    std::unordered_map<ExpressionId, double>
        numbers;                      ///< of words that are calculated, as far as they are known
    std::vector<bool> passable;       ///< of every edge, whether it can be taken
    std::optional<double> plane = {}; ///< the code in force when it is called, where that is known
};

} // namespace maclint::machine
