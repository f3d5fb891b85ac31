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

std::optional<double> number_passed(const Program& program, const Call& call, const BroughtCycle& cycle,
                                    std::string_view parameter) {
    const auto named = std::ranges::find(cycle.parameters, parameter);
    if (named == cycle.parameters.end()) return std::nullopt;
    const auto place = static_cast<std::uint32_t>(named - cycle.parameters.begin());
    std::optional<double> number;
    for (const Argument& given : program.arguments_of(call)) {
        const auto* position = std::get_if<ArgumentPosition>(&given.given);
        if (position == nullptr) continue;
        if (position->number >= cycle.parameters.size()) return std::nullopt;
        const auto* literal = std::get_if<Literal>(&program.expressions[given.value].node);
        if (position->number == place && literal != nullptr) number = literal->value;
    }
    return number;
}

} // namespace maclint::queries
