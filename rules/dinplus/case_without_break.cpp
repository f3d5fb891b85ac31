//! DIN410: a branch that may run into the next one.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <map>
#include <optional>
#include <utility>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule case_without_break{
    .code = "DIN410",
    .name = "case-without-break",
    .summary = "A branch of SWITCH that may run into the next one",
    .why = "BREAK ends a branch. What the control does without it the manual does not say: the blocks of the "
           "next branch may run, too.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"plain", "The branch of '{0}' runs into '{1}' in line {2}: no BREAK ends it. Add BREAK "
                           "after its last block."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 INPUT("Size",#l1)
N11 SWITCH #l1
N12 CASE 1
N13 G0 X20
N14 CASE 2
N15 G0 X30
N16 BREAK
N17 ENDSWITCH
N18 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 INPUT("Size",#l1)
N11 SWITCH #l1
N12 CASE 1
N13 G0 X20
N14 BREAK
N15 CASE 2
N16 G0 X30
N17 ENDSWITCH
N18 M30
END
)nc"}},
    .sources = {"SEED-003:19853"},
    .check = &check,
};

namespace {

/// The nodes of the effects that divide and close branches.
std::map<EffectId, flow::NodeId> nodes_of_regions(const ProgramAnalysis& analysis) {
    std::map<EffectId, flow::NodeId> nodes;
    for (flow::NodeId node = 0; node < analysis.graph().nodes.size(); ++node) {
        const Slice effects = analysis.graph().nodes[node].effects;
        for (Id id = effects.first; id < effects.first + effects.count; ++id)
            if (std::holds_alternative<RegionMark>(analysis.program().effects[id].what))
                nodes.emplace(id, node);
    }
    return nodes;
}

/// Whether some path leads from the branch past the head of the next one. Nodes are in the order of the text:
/// the paths of BREAK go beyond the close, those of the test to the next head itself.
bool runs_into(const ProgramAnalysis& analysis, flow::NodeId branch, flow::NodeId next, flow::NodeId close) {
    for (flow::NodeId node = branch; node < next; ++node)
        for (const flow::EdgeId id : analysis.graph().out[node]) {
            const flow::NodeId to = analysis.graph().edges[id].to;
            if (next < to && to < close && analysis.data().passable(id)) return true;
        }
    return false;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    std::map<EffectId, flow::NodeId> nodes;
    for (const flow::Region& region : analysis.regions().all) {
        if (region.region_kind != RegionKind::selection || !region.close || region.crossed) continue;
        if (nodes.empty()) nodes = nodes_of_regions(analysis);
        std::optional<EffectId> branch;
        for (const EffectId part : region.parts) {
            if (std::get<RegionMark>(program.effects[part].what).part != RegionMark::Part::middle) continue;
            const auto before = std::exchange(branch, part);
            if (!before || !runs_into(analysis, nodes.at(*before), nodes.at(part), nodes.at(*region.close)))
                continue;
            const Span span = program.effects[*before].span;
            const Span next = program.effects[part].span;
            Finding& finding = reporter.report(
                {analysis, *before}, span, "plain",
                {quoted(program, span), quoted(program, next), line_number(analysis.file(), next.begin)});
            finding.related.push_back(related_at_effect(analysis, part, "the branch goes on into this one"));
        }
    }
}

} // namespace
} // namespace maclint::rules
