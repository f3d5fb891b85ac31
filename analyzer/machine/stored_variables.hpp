//! What a program stores in its variables, as far as the text alone says it.
#pragma once

#include "analyzer/program/model.hpp"

#include <optional>
#include <unordered_map>

namespace maclint::machine {

class StoredVariables {
  public:
    explicit StoredVariables(const Program& program);

    /// The modal group whose code in force the expression is a saved copy of: #1, where every assignment to
    /// it is #1=#4003. Nothing for all others.
    [[nodiscard]] std::optional<GroupId> saved_group(const Program& program, ExpressionId expression) const;

    /// The argument that the expression is as it was passed: #20, where nothing is stored in it.
    [[nodiscard]] std::optional<Variable> passed(const Program& program, ExpressionId expression) const;

  private:
    /// Of each variable to which something is assigned: the one group whose state it saves.
    std::unordered_map<Variable, std::optional<GroupId>, VariableHash> groups_;
};

} // namespace maclint::machine
