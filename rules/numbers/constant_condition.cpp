//! MAC718: a condition that always holds or never does.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/queries/conditions/guards_before.hpp"
#include "analyzer/queries/loops/loop_exits.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/numbers/condition_words.hpp"
#include "rules/numbers/constant_condition_reasons_finder.hpp"
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
    .why = "Blocks run that should not, or never run. Often another variable or another case was meant.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .yields_to = "MAC222 MAC321",
    .facts = dataflow::facts<dataflow::Condition, dataflow::Comparison, dataflow::Store, dataflow::Read>(),
    .data_flow = true,
    .messages = {{"decided", "Condition {1} true: '{0}'.", "Correct it, or remove it."},
                 {"itself", "Condition {1} true: '{0}', whatever the values are.",
                  "Exchange AND and OR, or correct a comparison."},
                 {"same-sides", "Condition {1} true: '{0}' compares a variable with itself.",
                  "Compare it with the limit that was meant."},
                 {"number", "Condition {1} true: '{0}', because {3} is {4} since line {2}.",
                  "Correct it, or remove it."},
                 {"tested", "Condition {1} true: '{0}', because of the test '{3}' on line {2}.",
                  "Correct one of them."},
                 {"repeated", "Condition {1} true: '{0}', because line {2} asks the same and leaves.",
                  "Ask here for what was meant{4}, or remove the block."}},
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
N20 ENDWHILE
N30 M30
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
    .exemptions =
        {{&exemptions::condition_on_settings,
          "asks-for-a-setting",
          "A number that somebody edits in the text decides it: with another one it turns out otherwise.",
          {"fanuc", R"nc(
O0718(PLATE)
#1=1(1 FINISH, 2 ROUGH)
#5=0
IF[#1EQ2]THEN#5=0.3
G90 G0 Z#5
M30
)nc"}},
         {&exemptions::condition_on_vacancy,
          "compared-with-vacant",
          "A side of it has never been set: another rule tells of that, or the case is one that is left "
          "over.",
          {"fanuc", R"nc(
O0718(PLATE)
IF[#10EQ1]THEN#5=0.3
G90 G0 Z50.
M30
)nc"}},
         {&exemptions::jump_to_same_place,
          "jump-to-same-place",
          "An earlier test jumps to the same place: this one is not needed, and does no harm.",
          {"fanuc", R"nc(
O9718(LEVELS, K)
IF[#6GT5]GOTO1
IF[#6GT10]GOTO1
G90 G0 Z#6
N1 M99
)nc"}},
         {&exemptions::same_block_guarded_again,
          "same-block-guarded-again",
          "Another condition guards the very same block: one of the two is not needed, and does no harm.",
          {"fanuc", R"nc(
O9718(LEVELS, K)
#33=0
IF[#6GT5]GOTO1
IF[#6LT2]THEN#33=20.
IF[#6GT10]THEN#33=20.
G90 G0 Z#33
N1 M99
)nc"}},
         {&exemptions::last_case_tested,
          "last-case-tested",
          "It is always true: what all other cases have left over is tested once more.",
          {"fanuc", R"nc(
O9718(LEVELS, K)
IF[#6GT5]GOTO1
IF[#6LE5]THEN#33=20.
G90 G0 Z#33
N1 M99
)nc"}}},
    .sources = {"T"},
    .check = &check,
};

namespace {

bool is_defect(const ProgramAnalysis& analysis, const dataflow::Condition& condition,
               const std::optional<queries::GuardBefore>& guard, const DeliberateConditions& deliberate) {
    // Where a jump can leave it, a loop without an exit is MAC319's.
    if (condition.truth.can_hold && queries::is_loop_condition(analysis, condition))
        return queries::never_ends(analysis, condition);
    if (!guard && queries::tests_any_vacancy(analysis.program(), condition.expression))
        return false; // MAC222's and MAC228's
    return !deliberate.may_be_meant(condition, guard);
}

void report(const ProgramAnalysis& analysis, Reporter& reporter, ConditionMessages& wording,
            const dataflow::Condition& condition, const std::optional<queries::GuardBefore>& guard) {
    ConditionWords words = wording.words_for(condition, guard);
    Finding& finding =
        reporter.report({analysis, condition}, words.span, words.message_id, std::move(words.arguments));
    if (words.earlier) finding.related.push_back(*std::move(words.earlier));
    trace(finding, analysis, condition.node, "it is " + words.outcome + " true");
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const bool may_repeat = analysis.regions().balance_unknown; // by a loop that cannot be read
    ConditionMessages wording(analysis);
    std::optional<DeliberateConditions> deliberate; // most programs have no such condition
    for (const dataflow::Condition& condition : analysis.facts().all<dataflow::Condition>()) {
        const auto guard = queries::guard_that_decides(analysis, condition);
        if (!guard && (may_repeat || condition.truth.can_hold == condition.truth.can_fail)) continue;
        if (!deliberate) deliberate.emplace(analysis);
        if (is_defect(analysis, condition, guard, *deliberate))
            report(analysis, reporter, wording, condition, guard);
    }
}

} // namespace
} // namespace maclint::rules
