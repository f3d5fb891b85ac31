//! Programs that no dialect has read: built from the model, for what no dialect needs yet.
#pragma once

#include "analyzer/program/builder.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/workspace/workspace.hpp"

#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace maclint::test {

/// A control for programs of the shape of SINUMERIK: named labels, parameters by position and by reference,
/// typed variables, variables that programs share by name, group members with names.
[[nodiscard]] const ControlModel& control_with_names();

/// Rows of control_with_names().
namespace rows {
constexpr SpaceId r = 0, local = 1, parameter = 2, shared = 3;
constexpr GroupId diameter = 0;
constexpr CallKindId by_name = 0;
constexpr FamilyId r_family = 0;
} // namespace rows

/// An effect of a block, perhaps under a condition: `IF … GOTOF …`.
struct Step {
    template<class What>
    Step(What effect) // NOLINT(google-explicit-constructor): blocks are lists of them
        : what(std::move(effect)) {}
    Step(ExpressionId when, decltype(Effect::what) effect)
        : condition(when)
        , what(effect) {}
    std::optional<ExpressionId> condition;
    decltype(Effect::what) what;
};

/// Builds a file with one program. Each block takes the next line of the text.
class HandBuilt {
  public:
    HandBuilt(std::string path, std::string text);

    // ---- variables
    [[nodiscard]] Variable variable(SpaceId space, std::string_view name);
    [[nodiscard]] Variable declare(std::string_view name, VariableType type);
    [[nodiscard]] Variable declare(std::string_view name, VariableType type, double initial);
    /// The next parameter.
    Variable formal(std::string_view name, VariableType type, Passing passing);

    // ---- expressions
    [[nodiscard]] ExpressionId number(double value);
    [[nodiscard]] ExpressionId load(Variable variable);
    /// R[…]
    [[nodiscard]] ExpressionId load_at(ExpressionId index);
    [[nodiscard]] ExpressionId name(std::string_view label);
    [[nodiscard]] ExpressionId apply(Operation operation, std::initializer_list<ExpressionId> operands);

    // ---- blocks
    void block(std::initializer_list<Step> steps);
    void labelled_block(std::string_view label, std::initializer_list<Step> steps);
    void labelled_block(std::int64_t number, std::string_view label, std::initializer_list<Step> steps);
    [[nodiscard]] Call call(std::string_view name, std::initializer_list<Argument> arguments);

    /// The file; nothing can be added to it afterwards.
    [[nodiscard]] WorkspaceFile finish();

  private:
    void end_block(Block block, std::initializer_list<Step> steps);

    std::shared_ptr<const Source> source_;
    ProgramBuilder builder_;
    std::uint32_t line_ = 0;
};

} // namespace maclint::test
