//! Looks into the one table or the other.
#include "rules/modal/modal_group_conflict_finder.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <algorithm>
#include <optional>
#include <variant>

namespace maclint::rules {
namespace {

bool has_rows_of_g_codes(const ControlModel& control) {
    return std::ranges::find(control.exclusive_codes, 'G', &ExclusiveCodes::letter) !=
           control.exclusive_codes.end();
}

ExclusiveKind kind_of_group(const ControlModel& control, GroupId group) {
    return {control.exclusive_codes.size() + group, control.groups[group].name};
}

std::optional<ExclusiveKind> kind_of(const ControlModel& control, char letter, double code) {
    for (std::size_t i = 0; i < control.exclusive_codes.size(); ++i) {
        const ExclusiveCodes& row = control.exclusive_codes[i];
        if (row.letter == letter && std::ranges::find(row.codes, code) != row.codes.end())
            return ExclusiveKind{i, row.name};
    }
    if (letter != 'G' || has_rows_of_g_codes(control)) return std::nullopt;
    const auto group = control.group_of('G', code);
    return group ? std::optional(kind_of_group(control, *group)) : std::nullopt;
}

std::optional<ExclusiveCode> code_in(const ControlModel& control, const Word& word) {
    const auto* code = std::get_if<Literal>(&word.value);
    if (code == nullptr || (word.address != "G" && word.address != "M")) return std::nullopt;
    const auto kind = kind_of(control, word.address.front(), code->value);
    return kind ? std::optional(ExclusiveCode{word.span, code->value, *kind}) : std::nullopt;
}

/// A code that is a name, as DIAMON, is no word with an address.
std::optional<ExclusiveCode> named_code_in(const Program& program, const Effect& effect) {
    const auto* set = std::get_if<SetModal>(&effect.what);
    const ControlModel& control = *program.control;
    if (set == nullptr || !set->group || has_rows_of_g_codes(control)) return std::nullopt;
    const auto* code = std::get_if<Literal>(&program.expressions[set->value].node);
    if (code == nullptr) return std::nullopt;
    const ModalGroup& group = control.groups[*set->group];
    const auto member = std::ranges::find(group.members, code->value, &ModalMember::number);
    if (member == group.members.end() || member->written_code >= 0 ||
        member->spelling != in_capitals(program.slice(effect.span)))
        return std::nullopt;
    return ExclusiveCode{effect.span, code->value, kind_of_group(control, *set->group)};
}

} // namespace

std::vector<ExclusiveCode> exclusive_codes_in(const queries::WordsOfBlock& block) {
    const Program& program = block.analysis.program();
    std::vector<ExclusiveCode> codes;
    for (const Word& word : block.words)
        if (const auto code = code_in(*program.control, word)) codes.push_back(*code);
    for (const Effect& effect : program.effects_in(block.block.effects))
        if (const auto code = named_code_in(program, effect)) codes.push_back(*code);
    std::ranges::stable_sort(codes, {}, [](const ExclusiveCode& code) { return code.span.begin; });
    return codes;
}

} // namespace maclint::rules
