//! MAC319: nothing that decides whether a loop ends changes in it.
#include "analyzer/queries/loop_exits.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/listed.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <string>
#include <utility>
#include <vector>

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
    .messages = {{"unchanged", "Endless loop: once '{0}' is entered, nothing in it changes {1}.",
                  "Change the variable in the loop, or leave the loop."},
                 {"own-block",
                  "Endless loop: '{0}' jumps to its own block, and nothing changes {1} there: the control "
                  "hangs without an alarm.",
                  "Correct the number of the jump, or change the variable."},
                 {"no-exit", "Endless loop: nothing leads out of '{0}'.",
                  "Count in a variable that its condition asks, or leave it."}},
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

std::string list(const Program& program, const std::vector<Variable>& variables) {
    std::vector<std::string> names;
    for (const Variable variable : variables) names.push_back(program.spell(variable));
    return listed(names, " or ");
}

bool has_no_condition(const ProgramAnalysis& analysis, const dataflow::Loop& loop) {
    const flow::Region* region = queries::region_of(analysis, loop);
    return region != nullptr && region->region_kind == RegionKind::endless_loop;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const dataflow::Loop& loop : analysis.loops()) {
        if (loop.can_stop) continue;
        // A jump back without a condition and an exit repeats a program on purpose, as M99 does.
        if (queries::is_endless_by_jumps(loop)) continue;
        if (has_no_condition(analysis, loop)) continue; // MAC318 owns DO without WHILE
        // MAC336 tells of cycles of jumps that nothing leaves, once for all paths back.
        if (queries::is_in_endless_jumps(analysis, loop)) continue;
        const auto deciders = queries::unchanging_deciders(analysis, loop);
        if (!deciders) continue;
        // MAC718 tells of a condition without variables, where nothing but the condition can end a loop.
        if (deciders->empty() && !analysis.control().loops_left_by_jump) continue;
        const auto by = queries::repeated_by(analysis, loop);
        const Span span = queries::span_of_repetition(analysis, loop);
        const Cause cause = by ? Cause{analysis, *by} : Cause{analysis, span};
        std::vector<std::string> words{quoted(analysis.program(), span)};
        if (!deciders->empty()) words.push_back(list(analysis.program(), *deciders));
        const bool own_block = !loop.region && loop.body.size() <= 2;
        const std::string_view id = deciders->empty() ? "no-exit" : own_block ? "own-block" : "unchanged";
        Finding& finding = reporter.report(cause, span, id, std::move(words));
        trace_round(finding, analysis, loop, "and nothing has changed");
    }
}

} // namespace
} // namespace maclint::rules
