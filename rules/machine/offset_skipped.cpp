//! Looks for a path around the block that chooses the offset.
#include "rules/machine/offset_skipped.hpp"

#include "analyzer/queries/paths/feasible_paths.hpp"
#include "rules/path.hpp"

#include <array>

namespace maclint::rules {

void look_for_offset_skipped(const MachineStep& at, Reporter& reporter) {
    using machine::Known;
    const machine::State& state = at.after();
    const Known::Kind moved = at.before().moved_in_z.kind;
    if (state.length_offset.kind != Known::Kind::unknown || state.without_offset_since == machine::no_block ||
        state.offset_chosen_at == machine::no_block)
        return;
    if (moved != Known::Kind::unknown && !at.before().moved_in_z.is(0)) return;
    // That tool's own choice is one of them.
    if (at.habits.tools_with_length_offset() < 2) return;
    const Known change = Known::of(0, state.without_offset_since),
                choice = Known::of(0, state.offset_chosen_at);
    if (at.told.contains(change.block)) return;
    const Span changing = at.block_of(change), choosing = at.block_of(choice);
    const flow::Graph& graph = at.analysis.graph();
    const auto from = graph.node_of(changing), around = graph.node_of(choosing),
               here = graph.node_of(at.block());
    if (!from || !around || !here) return;
    if (!queries::can_follow(at.analysis, *from, *here, std::array{*around})) return;
    at.told.insert(change.block);
    Finding& finding = reporter.report(at.cause(), at.place_of('Z'), "path",
                                       {at.quoted_block(), "line " + at.line_of(change),
                                        quoted(at.analysis.program(), choosing), at.line_of(choice)});
    finding.related.push_back(at.at(change, "the tool is changed here"));
    finding.related.push_back(at.at(choice, "a path leads around this"));
}

} // namespace maclint::rules
