//! Looks at what becomes of a value after its read.
#include "analyzer/queries/vacancy/vacant_uses.hpp"

#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/dataflow/facts/with_value.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/queries/paths/exits.hpp"
#include "analyzer/queries/paths/feasible_paths.hpp"
#include "analyzer/source/budget.hpp"

#include <algorithm>
#include <set>
#include <variant>

namespace maclint::queries {
namespace {

/// Whether the program ends in an alarm where the variable has a value.
bool is_refused(const ProgramAnalysis& analysis, Variable variable) {
    const auto comparisons = analysis.facts().all<dataflow::Comparison>();
    return any_within_budget(comparisons, [&](const dataflow::Comparison& test) {
        const bool asks_for_value = test.operation == Operation::is_set;
        if (!asks_for_value && test.operation != Operation::is_vacant) return false;
        const auto* guarded = std::get_if<Guarded>(&analysis.program().effects[test.effect].what);
        return guarded != nullptr && guarded->condition == test.expression &&
               plain_variable(analysis.program(), test.left_expression) == variable &&
               ends_in_alarm(analysis, test.node, asks_for_value);
    });
}

/// Whether the variable is set nowhere but behind IF and THEN in the same block.
bool is_set_under_conditions(const ProgramAnalysis& analysis, Variable variable) {
    const auto stands_alone = [&](const dataflow::Store* store) {
        // What stands behind a condition is not among the effects of the block itself.
        const auto block = stored_block(analysis.program(), analysis.graph().nodes[store->node].item);
        return !block || store->effect - block->effects.first < block->effects.count;
    };
    return !any_within_budget(analysis.facts().about<dataflow::Store>(variable), stands_alone);
}

/// S[#10] in a block of its own, behind IF[#1EQ1]THEN#10=800: without a value the speed stays as it is, and
/// no other word waits for it.
bool is_setting_for_some_cases(const ProgramAnalysis& analysis, const dataflow::Read& read) {
    const Program& program = analysis.program();
    const auto* setting = std::get_if<SetModal>(&program.effects[read.effect].what);
    const auto block = stored_block(program, analysis.graph().nodes[read.node].item);
    if (read.value.vacancy != dataflow::Vacancy::maybe || setting == nullptr || !setting->group || !block)
        return false;
    const ModalRole role = analysis.control().groups[*setting->group].role;
    return (role == ModalRole::speed || role == ModalRole::feed) && block->words.size() == 1 &&
           is_set_under_conditions(analysis, read.variable);
}

constexpr std::size_t most_copies = 1000;

/// Follows the value through the assignments that copy it; `seen` are effects that were looked at before.
bool is_used(const ProgramAnalysis& analysis, const dataflow::Read& read, std::set<EffectId>& seen) {
    using dataflow::Use;
    // A letter may be left out on purpose, but not in a program that nobody calls, nor where the program
    // refuses every value that it could pass on.
    if (read.use == Use::argument && exemptions::handed_on_without_a_value.is_on())
        return read.value.vacancy == dataflow::Vacancy::vacant &&
               (analysis.is_main() || is_refused(analysis, read.variable));
    if (exemptions::speed_for_some_cases.is_on() && read.use == Use::word &&
        is_setting_for_some_cases(analysis, read))
        return false;
    if (read.use != Use::copy && read.use != Use::arithmetic) return true;
    const auto stores = analysis.facts().at<dataflow::Store>(read.effect);
    if (stores.size() != 1) return true; // what it is made of is not known one by one
    const dataflow::Store& store = stores.front();
    if (!analysis.liveness().is_live_after(store.effect, store.variable)) return false;
    if (read.use != Use::copy) return true;
    // Nothing is known at the end of a long chain of copies.
    if (seen.size() == most_copies) return true;
    if (!seen.insert(read.effect).second) return false;
    return dataflow::any_with_value<dataflow::Read>(
        analysis.facts(), store.variable, store.value.symbol, [&](const dataflow::Read& later) {
            return later.use != Use::vacancy_test && is_used(analysis, later, seen);
        });
}

} // namespace

bool is_used(const ProgramAnalysis& analysis, const dataflow::Read& read) {
    std::set<EffectId> seen;
    return is_used(analysis, read, seen);
}

execution::PathFound path_past_word(execution::PathSearch& search, const ProgramAnalysis& analysis,
                                    const dataflow::Read& read) {
    execution::PathFound found;
    for (const flow::Exit& exit : analysis.graph().exits) {
        if (exit.kind == flow::ExitKind::alarm || !analysis.data().reached(exit.node)) continue;
        found = path_without_assignment(search, analysis, read.variable, read.node, exit.node);
        if (!found.path) continue;
        found.path->resize(found.ends.front());
        break;
    }
    return found;
}

} // namespace maclint::queries
