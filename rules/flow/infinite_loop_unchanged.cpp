//! MAC319: nothing that decides whether a loop ends changes in it.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/loops/loop_exits.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/flow/endless_loop_words.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <string>
#include <utility>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule infinite_loop_unchanged{
    .code = "MAC319",
    .name = "infinite-loop-unchanged",
    .aliases = "DIN406",
    .summary = "Nothing that decides whether a loop ends changes in its body, or never so that it ends",
    .why = "The control repeats the same moves until somebody presses reset, or stands still without an "
           "alarm when "
           "nothing in the loop moves.",
    .severity = Severity::error,
    .severity_elsewhere = {{"dinplus", Severity::warning}, {"sinumerik", Severity::warning}},
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::Store, dataflow::Comparison>(),
    .data_flow = true,
    .messages = {{"unchanged", "Endless loop: once '{0}' is entered, nothing in it changes {1}.",
                  "Change the variable in the loop, or leave the loop."},
                 {"own-block",
                  "Endless loop: '{0}' jumps to its own block, and nothing changes {1} there: the control "
                  "hangs without an alarm.",
                  "Correct the number of the jump, or change the variable."},
                 {"never-met",
                  "Endless loop: '{0}' never ends, because '{1}' turns out the same in every pass.",
                  "Check what the loop sets its variables to."},
                 {"set-again",
                  "Endless loop: '{0}' leads back in front of '{2}', so '{1}' turns out the same in every "
                  "pass.",
                  "Jump back behind it, or set it before the loop."},
                 {"idle",
                  "Loop that only its jumps leave: nothing in it changes '{1}', and no path comes to the "
                  "block behind '{0}'.",
                  "Count in the loop what the condition asks for."},
                 {"until-stopped",
                  "Loop that only an alarm or a stop ends: once '{0}' is entered, nothing in it changes "
                  "{1}.",
                  "Change the variable in the loop, or leave the loop."},
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
    .exemptions = {{&queries::exemptions::wait_for_others,
                    "waits-for-others",
                    "The loop neither moves nor calculates, and asks for what others can change: it waits "
                    "for an operator, a robot or another path.",
                    {"fanuc", R"nc(
O9319(WAIT FOR THE ROBOT)
N1 IF[#890EQ1]GOTO2
G4 P500
GOTO1
N2 M99
)nc"}}},
    .sources = {"CNCWIKI-LOGIC"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const dataflow::Loop& loop : analysis.loops()) {
        auto words = endless_loop_words(analysis, loop);
        if (!words) continue;
        const auto by = queries::repeated_by(analysis, loop);
        const Span span = queries::span_of_repetition(analysis, loop);
        words->more.insert(words->more.begin(), quoted(analysis.program(), span));
        Finding& finding = reporter.report(by ? Cause{analysis, *by} : Cause{analysis, span}, span, words->id,
                                           std::move(words->more));
        if (words->id == "idle" || words->id == "until-stopped")
            finding.severity = Severity::warning; // it ends, if not so
        trace_round(finding, analysis, loop, words->again);
    }
}

} // namespace
} // namespace maclint::rules
