//! A configuration for a folder, with comments that say why, for `maclint init`.
#pragma once

#include "cli/setup/survey.hpp"

#include <string>

namespace maclint::cli {

/// The text of a .maclint.json: what is certain is set, what only the shop knows stands in comments. Lines
/// end with a line feed.
[[nodiscard]] std::string proposed_configuration(const Survey& survey);

} // namespace maclint::cli
