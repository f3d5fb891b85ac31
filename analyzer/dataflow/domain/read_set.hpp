//! The variables that an expression reads.
#pragma once

#include "analyzer/program/model.hpp"

#include <vector>

namespace maclint::dataflow {

struct ReadSet {
    std::vector<Variable> variables;
    bool closed; ///< nothing but `variables` and constants decides the value
};

[[nodiscard]] ReadSet variables_of(const Program& program, ExpressionId expression);

} // namespace maclint::dataflow
