//! MAC217: a program called in a loop uses the loop's counter for itself.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/loops/loop_counter.hpp"
#include "analyzer/queries/loops/loop_exits.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <set>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule common_clobber{
    .code = "MAC217",
    .name = "common-clobber",
    .summary = "A program that a loop calls stores values of its own in the loop's counter",
    .why = "Common variables, and the local ones in a program called by M98, are the same for both programs. "
           "The "
           "loop runs once too often, too few times or for ever.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::Store, dataflow::Comparison, dataflow::Read>(),
    .messages = {{"plain",
                  "Counter of a loop overwritten: '{0}' runs {1}, which uses {2} for values of its own, and "
                  "{2} counts "
                  "the loop on line {3}.",
                  "Count with a variable that {1} does not use."}},
    .bad = {{"fanuc", R"nc(
O0217(ROW)
#100=0
WHILE[#100LT5]DO1
G65 P9217 X#100
#100=#100+1
END1
M30
O9217(HOLE, X)
#100=#5041+5.
G90 G0 X[#24*#100]
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O0217(ROW)
#100=0
#101=0
WHILE[#100+#101LT5]DO1
G65 P9217 X#100
#100=#100+1
END1
M30
O9217(HOLE, X)
IF[#5041GT50.]THEN #101=99
#102=#5041+5.
G90 G0 X[#24*#102]
M99
)nc"}},
    .sources = {"NCT-174", "TENC-G65"},
    .check = &check,
};

namespace {

/// The store of the program that the call runs, after which it reads the variable: it works with it, and does
/// not answer its caller by it. It does not read what the caller has there, either.
const dataflow::Store* own_use(const ProgramAnalysis& called, Variable variable) {
    const auto stores = called.facts().all<dataflow::Store>();
    const auto store = std::ranges::find(stores, variable, &dataflow::Store::variable);
    const auto reads = called.facts().all<dataflow::Read>();
    if (store == stores.end() || std::ranges::find(reads, variable, &dataflow::Read::variable) == reads.end())
        return nullptr;
    const auto live = called.liveness().live_before(0);
    return std::ranges::find(live, variable) == live.end() ? &*store : nullptr;
}

/// Whether what the program stores in the variable comes to its caller.
bool reaches_caller(const ProgramAnalysis& called, Variable variable) {
    const auto& changes = called.summary().variables;
    return called.summary().known &&
           std::ranges::find(changes, variable, &dataflow::VariableChange::variable) != changes.end();
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    if (analysis.calls().empty()) return;
    std::set<EffectId> said;
    for (const dataflow::Loop& loop : analysis.loops())
        for (const queries::Counter& counter : queries::counters_of(analysis, loop))
            for (const CallSite& site : analysis.calls()) {
                const auto node = analysis.graph().node_of(site.effect);
                const ProgramAnalysis* called = queries::called_program(analysis, site);
                if (called == nullptr || !node || !loop.holds(*node)) continue;
                const VariableSpace& space = analysis.control().spaces[counter.variable.space];
                const CallKind& kind = analysis.control().calls[queries::call_of(program, site.effect).kind];
                if (space.scope == Scope::frame && kind.frame == Frame::fresh) continue;
                const dataflow::Store* store =
                    reaches_caller(*called, counter.variable) ? own_use(*called, counter.variable) : nullptr;
                if (store == nullptr || !said.insert(site.effect).second) continue;
                const Span span = program.effects[site.effect].span;
                Finding& finding = reporter.report(
                    {analysis, site.effect}, span, "plain",
                    {quoted(program, span), called->program().name, program.spell(counter.variable),
                     line_number(analysis.file(), queries::span_of_repetition(analysis, loop).begin)});
                finding.related.push_back(related_at_effect(*called, store->effect, "it is set here"));
            }
}

} // namespace
} // namespace maclint::rules
