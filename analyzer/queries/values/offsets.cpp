//! Looks at the numbers in indices.
#include "analyzer/queries/values/offsets.hpp"

#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <unordered_map>

namespace maclint::queries {
namespace {

/// No control has a variable beyond; any number may stand in a program.
constexpr double largest_number = 1e9;

bool is_offset(const ProgramAnalysis& analysis, FamilyId family, std::int64_t number) {
    const VariableRange* range = analysis.control().families[family].find(number);
    return range != nullptr && range->meaning == Meaning::machine && range->on_write == OnWrite::store &&
           !range->changes_by_itself && !range->is_bit;
}

/// `through`: so many variables may hold what makes the number, `#14=5223+20*[#19-54]`.
bool leads_to_offset(const ProgramAnalysis& analysis, FamilyId family, ExpressionId index, int through) {
    const Program& program = analysis.program();
    const auto& node = program.expressions[index].node;
    if (const auto* load = std::get_if<Load>(&node)) {
        if (through == 0) return false;
        const auto stores = analysis.facts().about<dataflow::Store>(load->variable);
        return stores.size() == 1 && !stores.front()->step &&
               leads_to_offset(analysis, family, stores.front()->expression, through - 1);
    }
    if (const auto* literal = std::get_if<Literal>(&node))
        return literal->value > 0 && literal->value < largest_number &&
               is_offset(analysis, family, static_cast<std::int64_t>(literal->value));
    const auto* apply = std::get_if<Apply>(&node);
    return apply != nullptr && std::ranges::any_of(program.operands_of(*apply), [&](ExpressionId operand) {
               return leads_to_offset(analysis, family, operand, through);
           });
}

/// What picks an offset by its expression, with the index in which it stands.
using Picks = std::unordered_map<ExpressionId, ExpressionId>;

void note_index(const ProgramAnalysis& analysis, FamilyId family, ExpressionId index, Picks& picks) {
    const Program& program = analysis.program();
    const auto* sum = std::get_if<Apply>(&program.expressions[index].node);
    if (sum == nullptr || sum->operation != Operation::add || !leads_to_offset(analysis, family, index, 0))
        return;
    for (const ExpressionId operand : program.operands_of(*sum))
        if (std::holds_alternative<Load>(program.expressions[operand].node)) picks.emplace(operand, index);
}

} // namespace

bool makes_offset(const ProgramAnalysis& analysis, const Assign& assign) {
    if (const auto* machine = std::get_if<StoreMachine>(&assign.target))
        return is_offset(analysis, machine->family, machine->number);
    const auto* indirect = std::get_if<StoreAt>(&assign.target);
    return indirect != nullptr && leads_to_offset(analysis, indirect->family, indirect->index, 1);
}

std::vector<OffsetPick> offset_picks(const ProgramAnalysis& analysis) {
    const Program& program = analysis.program();
    Picks picks;
    for (const Expression& expression : program.expressions)
        if (const auto* load = std::get_if<LoadAt>(&expression.node))
            note_index(analysis, load->family, load->index, picks);
    for (const Effect& effect : program.effects)
        if (const auto* assign = std::get_if<Assign>(&effect.what))
            if (const auto* target = std::get_if<StoreAt>(&assign->target))
                note_index(analysis, target->family, target->index, picks);
    std::vector<OffsetPick> found;
    if (picks.empty()) return found;
    for (const dataflow::Read& read : analysis.facts().all<dataflow::Read>())
        if (const auto pick = picks.find(read.expression); pick != picks.end())
            found.push_back({&read, pick->second});
    return found;
}

} // namespace maclint::queries
