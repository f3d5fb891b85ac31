//! Rules as JSON, for `rules --format json` and `explain --format json`; docs/json.md describes it.
#pragma once

#include "rules/rule.hpp"

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace maclint::cli {

[[nodiscard]] nlohmann::ordered_json rule_as_json(const Rule& rule);

/// All rules, with the version of the format and that of maclint.
[[nodiscard]] std::string json_rules();

} // namespace maclint::cli
