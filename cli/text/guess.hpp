//! Guesses at what a mistyped, shortened or half remembered word means.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli {

/// The candidates that a word most likely means, in any case, at most three, in their order: those that it
/// begins or is short for; else those of whose words (between '-', '/' and '.') it is one; else the nearest,
/// of which a third of the letters may be wrong, one where it holds digits; else those that begin it, and
/// nothing longer.
[[nodiscard]] std::vector<std::string> likely(std::string_view word, std::span<const std::string> candidates);

/// The nearest candidate alone, by letters.
[[nodiscard]] std::optional<std::string> closest(std::string_view word,
                                                 std::span<const std::string> candidates);

/// " Did you mean 'x' or 'y'?", or what to say when nothing is near.
[[nodiscard]] std::string did_you_mean(std::string_view word, std::span<const std::string> candidates,
                                       std::string_view otherwise);

/// " Did you mean 'x' or 'y'?" of what is meant, which is not empty.
[[nodiscard]] std::string meant(const std::vector<std::string>& words);

} // namespace maclint::cli
