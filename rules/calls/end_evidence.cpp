//! Finds the places and the words.
#include "rules/calls/end_evidence.hpp"

#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/paths/exits.hpp"
#include "rules/path.hpp"

namespace maclint::rules {

Evidence evidence_of(const ProgramAnalysis& analysis, const queries::ExpectedEnd& why) {
    const Program& program = analysis.program();
    const auto line_of = [&](Span span) { return line_number(analysis.file(), span.begin); };
    if (const auto* caller = std::get_if<const Caller*>(&why)) {
        const ProgramAnalysis& calling = queries::calling_program(analysis, **caller);
        return {"plain", calling.program().name,
                related_at_effect(calling, (*caller)->effect, "calls " + program.name)};
    }
    if (const auto* other = std::get_if<const flow::Exit*>(&why)) {
        const Span span = queries::span_of_exit(analysis, **other);
        return {"other-exit", line_of(span),
                RelatedLocation{analysis.source(), span, "another path is left here"}};
    }
    if (const auto* macro = std::get_if<queries::WrittenAsMacro>(&why)) {
        const Expression& argument = program.expressions[macro->argument];
        const std::string name = with_letter(analysis, std::get<Load>(argument.node).variable);
        return {"argument", name,
                RelatedLocation{analysis.source(), argument.span, "no block above sets " + name}};
    }
    const Span span = program.effects[std::get<queries::KeepsState>(why).save->effect].span;
    return {"state", line_of(span),
            RelatedLocation{analysis.source(), span, "the state of a caller is saved here"}};
}

std::string missing_end(const ProgramAnalysis& analysis, const queries::ExpectedEnd& why) {
    const auto* other = std::get_if<const flow::Exit*>(&why);
    return other == nullptr || (*other)->kind == flow::ExitKind::returns
               ? std::string(analysis.control().return_word)
               : quoted(analysis.program(), queries::span_of_exit(analysis, **other));
}

} // namespace maclint::rules
