//! What messages begin with where a reader sees many of them together.
#pragma once

#include "rules/rule.hpp"

#include <string>

namespace maclint::cli {

/// The rule's name in words with a colon and a blank. Viewers head the findings of a rule with the words that
/// their messages have in common: it stands before those of rules whose messages begin differently; empty for
/// the others.
[[nodiscard]] std::string heading_of(const Rule& rule);

} // namespace maclint::cli
