//! The page of a code in a language without chapters of codes: what its modal group says of it.
#pragma once

#include "analyzer/program/tables.hpp"
#include "cli/report/plain_page.hpp"

#include <string>
#include <string_view>

namespace maclint::cli {

/// For a code as the control spells it, any case: "G41", "DIAMON"; empty where no group of it has the code,
/// or where chapters say more.
[[nodiscard]] std::string plain_group_page(const ControlModel& control, std::string_view code,
                                           const PageStyle& style);

/// Markdown of a few lines for an editor, of any code that is in a group; empty where none has it.
[[nodiscard]] std::string short_group_page(const ControlModel& control, std::string_view code);

} // namespace maclint::cli
