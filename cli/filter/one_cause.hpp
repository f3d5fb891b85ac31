//! One cause, one finding: rules that yield to others.
#pragma once

#include "rules/rule.hpp"

#include <functional>
#include <vector>

namespace maclint::cli {

/// Drops the findings of rules that yield to one which has found the same cause where it `is_on`.
void drop_yielding(std::vector<Finding>& findings, const std::function<bool(const Finding&)>& is_on);

} // namespace maclint::cli
