//! Looks arguments up in their list.
#include "analyzer/queries/calls/given_arguments.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/queries/calls/callers.hpp"

#include <algorithm>

namespace maclint::queries {
namespace {

std::string_view type_of(const Program& program, ExpressionId value) {
    const auto& node = program.expressions[value].node;
    if (std::holds_alternative<Text>(node)) return "STRING";
    if (std::holds_alternative<Literal>(node)) return "REAL";
    const auto* load = std::get_if<Load>(&node);
    const Declaration* declared = load == nullptr ? nullptr : program.declaration_of(load->variable);
    return declared == nullptr ? std::string_view{} : declared->type_name;
}

} // namespace

const Argument* argument_at(const Program& program, const Call& call, std::size_t place) {
    const auto arguments = program.arguments_of(call);
    const auto found = std::ranges::find_if(arguments, [&](const Argument& argument) {
        const auto* position = std::get_if<ArgumentPosition>(&argument.given);
        return position != nullptr && position->number == place;
    });
    return found == arguments.end() ? nullptr : &*found;
}

std::string_view type_given(const ProgramAnalysis& analysis, const Argument& argument) {
    const std::string_view own = type_of(analysis.program(), argument.value);
    if (!own.empty()) return own;
    const ArrayDefinition* given = analysis.names_elsewhere().array(in_capitals(argument.address));
    return given == nullptr || !given->sizes.empty() ? std::string_view{} : given->type;
}

const ArrayDefinition* array_given(const ProgramAnalysis& analysis, const Argument& argument) {
    const std::string name = in_capitals(argument.address);
    const auto& arrays = analysis.program().arrays;
    const auto own = std::ranges::find(arrays, name, &ArrayDefinition::name);
    if (own != arrays.end()) return &*own;
    const ArrayDefinition* given = analysis.names_elsewhere().array(name);
    return given == nullptr || given->sizes.empty() ? nullptr : given;
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
