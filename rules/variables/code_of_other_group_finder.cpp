//! Holds numbers against the codes of modal groups.
#include "rules/variables/code_of_other_group_finder.hpp"

#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

namespace maclint::rules {
namespace {

/// Canned cycles and moves are of one group on some machines.
bool is_motion(const ModalGroup& group) {
    return group.role == ModalRole::motion || group.role == ModalRole::cycle;
}

bool may_hold(const ControlModel& control, GroupId id, double code) {
    const ModalGroup& group = control.groups[id];
    return group.letter != 'G' || group.members.empty() || control.group_of(group.letter, code) == id;
}

std::optional<CodeOfOtherGroup> look_at(const ProgramAnalysis& analysis,
                                        const dataflow::Comparison& comparison, ExpressionId read,
                                        ExpressionId compared) {
    const Program& program = analysis.program();
    const ControlModel& control = analysis.control();
    const auto* load = std::get_if<LoadModal>(&program.expressions[read].node);
    const auto* code = std::get_if<Literal>(&program.expressions[compared].node);
    if (load == nullptr || code == nullptr || may_hold(control, load->group, code->value))
        return std::nullopt;
    // Rows of the other machine's table are of the same variables.
    const bool some_may = std::ranges::any_of(control.lathes, [&](const ControlModel* lathe) {
        return may_hold(*lathe, load->group, code->value);
    });
    const auto other = some_may ? std::nullopt : control.group_of('G', code->value);
    if (!other || (is_motion(control.groups[load->group]) && is_motion(control.groups[*other])))
        return std::nullopt;
    const auto meant = control.variable_of(*other);
    if (!meant) return std::nullopt;
    return CodeOfOtherGroup{&comparison, read,  load->group, control.spell(*other, code->value),
                            *other,      *meant};
}

} // namespace

std::vector<CodeOfOtherGroup> find_codes_of_other_groups(const ProgramAnalysis& analysis) {
    std::vector<CodeOfOtherGroup> found;
    for (const dataflow::Comparison& comparison : analysis.facts().all<dataflow::Comparison>()) {
        if (comparison.operation != Operation::equal && comparison.operation != Operation::not_equal)
            continue;
        for (const auto& [read, compared] :
             {std::pair(comparison.left_expression, comparison.right_expression),
              std::pair(comparison.right_expression, comparison.left_expression)})
            if (auto code = look_at(analysis, comparison, read, compared)) found.push_back(*std::move(code));
    }
    return found;
}

} // namespace maclint::rules
