//! DIN507: RETURN in the main program.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/rule.hpp"

#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule return_in_main{
    .code = "DIN507",
    .name = "return-in-main",
    .summary = "RETURN stands in a program that an operator starts",
    .why = "RETURN ends a subprogram: in a main program nobody has called it, and the manual does not "
           "say where it leads.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"plain", "RETURN in a main program: nothing has called it.",
                  "Write M30, or move the blocks into a SUBPROGRAM."}},
    .bad = {{"dinplus", R"nc(
%shaft.nc
MACHINING
N10 T1
N11 G0 X60 Z2
RETURN
END
)nc"}},
    .good = {{"dinplus", R"nc(
%shaft.nc
MACHINING
N10 T1
N11 G0 X60 Z2
N12 M30
END
)nc"}},
    .sources = {"SEED-003:2949", "SEED-003:19944"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    if (program.started != Program::Started::by_hand) return;
    for (Id effect = 0; effect < program.effects.size(); ++effect)
        if (std::holds_alternative<Return>(program.effects[effect].what))
            reporter.report({analysis, effect}, program.effects[effect].span, "plain", {});
}

} // namespace
} // namespace maclint::rules
