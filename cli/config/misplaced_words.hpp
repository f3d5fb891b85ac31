//! Words of rules that stand where a configuration has no place for them, and where they belong.
#pragma once

#include <string>
#include <string_view>

namespace maclint::cli {

/// What to write in place of a key that a configuration has not: one that names rules, or that other linters
/// have. Empty: nothing is known of it. Without a full stop.
[[nodiscard]] std::string advice_for_key(std::string_view key);

/// What to write for a severity that means that the rules are off or as they come, as
/// ", or put \"MAC501\" …"; empty for any other word.
[[nodiscard]] std::string advice_for_severity(std::string_view rules, std::string_view word);

} // namespace maclint::cli
