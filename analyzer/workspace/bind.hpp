//! Which parameter of a called program each argument of a call sets.
#pragma once

#include "analyzer/program/model.hpp"

#include <algorithm>
#include <variant>

namespace maclint {

/// The variable of the called program that the argument sets; nothing where that program has no such
/// parameter, or is not known. A letter sets the same variable in every program.
[[nodiscard]] inline std::optional<Variable> bound_to(const Argument& argument, const Program* callee) {
    if (const auto* variable = std::get_if<Variable>(&argument.given)) return *variable;
    if (callee == nullptr) return std::nullopt;
    const auto& formals = callee->formals;
    if (const auto* position = std::get_if<ArgumentPosition>(&argument.given))
        return position->number < formals.size() ? std::optional(formals[position->number].variable)
                                                 : std::nullopt;
    const auto named = std::ranges::find(formals, std::get<std::string_view>(argument.given), &Formal::name);
    return named == formals.end() ? std::nullopt : std::optional(named->variable);
}

} // namespace maclint
