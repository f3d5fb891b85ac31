//! Words from the user: compared in any case, and guessed at when they are mistyped.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli {

[[nodiscard]] std::string in_lower_case(std::string_view text);
[[nodiscard]] std::string in_upper_case(std::string_view text);

/// The candidate that a mistyped word most likely means, in any case: a third of its letters may be wrong,
/// one when it holds digits.
[[nodiscard]] std::optional<std::string> closest(std::string_view word,
                                                 std::span<const std::string> candidates);

/// " Did you mean 'x'?", or what to say when nothing is near.
[[nodiscard]] std::string did_you_mean(std::string_view word, std::span<const std::string> candidates,
                                       std::string_view otherwise);

/// "1 error", "2 errors".
[[nodiscard]] std::string counted(std::size_t count, std::string_view noun);

/// Text of unknown encoding, such as a file's name, fit for a terminal.
[[nodiscard]] std::string shown(std::string_view bytes);

} // namespace maclint::cli
