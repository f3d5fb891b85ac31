//! What the places of a program name: variables, blocks by their names, programs, tools.
#pragma once

#include "analyzer/program/model.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace maclint::cli::lsp {

/// A value that the machine owns, a row of the family's table: #5041, $AA_IM.
struct MachineValue {
    FamilyId family;
    std::int32_t number;
    friend bool operator==(const MachineValue&, const MachineValue&) = default;
};
/// A variable that reads what a group has in force: #4003.
struct ModalValueName {
    GroupId group;
    friend bool operator==(const ModalValueName&, const ModalValueName&) = default;
};
/// The program that a call means, or that stands here.
struct ProgramName {
    std::optional<EffectId> call; ///< nothing: the name of the program itself
    friend bool operator==(const ProgramName&, const ProgramName&) = default;
};
/// An argument of a call.
struct ArgumentName {
    EffectId call;
    std::uint32_t place; ///< among the call's arguments
    friend bool operator==(const ArgumentName&, const ArgumentName&) = default;
};
/// "12" of T12 and T0012; what stands there where it is no number: "DRILL".
struct ToolName {
    std::string tool;
    friend bool operator==(const ToolName&, const ToolName&) = default;
};
using Named =
    std::variant<Variable, MachineValue, ModalValueName, BlockName, ProgramName, ArgumentName, ToolName>;

struct Mention {
    enum class Role : std::uint8_t {
        declares, ///< a variable, a block, a program
        stores,   ///< in a variable
        reads,    ///< or calls, or jumps to
    } role;
    Span span;
    Named named;
};

/// Of one program, without tools, in no order; what can only be found out while it runs (#[#1]) is left out.
void for_each_mention(const Program& program, const std::function<void(const Mention&)>& visit);
/// Words that choose tools.
void for_each_tool(const Program& program, const std::function<void(const Mention&)>& visit);

/// Whether both mean the same, each in its program of one language. A call means nothing here: the workspace
/// knows its program.
[[nodiscard]] bool name_the_same(const Program& one, const Named& a, const Program& other, const Named& b);
/// Whether programs other than the one may mean the same by it.
[[nodiscard]] bool is_shared(const Program& program, const Named& named);

} // namespace maclint::cli::lsp
