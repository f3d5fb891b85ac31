//! MAC319: nothing that decides whether a loop ends changes in it.
#include "analyzer/dataflow/conditions.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule infinite_loop_unchanged{
    .code = "MAC319",
    .name = "infinite-loop-unchanged",
    .aliases = "DIN406",
    .summary = "Nothing that decides whether a loop ends changes in its body: once entered, it never ends",
    .why = "The control repeats the same moves until somebody presses reset, or stands still without an "
           "alarm when "
           "nothing in the loop moves.",
    .severity = Severity::error,
    .severity_elsewhere = {{"dinplus", Severity::warning}},
    .precision = Precision::high,
    .data_flow = true,
    .messages = {{"unchanged",
                  "The loop of '{0}' never ends once it runs: nothing in it changes {1}. Change the "
                  "variable in the loop, or leave the loop."},
                 {"no-exit",
                  "The loop of '{0}' never ends: nothing leads out of it. Count in a variable that "
                  "its condition asks, or leave it."}},
    .bad = {{"fanuc", R"nc(
O9319(ROWS)
#33=0
WHILE[#33LT5]DO1
G91 G1 X10.
G90
END1
M99
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 INPUT("Light cuts",#l1)
N20 #l2=0
N30 WHILE #l1>0
N40 G0 X200-#l2
N50 G1 Z-180
N60 #l2=#l2+1
N70 ENDWHILE
N80 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9319(ROWS)
#33=0
WHILE[#33LT5]DO1
G91 G1 X10.
G90
#33=#33+1
END1
M99
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 INPUT("Light cuts",#l1)
N20 #l2=0
N30 WHILE #l1>#l2
N40 G0 X200-#l2
N50 G1 Z-180
N60 #l2=#l2+1
N70 ENDWHILE
N80 M30
END
)nc"}},
    .sources = {"CNCWIKI-LOGIC"},
    .check = &check,
};

namespace {

/// What decides over the loop's exits, when nothing of it can change in the loop.
struct Deciders {
    std::vector<Variable> variables;
    bool fixed = true;
};

/// A loop that neither moves nor computes waits for somebody else: an operator, a robot, another path.
bool waits(const ProgramAnalysis& analysis, const dataflow::Loop& loop) {
    for (const flow::NodeId node : loop.body) {
        const flow::Node& n = analysis.graph().nodes[node];
        if (n.is_run && moves(analysis.program(), n.stretch())) return false;
        for (const Effect& effect : analysis.program().effects_in(n.effects))
            if (std::holds_alternative<Motion>(effect.what) || std::holds_alternative<Assign>(effect.what))
                return false;
    }
    return true;
}

Deciders deciders_of(const ProgramAnalysis& analysis, const dataflow::Loop& loop) {
    Deciders deciders;
    const bool others_may = loop.has_unknown_effects || waits(analysis, loop);
    const auto can_change = [&](Variable variable) {
        const bool own = analysis.control().spaces[variable.space].scope == Scope::frame;
        return (!own && others_may) || loop.changes.may_change(variable);
    };
    for (const flow::EdgeId id : loop.exit_edges) {
        const auto& condition = analysis.graph().edges[id].condition;
        if (!condition) return {{}, false};
        const dataflow::ReadSet set = dataflow::variables_of(analysis.program(), *condition);
        if (!set.closed) return {{}, false};
        for (const Variable variable : set.variables) {
            if (can_change(variable)) return {{}, false};
            if (std::ranges::find(deciders.variables, variable) == deciders.variables.end())
                deciders.variables.push_back(variable);
        }
    }
    return deciders;
}

std::string list(const Program& program, const std::vector<Variable>& variables) {
    std::string text;
    for (std::size_t i = 0; i < variables.size(); ++i) {
        if (i != 0) text += i + 1 == variables.size() ? " or " : ", ";
        text += program.spell(variables[i]);
    }
    return text;
}

/// WHILE … DO, DO, or the jump that closes the loop.
std::optional<EffectId> repeated_by(const ProgramAnalysis& analysis, const dataflow::Loop& loop) {
    if (loop.region) return analysis.regions().all[*loop.region].open;
    return analysis.graph().edges[loop.back].jump;
}

/// MAC336 tells of cycles of jumps that nothing leaves, once for all paths back.
bool is_in_endless_jumps(const ProgramAnalysis& analysis, const dataflow::Loop& loop) {
    return std::ranges::any_of(analysis.inescapable_cycles(), [&](const dataflow::Loop& cycle) {
        return !cycle.region && cycle.exit_edges.empty() && cycle.holds(loop.head);
    });
}

bool has_no_condition(const ProgramAnalysis& analysis, const dataflow::Loop& loop) {
    return loop.region && analysis.regions().all[*loop.region].region_kind == RegionKind::endless_loop;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const dataflow::Loop& loop : analysis.loops()) {
        if (loop.can_stop) continue;
        // A jump back without a condition and an exit repeats a program on purpose, as M99 does.
        if (!loop.region && loop.exit_edges.empty()) continue;
        if (has_no_condition(analysis, loop)) continue; // MAC318 owns DO without WHILE
        if (is_in_endless_jumps(analysis, loop)) continue;
        const Deciders deciders = deciders_of(analysis, loop);
        if (!deciders.fixed) continue;
        // MAC718 tells of a condition without variables, where nothing but the condition can end a loop.
        if (deciders.variables.empty() && !analysis.control().loops_left_by_jump) continue;
        const auto by = repeated_by(analysis, loop);
        const Span span = by ? analysis.program().effects[*by].span : analysis.graph().nodes[loop.latch].part;
        const Cause cause = by ? Cause{analysis, *by} : Cause{analysis, span};
        const std::string text = quoted(analysis.program(), span);
        Finding& finding = deciders.variables.empty()
                               ? reporter.report(cause, span, "no-exit", {text})
                               : reporter.report(cause, span, "unchanged",
                                                 {text, list(analysis.program(), deciders.variables)});
        trace_round(finding, analysis, loop, "and nothing has changed");
    }
}

} // namespace
} // namespace maclint::rules
