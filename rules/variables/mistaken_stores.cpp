//! Messages about stores that are lost.
#include "rules/variables/mistaken_stores.hpp"

#include "analyzer/program/tables.hpp"
#include "analyzer/queries/paths/exits.hpp"
#include "rules/path.hpp"
#include "rules/variables/dead_store_names_finder.hpp"
#include "rules/variables/dead_store_offsets_finder.hpp"

#include <string>

namespace maclint::rules {
namespace {

void report_mistaken_number(const ProgramAnalysis& analysis, Reporter& reporter) {
    const auto mistaken = find_mistaken_number(analysis);
    if (!mistaken) return;
    const Program& program = analysis.program();
    const Span span = program.effects[mistaken->store->effect].span;
    const Span read = program.expressions[mistaken->read->expression].span;
    Finding& finding =
        reporter.report({analysis, mistaken->store->effect}, span, "other-number",
                        {quoted(program, span), program.spell(mistaken->store->variable),
                         program.spell(mistaken->read->variable), line_number(analysis.file(), read.begin)});
    finding.severity = Severity::note;
    finding.related.push_back({analysis.source(), read, "it is read here"});
}

void report_offsets(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const OffsetSetTwice& twice : find_offsets_set_twice(program)) {
        const Span span = program.effects[twice.lost].span;
        const std::string text = quoted(program, span);
        const Span next = program.effects[twice.next].span;
        reporter
            .report({analysis, twice.lost}, span, "replaced",
                    {text, text.substr(0, text.find('=')), line_number(analysis.file(), next.begin)})
            .related.push_back(related_at_effect(analysis, twice.next, "replaces the value"));
    }
}

/// `#530=#530`. In one of several cases it says that nothing changes there.
void report_own_values(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const dataflow::Store& store : analysis.facts().all<dataflow::Store>()) {
        const auto* load = std::get_if<Load>(&program.expressions[store.expression].node);
        if (load == nullptr || !(load->variable == store.variable) ||
            !queries::is_on_every_path(analysis, store.node))
            continue;
        const Span span = program.effects[store.effect].span;
        reporter.report({analysis, store.effect}, span, "itself",
                        {quoted(program, span), program.spell(store.variable)});
    }
}

} // namespace

void report_mistaken_stores(const ProgramAnalysis& analysis, Reporter& reporter) {
    report_mistaken_number(analysis, reporter);
    report_offsets(analysis, reporter);
    report_own_values(analysis, reporter);
}

} // namespace maclint::rules
