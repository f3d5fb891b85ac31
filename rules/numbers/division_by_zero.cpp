//! MAC702: a division whose divisor is 0, or may be.
#include "analyzer/dataflow/facts/application.hpp"
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/queries/vacancy/unset_reads.hpp"
#include "rules/operand_risk.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>
#include <optional>
#include <set>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule division_by_zero{
    .code = "MAC702",
    .name = "division-by-zero",
    .summary = "The divisor of a division is 0, or an argument or common that nothing checks",
    .why =
        "A FANUC control stops with an alarm, with the tool where it happens to be; vacant counts as 0 "
        "there. The manual of DIN PLUS does not say what comes out. An error where the divisor is always 0, "
        "a warning where a call shows it or the program checks other things, else a note.",
    .severity = Severity::error,
    .severity_elsewhere = {{"dinplus", Severity::warning}},
    .precision = Precision::very_high,
    .yields_to = "MAC210 DIN330",
    .facts = dataflow::facts<dataflow::Application, dataflow::Comparison, dataflow::Condition, dataflow::Read,
                             dataflow::Store>(),
    .data_flow = true,
    .messages = {{"zero", "Division by 0: '{0}' divides by '{1}', which is always 0 here.",
                  "Correct the divisor, or divide only where it is not 0."},
                 {"number", "Division by 0: '{0}' can have no value.", "Correct the divisor."},
                 {"vacant", "Division by a vacant variable: '{0}' divides by '{1}', which counts as 0.",
                  "Correct the divisor, or divide only where it is set and not 0."},
                 {"passed", "Division by 0: '{0}' divides by 0 for the call on line {3} of {4}.",
                  "Pass another value, or divide only where it is not 0."},
                 {"left-out", "Division by 0: '{0}', as the call on line {3} of {4} leaves out {2}.",
                  "Pass it, or divide only where it is not 0."},
                 {"lets-zero-pass",
                  "Division by 0 possible: '{3}' lets {2} pass when it is 0, and '{0}' divides by it.",
                  "Test it against 0, too."},
                 {"asked-vacancy",
                  "Division by 0 possible: {2} is asked for, not whether it is 0, and '{0}' divides by it.",
                  "Test it against 0, too."},
                 {"others-checked",
                  "Division by 0 possible: the program checks {3}, but not {2}, and '{0}' divides by it.",
                  "Test it against 0, too."},
                 {"unchecked", "Division by 0 possible: nothing checks {2}, and '{0}' divides by it.",
                  "Divide only where it is not 0."}},
    .bad = {{"fanuc", R"nc(
O9702(HOLES ON A CIRCLE, A NUMBER)
#5=0
G90 G0 X[360/#5]
M99
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 #l1=0
N20 #l2=46/#l1
N40 M30
END
)nc"},
            {"fanuc", R"nc(
O9702(HOLES ON A CIRCLE, A NUMBER)
IF[#1LT0]THEN#3000=1(A NEGATIVE)
G90 G0 X[360/#1]
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9702(HOLES ON A CIRCLE, A NUMBER)
IF[ABS[#1]LE0]THEN#3000=1(A MISSING)
G90 G0 X[360/#1]
M99
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 #l1=2
N20 #l2=46/#l1
N40 M30
END
)nc"}},
    .exemptions = {{&queries::exemptions::compared_before,
                    "compared-before",
                    "The program compares the argument before: its author has thought of other values.",
                    {"fanuc", R"nc(
O9702(INDEX, V PARTS)
IF[#22EQ1]GOTO1
G91 G0 A[360/#22]
N1 M99
)nc"}}},
    .alarms = {{"FANUC 16i/18i/21i", "112", "DIVIDED BY ZERO"},
               {"FANUC 30i/0i-D", "112", "ZERO DIVIDE"},
               {"SINUMERIK", "14051", "arithmetic error", false}},
    .sources = {"CNCWIKI-MACB", "GH-ALM"},
    .check = &check,
};

namespace {

/// What to say of the division; nothing where it is not certain, or somebody else's.
std::optional<std::string_view> message_for(const ProgramAnalysis& analysis,
                                            const dataflow::Application& division) {
    const dataflow::Value& divisor = division.right;
    if (division.operation != Operation::divide || divisor.low != 0 || divisor.high != 0) return std::nullopt;
    // A variable that nothing has set is MAC209's, and what is undefined only may read as 0.
    if (queries::is_owed_to_missing_value(analysis, division.effect, division.right_expression) ||
        queries::may_be_left_out(analysis.program(), analysis.facts(), division.effect, division.expression))
        return std::nullopt;
    if (divisor.vacancy == dataflow::Vacancy::vacant) return "vacant";
    const auto& node = analysis.program().expressions[division.right_expression].node;
    return std::holds_alternative<Literal>(node) ? "number" : "zero";
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    std::set<dataflow::OriginId> said; // one store, one finding
    for (const dataflow::Application& division : analysis.facts().all<dataflow::Application>()) {
        const auto message = message_for(analysis, division);
        const dataflow::OriginId stored = division.right.origin;
        if (!message || (stored != 0 && !said.insert(stored).second)) continue;
        const Span span = program.expressions[division.expression].span;
        const Span divisor = program.expressions[division.right_expression].span;
        Finding& finding = reporter.report({analysis, division}, span, *message,
                                           {quoted(program, span), quoted(program, divisor)});
        if (stored == 0)
            trace(finding, analysis, division.node, "the divisor is 0");
        else
            trace(finding, analysis, stored, "this value is 0", division.node, "it is the divisor");
    }
    report_risks(analysis, Operation::divide, reporter);
}

} // namespace
} // namespace maclint::rules
