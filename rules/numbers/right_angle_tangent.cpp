//! MAC704: the tangent of a right angle.
#include "analyzer/dataflow/facts/application.hpp"
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/semantics/concrete.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/operand_risk.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <array>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule right_angle_tangent{
    .code = "MAC704",
    .name = "tan-90",
    .summary = "The tangent of 90 degrees, or of 90 less an argument that nothing checks against 0",
    .why = "The tangent of a right angle has no value: a FANUC control stops with the alarm of a division by "
           "0, with the tool where it happens to be.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::Application, dataflow::Comparison, dataflow::Condition, dataflow::Read,
                             dataflow::Store>(),
    .data_flow = true,
    .messages =
        {{"right-angle", "Tangent of a right angle: '{0}' has no value, its angle is {1}.",
          "Treat that angle on a path of its own."},
         {"passed", "Tangent of a right angle: the angle of '{0}' is one for the call on line {3} of {4}.",
          "Pass another angle, or treat that one on a path of its own."},
         {"left-out",
          "Tangent of a right angle: the call on line {3} of {4} leaves out {2}, which counts as 0, and "
          "the angle of '{0}' is one then.",
          "Pass it, or check it first."},
         {"lets-zero-pass",
          "Tangent of a right angle possible: '{3}' lets {2} pass when it is 0, and '{0}' has no value "
          "then.",
          "Test it against 0, too."},
         {"asked-vacancy",
          "Tangent of a right angle possible: the program asks whether {2} was passed, not whether it is "
          "0, and '{0}' has no value then.",
          "Test it against 0, too."},
         {"others-checked",
          "Tangent of a right angle possible: the program checks {3}, but not {2}, and '{0}' has no value "
          "where it is 0.",
          "Test {2} against 0, too."},
         {"unchecked",
          "Tangent of a right angle possible: nothing checks {2}, and '{0}' has no value where it is 0.",
          "Test {2} against 0 first."}},
    .bad = {{"fanuc", R"nc(
O9704(CHAMFER, Z DEPTH)
#31=90.
G90 G0 X[#26*TAN[#31]]
M99
)nc"},
            {"fanuc", R"nc(
O9704(CHAMFER, A ANGLE, Z DEPTH)
#31=#26*TAN[90-#1]
G90 G0 X#31
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9704(CHAMFER, A ANGLE, Z DEPTH)
IF[#1LE0]THEN#3000=1(A MUST BE MORE THAN 0)
#31=#26*TAN[90-#1]
G90 G0 X[#31+TAN[45]]
M99
)nc"}},
    .exemptions = {{&queries::exemptions::compared_before,
                    "compared-before",
                    "The program compares the argument before: its author has thought of other values.",
                    {"fanuc", R"nc(
O9704(BEVEL, A Z)
IF[#1EQ45]GOTO1
G91 G1 X[#26*TAN[90-#1]] F100.
N1 M99
)nc"}}},
    .alarms = {{"SINUMERIK", "14051", "arithmetic error", false}},
    .sources = {"CNCWIKI-MACB"},
    .check = &check,
};

namespace {

bool is_right_angle(const dataflow::Application& application) {
    const auto angle = application.right.constant();
    return application.operation == Operation::tangent && angle &&
           std::holds_alternative<semantics::DomainError>(
               semantics::compute(Operation::tangent, std::array{*angle}));
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const dataflow::Application& application : analysis.facts().all<dataflow::Application>()) {
        if (!is_right_angle(application) ||
            queries::may_be_left_out(program, analysis.facts(), application.effect, application.expression))
            continue;
        const Span span = program.expressions[application.expression].span;
        Finding& finding = reporter.report({analysis, application}, span, "right-angle",
                                           {quoted(program, span), number_word(application.right.low)});
        trace(finding, analysis, application.node, "the angle is a right one");
    }
    report_risks(analysis, Operation::tangent, reporter);
}

} // namespace
} // namespace maclint::rules
