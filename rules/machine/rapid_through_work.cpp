//! MAC555: a rapid move at a depth, through material that is still there.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/machine/rapid_words.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule rapid_through_work{
    .code = "MAC555",
    .name = "rapid-through-work",
    .summary = "A rapid move runs at a depth through material that is still there",
    .why = "At rapid traverse the tool breaks in the work, or tears it out of its clamps.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages =
        {{"cut-later",
          "Rapid move through the work: '{0}' runs at Z{1}, where nothing is cut so deep before, and "
          "crosses what line {2} cuts later.",
          "Write G1, or lift the tool before."},
         {"cut-less-deep",
          "Rapid move through the work: '{0}' runs at Z{1} along what line {2} has cut less deep.",
          "Write G1, or lift the tool before."},
         {"not-lifted",
          "Rapid move through the work: '{0}' runs at Z{1}, to which line {2} cuts; behind all its "
          "other cuts this tool is lifted.",
          "Lift the tool before, or write G1."},
         {"late-lift",
          "Lifted too late: '{0}' moves aside with the tool at Z{1}, and line {2} lifts it behind that.",
          "Lift the tool first."}},
    .bad = {{"fanuc", R"nc(
O9555(OUTLINE)
G21 G17 G90 G54 G0 X-20. Y-20.
G43 H1 Z5.
G1 Z-6. F300.
G0 X0
Y70.
G1 X90. F500.
Y0
X-20.
G0 Z50.
M30
)nc"},
            {"fanuc", R"nc(
O9555(SLOT IN TWO DEPTHS)
G21 G17 G90 G54 G0 X-20. Y20.
G43 H1 Z5.
Z-4.
G1 X100. F300.
G0 Z5.
X-20.
Z-8.
X40.
G1 X100.
G0 Z50.
M30
)nc"},
            {"fanuc", R"nc(
O9555(TWO SLOTS)
G21 G17 G90 G54 G0 X0 Y0
G43 H1 Z2.
G1 Z-6. F120.
X50. F300.
G0 X0 Y40.
Z2.
G1 Z-6. F120.
X50. F300.
G0 Z50.
M30
)nc"},
            {"fanuc", R"nc(
O9555(LETTERS)
G21 G17 G90 G54 G0 X0 Y0
G43 H1 Z1.
G1 Z-0.2 F100.
Y40.
G0 Z1.
X10. Y10.
G1 Z-0.2
Y30.
G0 X20. Y20.
G1 Y30.
G0 Z1.
X30. Y0
G1 Z-0.2
Y40.
G0 Z50.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9555(OUTLINE, AND BACK ON ITS WAY)
G21 G17 G90 G54 G0 X-20. Y-20.
G43 H1 Z5.
G1 Z-6. F300.
X0
Y70.
G0 Y-20.
X-20.
Z-9.
G1 X0
Y70.
G0 Z50.
M30
)nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) { report_rapid_moves(analysis, reporter); }

} // namespace
} // namespace maclint::rules
