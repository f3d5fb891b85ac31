//! What a numbered variable of programs is, on each control: for `explain`.
#pragma once

#include "analyzer/program/tables.hpp"
#include "cli/report/plain_page.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli {

/// 4109 of "#4109"; nothing where the word is no such variable.
[[nodiscard]] std::optional<std::int64_t> variable_number_in(std::string_view word);

/// A page for each meaning that it has on the controls that write variables so, or on the one that is asked
/// for; empty where none has them.
[[nodiscard]] std::string plain_variable_pages(std::int64_t number, const ControlModel* only,
                                               const PageStyle& style);

/// What a number of a family is on the control: what it holds, whether it may be written. Sentences without
/// full stops; the first says what it is.
[[nodiscard]] std::vector<std::string> facts_of_number(const ControlModel& control,
                                                       const VariableRange& range, std::int64_t number);
/// "all programs share it, until the control is switched off"
[[nodiscard]] std::string scope_of(const VariableSpace& space);

} // namespace maclint::cli
