//! MAC718: a condition that always holds or never does.
#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/queries/conditions.hpp"
#include "analyzer/queries/deliberate_conditions.hpp"
#include "analyzer/queries/loop_exits.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <optional>
#include <utility>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule constant_condition{
    .code = "MAC718",
    .name = "constant-condition",
    .aliases = "DIN405",
    .summary = "A condition is always true or never, because of what the program did before",
    .why = "Blocks run that should have been left out, or never run. Often another variable was "
           "meant, or an earlier test already went away with the case.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::Condition, dataflow::Comparison, dataflow::Store, dataflow::Read>(),
    .data_flow = true,
    .messages = {{"decided", "Condition {1} true: '{0}'. Correct it, or remove it."},
                 {"number", "Condition {1} true: '{0}', because {2} is {3} since line {4}."},
                 {"tested",
                  "Condition {1} true: '{0}', because of the test '{2}' in line {3}. Correct one of them."}},
    .bad = {{"fanuc", R"nc(
O9718(LEVELS, K LEVEL)
#33=0
IF[#6GT5]GOTO1
IF[#6GT10]THEN#33=20.
G90 G0 Z#33
N1 M99
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 INPUT("Diameter",#l1)
N20 IF #l1<=50
N30 THEN
N40 IF #l1>80
N50 THEN
N60 G95 F0.5
N70 ENDIF
N80 ENDIF
N90 M30
END
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 WHILE 1==1
N20 G0 X10
N30 ENDWHILE
N40 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9718(LEVELS, K LEVEL)
#33=0
IF[#6GT10]GOTO1
IF[#6GT5]THEN#33=20.
G90 G0 Z#33
N1 M99
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 INPUT("Diameter",#l1)
N20 IF #l1<=50
N30 THEN
N40 IF #l1>30
N50 THEN
N60 G95 F0.5
N70 ENDIF
N80 ENDIF
N90 M30
END
)nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

bool is_defect(const ProgramAnalysis& analysis, const dataflow::Condition& condition,
               const queries::DeliberateConditions& deliberate) {
    // Where a jump can leave it, a loop without an exit is MAC319's.
    if (condition.truth.can_hold && queries::is_loop_condition(analysis, condition))
        return queries::never_ends(analysis, condition);
    if (queries::tests_any_vacancy(analysis.program(), condition.expression))
        return false; // MAC222's and MAC228's
    return !deliberate.may_be_meant(condition);
}

void report(const ProgramAnalysis& analysis, Reporter& reporter, const dataflow::Condition& condition) {
    const bool always = condition.truth.can_hold;
    const Span span = analysis.program().expressions[condition.expression].span;
    std::vector<std::string> words{quoted(analysis.program(), span), always ? "always" : "never"};
    const auto reason = queries::reason_for(analysis, condition);
    if (reason) {
        words.push_back(reason->variable ? analysis.program().spell(*reason->variable)
                                         : quoted(analysis.program(), reason->since));
        if (reason->variable) words.push_back(number_word(reason->number));
        words.push_back(line_number(analysis.file(), reason->since.begin));
    }
    const std::string_view id = !reason ? "decided" : reason->variable ? "number" : "tested";
    Finding& finding = reporter.report({analysis, condition}, span, id, std::move(words));
    trace(finding, analysis, condition.node, always ? "it is always true" : "it is never true");
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    if (analysis.regions().balance_unknown) return; // a loop that cannot be read may repeat the block
    std::optional<queries::DeliberateConditions> deliberate; // most programs have no such condition
    for (const dataflow::Condition& condition : analysis.facts().all<dataflow::Condition>()) {
        if (condition.truth.can_hold == condition.truth.can_fail) continue;
        if (!deliberate) deliberate.emplace(analysis);
        if (is_defect(analysis, condition, *deliberate)) report(analysis, reporter, condition);
    }
}

} // namespace
} // namespace maclint::rules
