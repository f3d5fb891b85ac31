//! Reads the table of origins.
#include "analyzer/queries/values/origins.hpp"

#include "analyzer/program/block_view.hpp"

#include <variant>

namespace maclint::queries {
namespace {

using Kind = dataflow::Origin::Kind;

/// The last block of a plain run's part that sets the group.
Span last_setting(const Program& program, const flow::Node& node, GroupId group) {
    Span found = node.part;
    for_each_block(program, node.stretch(), [&](const BlockView& block) {
        for (const BlockSetting& setting : block.settings)
            if (setting.group == group) found = block.span;
    });
    return found;
}

} // namespace

std::optional<EffectId> effect_of_origin(const ProgramAnalysis& analysis, dataflow::OriginId origin) {
    const dataflow::Origin& from = analysis.data().origin(origin);
    return from.kind == Kind::effect ? std::optional(from.id) : std::nullopt;
}

std::optional<Variable> variable_of_origin(const ProgramAnalysis& analysis, dataflow::OriginId origin) {
    return analysis.data().origin(origin).entry_variable();
}

flow::NodeId node_of_origin(const ProgramAnalysis& analysis, dataflow::OriginId origin) {
    const dataflow::Origin& from = analysis.data().origin(origin);
    return from.kind == Kind::none || from.kind == Kind::entry ? 0 : from.node;
}

Span span_of_origin(const ProgramAnalysis& analysis, dataflow::OriginId origin) {
    const Program& program = analysis.program();
    const dataflow::Origin& from = analysis.data().origin(origin);
    switch (from.kind) {
    case Kind::effect: return program.effects[from.id].span;
    case Kind::expression: return program.expressions[from.id].span;
    case Kind::run:
        return last_setting(program, analysis.graph().nodes[from.node], static_cast<GroupId>(from.id));
    case Kind::entry:
    case Kind::none: break;
    }
    return program.name_span.begin != program.name_span.end ? program.name_span
                                                            : analysis.graph().nodes[0].part;
}

bool is_plain_origin(const ProgramAnalysis& analysis, dataflow::OriginId origin) {
    return analysis.data().origin(origin).kind == Kind::run;
}

bool is_made_by_call(const ProgramAnalysis& analysis, dataflow::OriginId origin) {
    const auto effect = effect_of_origin(analysis, origin);
    return effect && std::holds_alternative<Call>(analysis.program().effects[*effect].what);
}

} // namespace maclint::queries
