//! MAC225: an argument that nothing checks picks an offset.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/queries/values/offsets.hpp"
#include "rules/operand_risk.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule unchecked_offset_number{
    .code = "MAC225",
    .name = "indirect-unchecked",
    .summary =
        "An argument picks an offset by its number, and nothing checks whether it was passed and which "
        "offset it is",
    .why =
        "Where the argument is missing, it counts as 0, and the program works with the offset before the "
        "first one, or with a value that is none: a wrong radius or zero point, or an alarm. It is a warning "
        "where a call leaves the argument out, or the program checks its other arguments, else a note.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::vacancy},
    .yields_to = "MAC210",
    .facts = dataflow::facts<dataflow::Comparison, dataflow::Read>(),
    .data_flow = true,
    .messages =
        {{"left-out",
          "Offset number missing: '{0}' picks an offset by {1}, which the call on line {2} of {3} leaves "
          "out.",
          "Pass it, or check it first."},
         {"others-checked",
          "Offset number unchecked: the program checks {2}, but not {1}, by which '{0}' picks an offset.",
          "Check it first."},
         {"unchecked", "Offset number unchecked: nothing checks {1}, by which '{0}' picks an offset.",
          "Check it first."}},
    .bad = {{"fanuc", R"nc(
O9225(TOOL RADIUS, D OFFSET, Z DEPTH)
IF[#26EQ#0]THEN#3000=1(Z MISSING)
#30=#[13000+#7]
G90 G1 X#30 Z#26
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9225(TOOL RADIUS, D OFFSET, Z DEPTH)
IF[#26EQ#0]THEN#3000=1(Z MISSING)
IF[#7EQ#0]THEN#3000=2(D MISSING)
#30=#[13000+#7]
G90 G1 X#30 Z#26
M99
)nc"}},
    .sources = {"SEED-002:341"},
    .check = &check,
};

namespace {

void report(const ProgramAnalysis& analysis, const queries::OffsetPick& pick,
            const queries::OperandRisk& risk, Reporter& reporter) {
    const Program& program = analysis.program();
    const Span span = program.expressions[pick.index].span;
    Finding& finding = report_risk(analysis, risk, {analysis, *pick.read}, span,
                                   {quoted(program, span), with_letter(analysis, risk.variable)}, reporter);
    trace(finding, analysis, pick.read->node, "it picks an offset here");
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const auto picks = queries::offset_picks(analysis);
    if (picks.empty()) return;
    const queries::OperandRisks risks(analysis);
    std::vector<Variable> reported;
    for (const queries::OffsetPick& pick : picks) {
        if (std::ranges::find(reported, pick.read->variable) != reported.end()) continue;
        const auto risk = risks.risk_of_argument(*pick.read);
        if (!risk) continue;
        reported.push_back(pick.read->variable);
        report(analysis, pick, *risk, reporter);
    }
}

} // namespace
} // namespace maclint::rules
