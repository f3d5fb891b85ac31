//! Looks arguments up in their list.
#include "analyzer/queries/calls/given_arguments.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/queries/calls/callers.hpp"

#include <algorithm>

namespace maclint::queries {

const Argument* argument_at(const Program& program, const Call& call, std::size_t place) {
    const auto arguments = program.arguments_of(call);
    const auto found = std::ranges::find_if(arguments, [&](const Argument& argument) {
        const auto* position = std::get_if<ArgumentPosition>(&argument.given);
        return position != nullptr && position->number == place;
    });
    return found == arguments.end() ? nullptr : &*found;
}

std::string_view type_given(const Program& program, const Argument& argument) {
    const auto& node = program.expressions[argument.value].node;
    if (std::holds_alternative<Text>(node)) return "STRING";
    if (std::holds_alternative<Literal>(node)) return "REAL";
    const auto* load = std::get_if<Load>(&node);
    const Declaration* declared = load == nullptr ? nullptr : program.declaration_of(load->variable);
    return declared == nullptr ? std::string_view{} : declared->type_name;
}

const ArrayDefinition* array_given(const ProgramAnalysis& analysis, const Argument& argument) {
    const std::string name = in_capitals(argument.address);
    const auto& arrays = analysis.program().arrays;
    const auto own = std::ranges::find(arrays, name, &ArrayDefinition::name);
    return own == arrays.end() ? analysis.names_elsewhere().array(name) : &*own;
}

void for_each_known_call(
    const ProgramAnalysis& analysis,
    const std::function<void(const CallSite& site, const Call& call, const ProgramAnalysis& called)>& visit) {
    for (const CallSite& site : analysis.calls()) {
        const ProgramAnalysis* called = called_program(analysis, site);
        const Call& call = call_of(analysis.program(), site.effect);
        if (called != nullptr && std::holds_alternative<Text>(call.program)) visit(site, call, *called);
    }
}

} // namespace maclint::queries
