//! MAC216: a common variable is read that keeps what an earlier run has left in it.
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "rules/rule.hpp"
#include "rules/variables/common_stale_read_checks_finder.hpp"
#include "rules/variables/common_stale_read_words.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule common_stale_read{
    .code = "MAC216",
    .name = "common-stale-read",
    .summary =
        "A common variable is set for some numbers of a decision, and read for another that the program "
        "asks for as well, or checked before the program sets it",
    .why = "The variable still holds what the run before has left there, or is vacant after the control was "
           "switched on: the program runs with the number of another part.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::Read, dataflow::Comparison, dataflow::Store, dataflow::Clobber>(),
    .data_flow = true,
    .messages = {{"case",
                  "Value from the run before: {0} is set for {1} only, and read here for {2}, which "
                  "line {3} asks for.",
                  "Set it in that case, too, or refuse the case with an alarm."},
                 {"way",
                  "Value from the run before: {0} is set on one way from '{1}' only, and read here behind "
                  "both; the other way sets {2} on line {3}, and leaves {0}.",
                  "Set it there, too, or before the condition."},
                 {"left-out",
                  "Value from the run before: line {1} alone sets {0}, '{2}' passes it by, and {0} is read "
                  "here all the same.",
                  "Set it in that case, too, or before the condition."},
                 {"limit",
                  "Value from the run before: '{0}' looks at {1}, which the program sets on line {2} only.",
                  "Move the check behind that line, or correct the variable."}},
    .bad = {{"fanuc", R"nc(
O9216(PASSES)
IF[#4012EQ54]GOTO1
IF[#4012EQ55]GOTO1
IF[#4012EQ56]GOTO1
#3000=1(WORK OFFSET)
N1
IF[#4012EQ54]THEN#103=3
IF[#4012EQ56]THEN#103=2
G0 X#103
M99
)nc"},
            {"fanuc", R"nc(
O9217(POCKET, Z DEPTH R CLEARANCE W START)
IF[#26LE0]GOTO9
IF[#106+#23GT80.]GOTO9
#106=#26-#18
G0 Z-#106
G0 Z#23
M99
N9 #3000=1(Z OR TOOL LENGTH)
)nc"},
            {"fanuc", R"nc(
O9218(TWO SIZES, A)
IF[#1EQ2]GOTO10
#101=20
#102=8
GOTO20
N10 #101=32
N20 G90 G0 X#101
Y#102
M99
)nc"},
            {"fanuc", R"nc(
O9219(SLOT, H ALLOWANCE)
IF[#11EQ#0]GOTO10
#101=#11*2
N10 G90 G0 X[#24+#101]
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9216(PASSES)
IF[#4012EQ54]GOTO1
IF[#4012EQ56]GOTO1
#3000=1(WORK OFFSET)
N1
IF[#4012EQ54]THEN#103=3
IF[#4012EQ56]THEN#103=2
G0 X#103
M99
)nc"},
             {"fanuc", R"nc(
O9217(POCKET, Z DEPTH R CLEARANCE W START)
IF[#26LE0]GOTO9
#106=#26-#18
IF[#106+#23GT80.]GOTO9
G0 Z-#106
G0 Z#23
M99
N9 #3000=1(Z OR TOOL LENGTH)
)nc"},
             {"fanuc", R"nc(
O9219(SLOT, H ALLOWANCE)
#101=0
IF[#11EQ#0]GOTO10
#101=#11*2
N10 G90 G0 X[#24+#101]
M99
)nc"}},
    .exemptions = {{&exemptions::held_against_last_value,
                    "held-against-the-last-value",
                    "The limit looks at what the new value is calculated from, too: it holds this run "
                    "against the last one.",
                    {"fanuc", R"nc(
O9216(GAP, X)
IF[ABS[#100-#24]GT1.]GOTO9
#100=#24*2
G90 G0 X#100
M99
N9 #3000=1(MOVED)
)nc"}}},
    .sources = {"SEED-002:357"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    report_limits(analysis, reporter);
    report_cases(analysis, reporter);
    report_ways(analysis, reporter);
}

} // namespace
} // namespace maclint::rules
