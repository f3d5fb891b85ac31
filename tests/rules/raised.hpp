//! What a rule says about a text, for tests.
#pragma once

#include "rules/rule.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::test {

/// 1-based lines on which the rule speaks of the Fanuc text, in their order.
[[nodiscard]] std::vector<std::uint32_t> lines_raised(std::string_view code, std::string text);
/// The messages, in the order of the lines.
[[nodiscard]] std::vector<std::string> messages_raised(std::string_view code, std::string text);
/// The findings with their severity and line: "note 3", "warning 5".
[[nodiscard]] std::vector<std::string> judged(std::string_view code, const std::string& text);
/// Lines of the steps of the only finding's path.
[[nodiscard]] std::vector<std::uint32_t> path_raised(std::string_view code, std::string text);

} // namespace maclint::test
