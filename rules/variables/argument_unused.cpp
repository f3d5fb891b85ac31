//! MAC211: a call passes a value that the called program never reads.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/calls/unread_arguments.hpp"
#include "rules/rule.hpp"
#include "rules/variables/unread_arguments.hpp"

#include <utility>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule argument_unused{
    .code = "MAC211",
    .name = "argument-unused",
    .aliases = "DIN513 MAC212",
    .summary = "A call passes a value that the called program never reads, or overwrites first",
    .why =
        "Whoever wrote the call counts on a depth, a radius or a clearance that changes nothing. Often the "
        "letter is the wrong one, or the program is another version than the call was written for.",
    .severity = Severity::warning,
    .severity_elsewhere = {{"dinplus", Severity::note}},
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::Comparison, dataflow::Read, dataflow::Store>(),
    .messages = {{"unread", "Argument never read: {0} does not read {1}, which '{2}' passes.",
                  "Correct the letter, or leave it out."},
                 {"several", "Arguments never read: {0} reads none of {1}, which this call passes.",
                  "Correct the letters, or leave them out."},
                 {"overwritten",
                  "Argument never read: {0} sets {1}, which '{2}' passes, on line {3} before it reads it.",
                  "Read it first, or leave it out of the call."},
                 {"default",
                  "Default where a value was passed: '{0}' replaces {1} when it is there, by the test '{2}', "
                  "and nothing reads what was passed.",
                  "Turn the test around, EQ for NE."}},
    .bad = {{"fanuc", R"nc(
O0211(PLATE)
G65 P9211 Z-5. K2. F100.
M30
O9211(DRILL, Z Q F)
G90 G1 Z#26 F#9
IF[#17EQ#0]GOTO1
G0 Z[#26+#17]
N1 M99
)nc"},
            {"fanuc", R"nc(
O9212(DRILL, Z F)
IF[#9NE#0]THEN #9=120.
G90 G1 Z#26 F#9
M99
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 L"CHAMFER" LA50 LB2
N20 M30
SUBPROGRAM "CHAMFER"
N30 G0 X#__la
RETURN
END
)nc"}},
    .good = {{"fanuc", R"nc(
O0211(PLATE)
G65 P9211 Z-5. Q2. F100.
M30
O9211(DRILL, Z Q F)
G90 G1 Z#26 F#9
IF[#17EQ#0]GOTO1
G0 Z[#26+#17]
N1 M99
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 L"CHAMFER" LA50 LB2
N20 M30
SUBPROGRAM "CHAMFER"
N30 G0 X#__la
N40 IF DEF(__lb)
N50 THEN
N60 G1 Zi-#__lb
N70 ENDIF
RETURN
END
)nc"}},
    .exemptions = {{&queries::exemptions::program_to_be_written,
                    "program-to-be-written",
                    "The called program reads no argument at all: it stands in for one that is still to be "
                    "written, or for one of the machine's maker.",
                    {"fanuc", R"nc(
O0211(PLATE)
G65 P9211 Z-5. Q2. F100.
M30
O9211(DRILL, TO BE WRITTEN)
M99
)nc"}}},
    .sources = {"SEED-003:19938", "T"},
    .check = &check,
};

namespace {

using queries::UnreadArgument;

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    report_defaults(analysis, reporter);
    std::vector<UnreadArgument> together;
    const auto flush = [&] {
        if (!together.empty()) report_unread(analysis, std::exchange(together, {}), reporter);
    };
    for (UnreadArgument& unread : queries::unread_arguments(analysis)) {
        if (!together.empty() && together.front().call != unread.call) flush();
        if (unread.overwritten)
            report_unread(analysis, {unread}, reporter);
        else
            together.push_back(std::move(unread));
    }
    flush();
}

} // namespace
} // namespace maclint::rules
