//! Messages about variables of another axis, offset or counter.
#include "rules/variables/mistaken_axes.hpp"

#include "rules/path.hpp"
#include "rules/variables/crossed_axes_rows_finder.hpp"
#include "rules/variables/crossed_axes_siblings_finder.hpp"
#include "rules/variables/crossed_axes_words_finder.hpp"

#include <string>

namespace maclint::rules {
namespace {

void report_siblings(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const FromSibling& found : find_statements_from_siblings(program)) {
        const Span span = program.expressions[found.operand].span;
        Finding& finding =
            reporter.report({analysis, found.effect}, span, "from-sibling",
                            {quoted(program, program.effects[found.effect].span), quoted(program, span),
                             quoted(program, program.effects[found.sibling].span), found.own});
        if (found.counts) finding.severity = Severity::note;
        finding.related.push_back(related_at_effect(analysis, found.sibling, "this one takes its own"));
    }
}

void report_words(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const PlaceForAnotherAxis& found : find_places_for_other_axes(program)) {
        const Span span = program.effects[found.store].span;
        Finding& finding =
            reporter.report({analysis, found.store}, span, "moves-another",
                            {quoted(program, span), std::string(1, found.axis), quoted(program, found.word),
                             line_number(analysis.file(), found.word.begin), program.spell(found.twin),
                             program.spell(found.meant)});
        finding.related.push_back({analysis.source(), found.word, "it moves this axis"});
    }
}

void report_rows(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const StoreOfAnotherCase& found : find_stores_of_other_cases(analysis)) {
        const Span span = program.effects[found.effect].span;
        const Span sibling = program.effects[found.sibling].span;
        Finding& finding = reporter.report(
            {analysis, found.effect}, span, "store-of-case",
            {quoted(program, span), found.own, line_number(analysis.file(), sibling.begin), found.meant});
        finding.related.push_back(related_at_effect(analysis, found.sibling, "the other case sets it here"));
    }
}

} // namespace

void report_mistaken_axes(const ProgramAnalysis& analysis, Reporter& reporter) {
    report_siblings(analysis, reporter);
    report_words(analysis, reporter);
    report_rows(analysis, reporter);
}

} // namespace maclint::rules
