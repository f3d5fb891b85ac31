//! MAC415: a reference position return while a modal call is active.
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/modes_at.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/fixes.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>
#include <set>
#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule reference_under_modal_call{
    .code = "MAC415",
    .name = "g66-active-reference",
    .summary = "A reference position return is commanded while a modal macro call is active",
    .why = "The return is a move like any other: the macro is called at its end, and drills or probes at the"
           " reference position.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::modal_calls},
    .facts = dataflow::facts<dataflow::BeforeNode>(),
    .data_flow = true,
    .messages = {{"return",
                  "Reference return under a modal call: '{0}' moves while '{1}' of line {2} is active, which "
                  "calls the macro at its end.",
                  "Write {3} before it."}},
    .bad = {{"fanuc", R"nc(
O9415(ROW)
G66 P9010 Z-20. R5.
G0 X10. Y0
X20.
G91 G28 Z0
G90 G67
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9415(ROW)
G66 P9010 Z-20. R5.
G0 X10. Y0
X20.
G67
G91 G28 Z0
G90
M30
)nc"}},
    .sources = {"CNCWIKI-CALL"},
    .check = &check,
};

namespace {

bool returns_to_reference(const Effect& effect) {
    const auto* motion = std::get_if<Motion>(&effect.what);
    return motion != nullptr && motion->to_reference;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const auto group = analysis.control().group_with(ModalRole::macro_call);
    if (!group) return;
    const ModalGroup& calls = analysis.control().groups[*group];
    queries::ModesAt modes_at(analysis);
    std::set<Offset> told; // blocks that begin a call: one finding for each
    for_each_block_with_effects(program, [&](const BlockView& block) {
        const auto effects = program.effects_in(block.effects);
        const auto motion = std::ranges::find_if(effects, returns_to_reference);
        if (motion == effects.end()) return;
        const queries::Modes modes = modes_at(block).before(*group);
        if (modes.unknown) return;
        const auto effect = static_cast<EffectId>(block.effects.first + (motion - effects.begin()));
        for (const queries::Mode& mode : modes.possible) {
            if (mode.set_by != queries::Mode::SetBy::word || mode.code == calls.cancel) continue;
            const Span begun = queries::span_of(analysis, mode);
            if (!told.insert(begun.begin).second) continue;
            const std::string end = analysis.control().spell(*group, *calls.cancel);
            const Cause cause = mode.origin == 0 ? Cause{analysis, effect} : cause_at(analysis, mode.origin);
            Finding& finding = reporter.report(cause, motion->span, "return",
                                               {quoted(program, motion->span), quoted(program, begun),
                                                line_number(analysis.file(), begun.begin), end});
            offer_block_before(finding, Applicability::unsafe, motion->span, end);
            trace(finding, analysis, mode.node, {analysis.source(), begun, "the modal call begins here"},
                  *analysis.graph().node_of(effect), "it is still active here");
        }
    });
}

} // namespace
} // namespace maclint::rules
