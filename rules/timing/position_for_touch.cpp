//! MAC615: where the axis stands behind G31 is taken for where the probe has touched.
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/timing/position_for_touch_finder.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule position_for_touch{
    .code = "MAC615",
    .name = "position-for-touch",
    .summary = "The place where the axis stands behind G31 is kept, or taken from a touch, as if it were one",
    .why =
        "Behind G31 the axis has come to rest some hundredths past the place where the signal came. One "
        "side is measured with that way in it, the other without: the bore or the width is wrong by it, and "
        "so is what is kept of one side.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"stands",
                  "Position for a touch: '{0}' takes where the axis stands behind G31, and '{1}' where the "
                  "signal came; '{2}' takes one from the other.",
                  "Read the position of the signal in both."},
                 {"kept",
                  "Position for a touch: '{0}' keeps where the axis stands behind G31, and '{1}' tells where "
                  "the signal came.",
                  "Keep the position of the signal."}},
    .bad = {{"fanuc", R"nc(
O9615(BORE IN X)
#10=#5041
G90 G31 X[#10-12.] F80.
#12=#5061
IF[ABS[#12-#10+12.]LT.01]GOTO9
G0 X#10
G31 X[#10+12.] F80.
#13=#5041
IF[ABS[#13-#10-12.]LT.01]GOTO9
G0 X#10
#138=#13-#12
M99
N9 #3000=94(NO CONTACT)
)nc"},
            {"fanuc", R"nc(
O9616(FACE IN Z)
#10=#5043
G90 G31 Z#26 F80.
IF[ABS[#5063-#26]LT.01]GOTO9
#500=#5043
G0 Z#10
M99
N9 #3000=94(NO CONTACT)
)nc"}},
    .good = {{"fanuc", R"nc(
O9615(BORE IN X, AND HOW FAR IT RUNS ON)
#10=#5041
G90 G31 X[#10-12.] F80.
#12=#5061
#14=#5041
#139=#12-#14
IF[ABS[#12-#10+12.]LT.01]GOTO9
G0 X#10
G31 X[#10+12.] F80.
#13=#5061
IF[ABS[#13-#10-12.]LT.01]GOTO9
G0 X#10
#138=#13-#12
M99
N9 #3000=94(NO CONTACT)
)nc"},
             {"fanuc", R"nc(
O9616(FACE IN Z, WHERE IT CAME TO REST IN 137)
#10=#5043
G90 G31 Z#26 F80.
IF[ABS[#5063-#26]LT.01]GOTO9
#138=#5063
#137=#5043
G0 Z#10
M99
N9 #3000=94(NO CONTACT)
)nc"}},
    .sources = {"SEED-001:1376", "T"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const PositionForTouch& found : find_positions_for_touches(analysis)) {
        const Span span = program.effects[found.store].span, other = program.effects[found.other].span;
        reporter
            .report({analysis, span}, span, "stands",
                    {quoted(program, span), quoted(program, other),
                     quoted(program, program.expressions[found.difference].span)})
            .related.push_back({analysis.source(), other, "the other touch is read here"});
    }
    for (const PositionKeptForTouch& kept : find_positions_kept_for_touches(analysis)) {
        const Span span = program.effects[kept.store].span, asked = program.expressions[kept.asked].span;
        reporter.report({analysis, span}, span, "kept", {quoted(program, span), quoted(program, asked)})
            .related.push_back({analysis.source(), asked, "where the signal came is asked for here"});
    }
}

} // namespace
} // namespace maclint::rules
