//! MAC703: a function is given what it has no result for.
#include "analyzer/dataflow/facts/application.hpp"
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
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

extern const Rule domain_error{
    .code = "MAC703",
    .name = "domain-error",
    .aliases = "DIN328",
    .summary = "Root of a negative number, arc sine or cosine outside of -1 to 1, logarithm of 0 or less",
    .why =
        "A FANUC control stops with an alarm, with the tool where it happens to be. The root of a "
        "difference of two arguments is one that the wrong radius or width of a call makes negative. It is "
        "an error where no value is good, a warning where a call shows it, or the program checks other "
        "arguments and not these; else a note.",
    .severity = Severity::error,
    .severity_elsewhere = {{"dinplus", Severity::warning}},
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::Application, dataflow::Comparison, dataflow::Condition, dataflow::Read,
                             dataflow::Store>(),
    .data_flow = true,
    .messages =
        {{"outside", "No result: '{0}' is given {1}, for which it has none.", "Correct the operand."},
         {"passed", "No result: '{0}' has none for what the call on line {3} of {4} passes.",
          "Pass other values, or check them first."},
         {"left-out", "No result: '{0}' has none, as the call on line {3} of {4} leaves out {2}.",
          "Pass it, or check it first."},
         {"lets-zero-pass",
          "No result in some cases: '{3}' lets {2} pass when it is 0, and '{0}' stops the control then.",
          "Test it against 0, too."},
         {"asked-vacancy",
          "No result in some cases: the program asks whether {2} was passed, not how large it is, and '{0}' "
          "stops the control for some values.",
          "Refuse these values first: the value in the brackets must fit the function."},
         {"others-checked",
          "No result in some cases: the program checks {3}, not {2}, and '{0}' stops it for some values.",
          "Refuse these values first: the value in the brackets must fit the function."},
         {"unchecked",
          "No result in some cases: nothing checks {2}, and '{0}' stops the control for some values of it.",
          "Refuse these values first: the value in the brackets must fit the function."}},
    .bad = {{"fanuc", R"nc(
O9703(CHORD, R RADIUS)
#31=-4.
G90 G1 X[SQRT[#31]] F100.
M99
)nc"},
            {"fanuc", R"nc(
O9703(CHORD, R RADIUS, W DISTANCE)
#30=SQRT[#18*#18-#23*#23]
G90 G0 X#30
M99
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 #l1=SQRT(0-4)
N40 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9703(CHORD, R RADIUS, W DISTANCE)
IF[ABS[#23]GT#18]THEN#3000=1(W TOO LARGE)
#30=SQRT[#18*#18-#23*#23]
#31=SQRT[#24*#24+#25*#25]
G90 G0 X[#30+#31]
M99
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 #l1=SQRT(4)
N40 M30
END
)nc"}},
    .exemptions = {{&queries::exemptions::compared_before,
                    "compared-before",
                    "The program compares the argument before: its author has thought of other values.",
                    {"fanuc", R"nc(
O9703(CAP, R W)
IF[#23GT50.]GOTO1
#1=SQRT[#18*#18-#23*#23]
G90 G0 Z#1
N1 M99
)nc"}}},
    .alarms = {{"FANUC 16i/18i/21i", "119", "ILLEGAL ARGUMENT", false},
               {"FANUC 30i/0i-D", "119", "ARGUMENT VALUE OUT OF RANGE", false},
               {"SINUMERIK", "14051", "arithmetic error", false}},
    .sources = {"GH-ALM"},
    .check = &check,
};

namespace {

constexpr std::array operations{Operation::square_root, Operation::arc_sine, Operation::arc_cosine,
                                Operation::logarithm};

/// Whether no value that the operand can have is one that the function takes.
bool is_outside(const dataflow::Application& application) {
    const dataflow::Value& operand = application.right;
    switch (application.operation) {
    case Operation::square_root: return operand.high < 0;
    case Operation::arc_sine:
    case Operation::arc_cosine: return operand.high < -1 || operand.low > 1;
    case Operation::logarithm: return operand.high <= 0;
    default: return false;
    }
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const dataflow::Application& application : analysis.facts().all<dataflow::Application>()) {
        if (!is_outside(application) ||
            queries::may_be_left_out(program, analysis.facts(), application.effect, application.expression))
            continue;
        const Span span = program.expressions[application.expression].span;
        const auto number = application.right.constant();
        const std::string given =
            number ? number_word(*number)
                   : quoted(program, program.expressions[application.right_expression].span);
        Finding& finding =
            reporter.report({analysis, application}, span, "outside", {quoted(program, span), given});
        trace(finding, analysis, application.node, "it is calculated here");
    }
    for (const Operation operation : operations) report_risks(analysis, operation, reporter);
}

} // namespace
} // namespace maclint::rules
