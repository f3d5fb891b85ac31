//! The rules that speak of a variable or a word, below its page.
#pragma once

#include "analyzer/program/tables.hpp"
#include "cli/report/plain_page.hpp"

#include <span>
#include <string_view>

namespace maclint::cli {

/// Those that mention the name and that apply to one of the controls; nothing where none does.
void add_speaking_rules(PlainPage& page, std::string_view name, std::span<const ControlModel* const> on);

} // namespace maclint::cli
