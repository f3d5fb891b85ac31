//! Reports of maclint, which quote programs and must not be taken for one.
#pragma once

#include <string_view>

namespace maclint::cli {

/// Whether the whole text is what text, concise and GitHub reports and standard error consist of; it may be
/// cut off. The other formats are JSON and XML. A program is none, whatever stands before, behind or within
/// it.
[[nodiscard]] bool is_own_report(std::string_view text);

} // namespace maclint::cli
