//! Names the variable, and what the program does with it elsewhere.
#include "rules/variables/common_stale_read_words.hpp"

#include "rules/path.hpp"
#include "rules/trace.hpp"
#include "rules/variables/common_stale_read_cases_finder.hpp"
#include "rules/variables/common_stale_read_checks_finder.hpp"
#include "rules/variables/common_stale_read_ways_finder.hpp"

#include <string>
#include <utility>
#include <vector>

namespace maclint::rules {
namespace {

/// "#4012 = 54, 56"
std::string words_for(const ProgramAnalysis& analysis, const StaleRead& stale) {
    const Program& program = analysis.program();
    std::string words;
    for (const ExpressionId number : stale.set_for)
        words += (words.empty() ? quoted(program, program.expressions[stale.subject].span) + " = " : ", ") +
                 quoted(program, program.expressions[number].span);
    return words;
}

void show_path(Finding& finding, const ProgramAnalysis& analysis, const std::vector<flow::EdgeId>& path) {
    for (RelatedLocation& step : steps_along(analysis, path)) finding.path.push_back(std::move(step));
    finding.path.push_back({analysis.source(), finding.span, "it is read as the run before has left it"});
}

} // namespace

void report_limits(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const EarlyCheck& early : find_early_checks(analysis)) {
        const Span span = program.expressions[early.read->expression].span;
        Finding& finding = reporter.report(
            {analysis, *early.read}, span, "limit",
            {quoted(program, program.effects[early.read->effect].span), program.spell(early.read->variable),
             line_number(analysis.file(), program.effects[early.store->effect].span.begin)});
        finding.related.push_back(related_at_effect(analysis, early.store->effect, "it is set here"));
        trace(finding, analysis, early.read->node, "it is checked as the run before has left it");
    }
}

void report_cases(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const StaleRead& stale : find_stale_reads(analysis)) {
        const Span span = program.expressions[stale.read->expression].span;
        const Span asked = program.expressions[stale.missing].span;
        Finding& finding =
            reporter.report({analysis, *stale.read}, span, "case",
                            {program.spell(stale.read->variable), words_for(analysis, stale),
                             quoted(program, asked), line_number(analysis.file(), asked.begin)});
        show_path(finding, analysis, stale.path);
    }
}

void report_ways(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const OneWaySet& set : find_reads_behind_one_way(analysis)) {
        const Span span = program.expressions[set.read->expression].span;
        const auto line = [&](const dataflow::Store& store) {
            return line_number(analysis.file(), program.effects[store.effect].span.begin);
        };
        const std::string variable = program.spell(set.read->variable);
        const std::string condition = quoted(program, program.expressions[set.condition].span);
        Finding& finding = set.sibling == nullptr
                               ? reporter.report({analysis, *set.read}, span, "left-out",
                                                 {variable, line(*set.store), condition})
                               : reporter.report({analysis, *set.read}, span, "way",
                                                 {variable, condition, program.spell(set.sibling->variable),
                                                  line(*set.sibling)});
        // Some mean to go on with the last value.
        if (set.sibling == nullptr) finding.severity = Severity::note;
        finding.related.push_back(related_at_effect(analysis, set.store->effect, "it is set here"));
        show_path(finding, analysis, set.path);
    }
}

} // namespace maclint::rules
