//! What a numbered variable of programs is, on each control: for `explain`.
#pragma once

#include "analyzer/program/tables.hpp"
#include "cli/report/plain_page.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace maclint::cli {

/// 4109 of "#4109"; nothing where the word is no such variable.
[[nodiscard]] std::optional<std::int64_t> variable_number_in(std::string_view word);

/// A page for each meaning that it has on the controls that write variables so, or on the one that is asked
/// for; empty where none has them.
[[nodiscard]] std::string plain_variable_pages(std::int64_t number, const ControlModel* only,
                                               const PageStyle& style);

} // namespace maclint::cli
