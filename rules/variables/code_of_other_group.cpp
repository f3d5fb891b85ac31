//! MAC234: a condition looks for a modal code in a group that has no such code.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/program/tables.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/variables/code_of_other_group_finder.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule code_of_other_group{
    .code = "MAC234",
    .name = "code-of-other-group",
    .summary = "A condition compares the modal code of one group with a code of another",
    .why = "#4007 reads whether G40, G41 or G42 is in force, #4008 the same of G43, G44 and G49. Asked for a "
           "code "
           "of the other, the condition has one answer whatever is in force, and what it should prevent "
           "happens.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .facts = dataflow::facts<dataflow::Comparison>(),
    .messages =
        {{"other-group",
          "Code of another group: '{0}' is {1}, because {2} reads the code of {3}, and {4} is one of {5}.",
          "Read {6}."}},
    .bad = {{"fanuc", R"nc(
O9234(PROBE WITHOUT COMPENSATION, X)
IF[#4008NE40]GOTO9
G17 G91 G31 X#24 F80.
G90
M99
N9 #3000=1(CANCEL G41)
)nc"}},
    .good = {{"fanuc", R"nc(
O9234(PROBE WITHOUT COMPENSATION, X)
IF[#4007NE40]GOTO9
IF[#4008EQ49]GOTO9
G17 G91 G31 X#24 F80.
G90
M99
N9 #3000=1(CANCEL G41, OR G43 IS MISSING)
)nc"}},
    .sources = {"SEED-001:1340-1357"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const CodeOfOtherGroup& found : find_codes_of_other_groups(analysis)) {
        const Span span = program.expressions[found.comparison->expression].span;
        const auto& groups = analysis.control().groups;
        reporter.report({analysis, *found.comparison}, span, "other-group",
                        {quoted(program, span),
                         found.comparison->operation == Operation::equal ? "never true" : "always true",
                         quoted(program, program.expressions[found.read].span),
                         std::string(groups[found.group].name), found.code,
                         std::string(groups[found.other].name), found.meant});
    }
}

} // namespace
} // namespace maclint::rules
