//! The functions of Custom Macro B: names, abbreviations, and what they compute.
#pragma once

#include "analyzer/program/model.hpp"

#include <span>
#include <string_view>

namespace maclint::fanuc {

struct FunctionRow {
    std::string_view name; ///< capitals
    Operation operation;   ///< `unknown` for what has no model
};
[[nodiscard]] std::span<const FunctionRow> functions();

} // namespace maclint::fanuc
