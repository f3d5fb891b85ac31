//! Looks for the name in the tables of the program's language.
#include "analyzer/queries/calls/brought_cycles.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/dialect.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

namespace maclint::queries {

const BroughtCycle* cycle_called(const ProgramAnalysis& analysis, EffectId effect) {
    const Program& program = analysis.program();
    const auto* call = std::get_if<Call>(&program.effects[effect].what);
    const auto* written = call == nullptr ? nullptr : std::get_if<Text>(&call->program);
    const Dialect* dialect = written == nullptr ? nullptr : find_dialect(analysis.control().language);
    if (dialect == nullptr || dialect->words == nullptr) return nullptr;
    const CallSite* site = analysis.call_at(effect);
    if (site != nullptr && site->candidates != 0) return nullptr;
    const auto cycles = dialect->words().cycles;
    const auto cycle =
        std::ranges::find(cycles, in_capitals(program.slice(written->characters)), &BroughtCycle::name);
    return cycle == cycles.end() ? nullptr : &*cycle;
}

bool calls_programs(const Program& program) {
    return std::ranges::any_of(program.effects, [&](const Effect& effect) {
        const auto* call = std::get_if<Call>(&effect.what);
        return call != nullptr && !program.control->calls[call->kind].brought_by_control;
    });
}

namespace {

/// The argument that stands there as the parameter, nullptr where it is left out; nothing where no place is
/// known for it, or the call has more places than the list.
std::optional<const Argument*> argument_for(const Program& program, const Call& call,
                                            const BroughtCycle& cycle, std::string_view parameter) {
    const auto named = std::ranges::find(cycle.parameters, parameter);
    if (named == cycle.parameters.end()) return std::nullopt;
    const auto place = static_cast<std::uint32_t>(named - cycle.parameters.begin());
    const Argument* found = nullptr;
    for (const Argument& given : program.arguments_of(call)) {
        const auto* position = std::get_if<ArgumentPosition>(&given.given);
        if (position == nullptr || position->number >= cycle.parameters.size()) return std::nullopt;
        if (position->number == place) found = &given;
    }
    return found;
}

} // namespace

std::optional<double> number_passed(const Program& program, const Call& call, const BroughtCycle& cycle,
                                    std::string_view parameter) {
    const Argument* given = argument_for(program, call, cycle, parameter).value_or(nullptr);
    const auto* literal =
        given == nullptr ? nullptr : std::get_if<Literal>(&program.expressions[given->value].node);
    return literal == nullptr ? std::nullopt : std::optional(literal->value);
}

bool is_left_out(const Program& program, const Call& call, const BroughtCycle& cycle,
                 std::string_view parameter) {
    return !program.arguments_of(call).empty() &&
           argument_for(program, call, cycle, parameter) == std::optional<const Argument*>(nullptr);
}

} // namespace maclint::queries
