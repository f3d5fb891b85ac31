//! Messages about arguments that nobody reads.
#include "rules/variables/unread_arguments.hpp"

#include "analyzer/queries/calls/callers.hpp"
#include "rules/listed.hpp"
#include "rules/path.hpp"
#include "rules/variables/argument_unused_default_finder.hpp"

#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace maclint::rules {

using queries::UnreadArgument;

void report_unread(const ProgramAnalysis& analysis, const std::vector<queries::UnreadArgument>& unread,
                   Reporter& reporter) {
    const UnreadArgument& first = unread.front();
    const Program& called = first.called->program();
    const Span span = first.argument->span;
    std::vector<std::string> names;
    std::map<std::pair<ProgramIndex, EffectId>, std::vector<std::string>> others; // and what they pass
    for (const UnreadArgument& one : unread) {
        names.push_back(with_letter(*one.called, one.variable));
        for (const auto& [program, effect] : one.others) others[{program, effect}].push_back(names.back());
    }
    std::vector<std::string> words{called.name, listed(names, " and "), quoted(analysis.program(), span)};
    if (first.overwritten) {
        const Span store = called.effects[*first.overwritten].span;
        words.push_back(line_number(first.called->file(), store.begin));
    }
    const std::string_view kept = unread.size() == 1 ? "unread" : "several";
    const std::string_view message = first.overwritten ? "overwritten" : kept;
    Finding& finding = reporter.report({analysis, span}, span, message, std::move(words));
    for (const auto& [call, passed] : others) {
        const std::string what = unread.size() == 1 ? "it" : listed(passed, " and ");
        const ProgramAnalysis& caller = queries::calling_program(analysis, {call.first, call.second});
        finding.related.push_back(
            related_at_effect(caller, call.second, "this call passes " + what + ", too"));
    }
}

void report_defaults(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const auto& [test, store] : find_overwritten_arguments(analysis)) {
        const Span span = program.effects[store->effect].span;
        const Span asked = program.expressions[test->expression].span;
        reporter
            .report({analysis, *store}, span, "default",
                    {quoted(program, span), with_letter(analysis, store->variable), quoted(program, asked)})
            .related.push_back({analysis.source(), asked, "it asks whether the value was passed"});
    }
}

} // namespace maclint::rules
