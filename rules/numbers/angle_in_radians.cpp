//! MAC707: a conversion between degrees and radians beside a function that counts in degrees.
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "rules/numbers/angle_in_radians_finder.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <set>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule angle_in_radians{
    .code = "MAC707",
    .name = "angle-in-radians",
    .summary =
        "An angle is converted by pi and 180, though SIN, COS, TAN and their inverses count in degrees",
    .why = "The functions of the control take and give degrees. Converted once more the angle is 57 times "
           "too small "
           "or too large, and the tool goes anywhere.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::vacancy},
    .facts = dataflow::facts<dataflow::Read, dataflow::Store>(),
    .messages = {{"argument",
                  "Angle in radians: '{0}' converts the angle of '{1}', and the function takes degrees.",
                  "Leave the factors out."},
                 {"result", "Angle converted twice: '{0}' makes degrees of '{1}', which is in degrees.",
                  "Leave the factors out."},
                 {"passed", "Angle in radians: '{0}' is passed in radians, and {2} takes degrees in '{1}'.",
                  "Leave the factors out."}},
    .bad = {{"fanuc", R"nc(
O9707(BULGE, I J F)
IF[#5LE#4]THEN #3000=7(I TOO BIG)
#29=ASIN[#4/#5]
#29=#29*180./3.14159
G1 Z-[#5*[1-COS[#29]]] F#9
M99
)nc"},
            {"fanuc", R"nc(
O9707(SLOPE, A X)
#30=#1*3.1416/180.
G1 X#24 Y[#24*TAN[#30]] F100.
M99
)nc"},
            {"fanuc", R"nc(
O9707(EDGE, X Y)
#10=ATAN[#25]/[#24]
IF[#10GT180]THEN #10=#10-360
G1 X[#24*COS[#10*57.2958]] F100.
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9707(BULGE, I J F)
IF[#5LE#4]THEN #3000=7(I TOO BIG)
#29=ASIN[#4/#5]
#30=#5*#29*3.14159/180.
G1 Z-[#5*[1-COS[#29]]] F#9
G1 X#30
M99
)nc"}},
    .sources = {"SEED-001:263-268"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    std::set<ExpressionId> said;
    for (const RadianUse& use : find_radians(analysis)) {
        if (!said.insert(use.conversion).second) continue;
        const Span span = program.expressions[use.conversion].span;
        const Program& other = use.called == nullptr ? program : use.called->program();
        const Span angle = other.expressions[use.angle].span;
        Finding& finding = reporter.report({analysis, use.effect, use.conversion}, span,
                                           use.fault == RadianFault::argument ? "argument"
                                           : use.fault == RadianFault::result ? "result"
                                                                              : "passed",
                                           {quoted(program, span), quoted(other, angle), other.name});
        if (use.called != nullptr)
            finding.related.push_back({use.called->source(), angle, "the function takes degrees here"});
    }
}

} // namespace
} // namespace maclint::rules
