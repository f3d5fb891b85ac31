//! MAC220: a test for 0 does not catch a missing argument.
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/values/argument_names.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"
#include "rules/variables/zero_test_misses_vacant_tests_finder.hpp"
#include "rules/variables/zero_test_misses_vacant_uses_finder.hpp"

#include <string>
#include <string_view>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule zero_test_misses_vacant{
    .code = "MAC220",
    .name = "zero-test-misses-vacant",
    .summary = "EQ 0 or NE 0 on a value that can be vacant: vacant is not equal to 0 there",
    .why =
        "When the argument is missing, the test takes it for a number other than 0: the check is passed, and "
        "arithmetic after it works with 0 all the same.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::vacancy},
    .facts = dataflow::facts<dataflow::Comparison, dataflow::Read, dataflow::Store, dataflow::Clobber>(),
    .data_flow = true,
    .messages = {{"equal", "Check skipped when {1}: vacant is not 0, '{0}' is false, and line {2} uses it.",
                  "Test it with EQ #0 as well."},
                 {"not-equal", "Check passed when {1}: vacant is not 0, '{0}' is true, and line {2} uses it.",
                  "Test it with NE #0 as well."},
                 {"equal-asked",
                  "Check skipped when {1}: vacant is not 0, and '{0}' is false. Line {2} expects that it can "
                  "be vacant.",
                  "Test it with EQ #0 here, too."},
                 {"not-equal-asked",
                  "Check passed when {1}: vacant is not 0, and '{0}' is true. Line {2} expects that it can "
                  "be vacant.",
                  "Test it with NE #0 here, too."}},
    .bad = {{"fanuc", R"nc(
O9220(PECK, K DEPTH OF ONE PECK)
IF[#6EQ0]GOTO9
#33=#5003-#6
G90 G1 Z#33
M99
N9 #3000=1(K MISSING)
)nc"}},
    .good = {{"fanuc", R"nc(
O9220(PECK, K DEPTH OF ONE PECK)
IF[#6EQ#0]GOTO9
IF[#6EQ0]GOTO9
#33=#5003-#6
G90 G1 Z#33
M99
N9 #3000=1(K MISSING)
)nc"}},
    .exemptions = {{&exemptions::zero_is_refused,
                    "zero-is-refused",
                    "0 ends in an alarm and the variable is tested for vacancy behind the test: the author "
                    "tells them apart.",
                    {"fanuc", R"nc(
O9220(BORE, D DIAMETER IF IT IS MEASURED)
IF[#7NE0]GOTO1
#3000=1(D IS 0)
N1 IF[#7EQ#0]GOTO9
G0 X#7
N9 M99
)nc"}},
                   {&exemptions::assigned_unread,
                    "assigned-in-unreadable-block",
                    "A block that cannot be read, with = behind the variable, may assign it.",
                    {"fanuc", R"nc(
O9220(DEPTH FROM H)
IF[#4EQ0]GOTO9
#4 = ABS(#26)
G0 X1.
N9 M99
)nc"}}},
    .sources = {"SEED-001:415", "NCT-174", "CSDN-VAR", "MITSU-326"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const MissedVacancy& missed : find_missed_vacancy(analysis)) {
        const dataflow::Comparison& test = *missed.test;
        const bool is_equal = test.operation == Operation::equal;
        const Span span = program.expressions[test.expression].span;
        const std::string name = program.spell(missed.variable);
        const std::string absent = queries::with_letter(program, missed.variable) +
                                   (program.is_formal(missed.variable) ? " is left out" : " is vacant");
        const std::string_view message = missed.is_used ? (is_equal ? "equal" : "not-equal")
                                                        : (is_equal ? "equal-asked" : "not-equal-asked");
        Finding& finding = reporter.report(
            {analysis, test}, span, message,
            {quoted(program, span), absent, line_number(analysis.file(), missed.shows.begin)});
        finding.same_cause = program.name + (is_equal ? " EQ" : " NE"); // a habit
        finding.related.push_back(
            {analysis.source(), missed.shows,
             name + (missed.is_used ? " is used here" : " is tested for vacancy here")});
        const std::string ends = name + " is compared with 0";
        if (missed.value->vacancy_origin == 0)
            trace(finding, analysis, test.node, ends);
        else
            trace_vacancy(finding, analysis, missed.value->vacancy_origin, name, test.node, ends);
    }
}

} // namespace
} // namespace maclint::rules
