//! Reports of maclint, which quote programs and must not be taken for one.
#pragma once

#include <string_view>

namespace maclint::cli {

/// Whether a text begins like a text, concise or GitHub report: with a finding, the summary or
/// a message. The other formats are JSON and XML.
[[nodiscard]] bool is_own_report(std::string_view text);

} // namespace maclint::cli
