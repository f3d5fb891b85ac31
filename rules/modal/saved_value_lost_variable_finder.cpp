//! Takes from the locals that arguments can reach those that a program names.
#include "rules/modal/saved_value_lost_variable_finder.hpp"

#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <ranges>

namespace maclint::rules {
namespace {

bool is_named(const Program& program, Variable variable) {
    const auto loads = [&](const Expression& expression) {
        const auto* load = std::get_if<Load>(&expression.node);
        return load != nullptr && load->variable == variable;
    };
    const auto stores = [&](const Effect& effect) {
        const auto* assign = std::get_if<Assign>(&effect.what);
        const auto* target = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
        return target != nullptr && *target == variable;
    };
    return std::ranges::any_of(program.expressions, loads) || std::ranges::any_of(program.effects, stores);
}

} // namespace

std::optional<Variable> find_free_local(const ProgramAnalysis& analysis) {
    const ControlModel& control = analysis.control();
    for (const auto& letters : control.series | std::views::reverse)
        for (const Variable variable : letters | std::views::reverse)
            if (std::ranges::find(control.formals, variable) == control.formals.end() &&
                !is_named(analysis.program(), variable))
                return variable;
    return std::nullopt;
}

} // namespace maclint::rules
