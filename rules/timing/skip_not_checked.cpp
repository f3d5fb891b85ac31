//! MAC607: an offset is made of where the probe touched, and nothing asks whether it did.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/timing/skip_not_checked_finder.hpp"
#include "rules/timing/skip_not_checked_twins_finder.hpp"
#include "rules/trace.hpp"

#include <algorithm>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule skip_not_checked{
    .code = "MAC607",
    .name = "skip-not-checked",
    .summary =
        "An offset is made of the position where a probe should have touched, without a test whether it did, "
        "or of two touches only one is tested",
    .why =
        "Where no signal comes, G31 runs to its end, and the position is that end. With the part missing or "
        "the probe switched off the offset is wrong by the rest of the way, and the next tool follows it.",
    .severity = Severity::note,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::Comparison, dataflow::Read, dataflow::Store>(),
    .data_flow = true,
    .messages =
        {{"unchecked",
          "Touch not checked: '{0}' may run to its end without a signal, and '{1}' makes an offset of "
          "the position in '{2}' all the same.",
          "Compare the position with the end of the move, and raise an alarm where they are the same."},
         {"twin",
          "Touch not checked: '{0}' may run to its end without a signal; '{1}' takes its position as '{2}' "
          "does "
          "behind a move whose end is asked for.",
          "Ask for it here, too."}},
    .bad = {{"fanuc", R"nc(
O9607(SET X0)
G91 G31 X30. F80.
G90
G10 L2 P1 X[#5021-3.]
G0 X-10.
M99
)nc"},
            {"fanuc", R"nc(
O9607(SET Z0)
G91 G31 Z-20. F80.
#31=#5063
G0 Z10.
G90
#5223=#5223+#31
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9607(SET X0)
#1=#5041+30.
G91 G31 X30. F80.
G90
G53
IF[ABS[#5061-#1]LT.005]THEN#3000=5(NO CONTACT)
G10 L2 P1 X[#5021-3.]
G0 X-10.
M99
)nc"},
             {"fanuc", R"nc(
O9607(SET X0, THE SENSOR IS ASKED)
G91 G31 X30. F80.
G90
IF[#1004EQ0]GOTO9
G10 L2 P1 X[#5061-3.]
M99
N9 #3000=5(NO CONTACT)
)nc"},
             {"fanuc", R"nc(
O9608(THE WAY IS ASKED FOR BEHIND IT)
#1=#5043
G91 G31 Z-20. F50.
G90
#2=#1-#5063
#5223=#5063
IF[#2GT19.99]GOTO9
M99
N9 #3000=1(NO TOUCH)
)nc"},
             {"fanuc", R"nc(
O9607(SET X0 WHERE THE TOOL STANDS)
G90 G1 X0 F200.
G53
G10 L2 P1 X[#5021-3.]
M99
)nc"}},
    .sources = {"SEED-001:1376"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    std::vector<flow::NodeId> told;
    for (const UncheckedTouch& touch : find_unchecked_touches(analysis)) {
        told.push_back(touch.move);
        const Span use = program.effects[touch.use].span;
        Finding& finding = reporter.report(
            {analysis, touch.move_span}, touch.move_span, "unchecked",
            {quoted(program, touch.move_span), quoted(program, use), quoted(program, touch.read)});
        trace(finding, analysis, touch.move, {analysis.source(), touch.move_span, "no signal may come here"},
              touch.used_in, "when the offset is made");
    }
    for (const UncheckedTwin& twin : find_unchecked_twins(analysis)) {
        if (std::ranges::find(told, twin.move) != told.end()) continue;
        const Span checked = program.effects[twin.checked].span;
        reporter
            .report({analysis, twin.move_span}, twin.move_span, "twin",
                    {quoted(program, twin.move_span), quoted(program, program.effects[twin.store].span),
                     quoted(program, checked)})
            .related.push_back({analysis.source(), checked, "this one is checked"});
    }
}

} // namespace
} // namespace maclint::rules
