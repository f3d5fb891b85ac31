//! MAC415: a reference position return while a modal call is active.
#include "analyzer/machine/step.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/modes_at.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/fixes.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule reference_under_modal_call{
    .code = "MAC415",
    .name = "g66-active-reference",
    .summary = "A return to a reference position, or a move with a length offset, under a modal macro call",
    .why = "Both are moves like any other: the macro is called at their end, and drills or probes there.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::modal_calls},
    .facts = dataflow::facts<dataflow::BeforeNode>(),
    .data_flow = true,
    .messages = {{"return",
                  "Reference return under a modal call: '{0}' moves while '{1}' of line {2} is active, which "
                  "calls the macro at its end.",
                  "Write {3} before it."},
                 {"offset",
                  "Length offset under a modal call: '{0}' moves while '{1}' of line {2} is active, which "
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

bool moves(const Effect& effect) { return std::holds_alternative<Motion>(effect.what); }

/// A move that is not meant for the macro.
struct OtherMove {
    Span span;
    bool by_offset; ///< it takes up a length offset; else it returns to a reference position
};

std::optional<OtherMove> other_move(const ProgramAnalysis& analysis, const BlockView& block) {
    const auto effects = analysis.program().effects_in(block.effects);
    const bool by_offset = machine::sets(analysis.control(), block, ModalRole::length_compensation);
    const auto motion = std::ranges::find_if(effects, by_offset ? moves : returns_to_reference);
    if (motion != effects.end()) return OtherMove{motion->span, by_offset};
    return by_offset && block.moves ? std::optional(OtherMove{block.span, true}) : std::nullopt;
}

bool has_modal_calls(const Program& program, GroupId group) {
    return std::ranges::any_of(program.effects, [&](const Effect& effect) {
        const auto* sets = std::get_if<SetModal>(&effect.what);
        return sets != nullptr && sets->group == group;
    });
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const auto group = analysis.control().group_with(ModalRole::macro_call);
    if (!group || !has_modal_calls(program, *group)) return;
    const ModalGroup& calls = analysis.control().groups[*group];
    std::set<Offset> told; // blocks that begin a call: one finding for each
    queries::for_each_block_with_modes(analysis, [&](const BlockView& block, queries::BlockModes modes_of) {
        const auto move = other_move(analysis, block);
        if (!move) return;
        const queries::Modes modes = modes_of.before(*group);
        const auto node = analysis.graph().node_of(block.span);
        if (modes.unknown || !node) return;
        for (const queries::Mode& mode : modes.possible) {
            if (mode.set_by != queries::Mode::SetBy::word || mode.code == calls.cancel) continue;
            const Span begun = queries::span_of(analysis, mode);
            if (!told.insert(begun.begin).second) continue;
            const std::string end = analysis.control().spell(*group, *calls.cancel);
            const Cause cause =
                mode.origin == 0 ? Cause{analysis, block.span} : cause_at(analysis, mode.origin);
            Finding& finding = reporter.report(cause, move->span, move->by_offset ? "offset" : "return",
                                               {quoted(program, move->span), quoted(program, begun),
                                                line_number(analysis.file(), begun.begin), end});
            offer_block_before(finding, Applicability::unsafe, move->span, end);
            trace(finding, analysis, mode.node, {analysis.source(), begun, "the modal call begins here"},
                  *node, "it is still active here");
        }
    });
}

} // namespace
} // namespace maclint::rules
