//! MAC230: a word of a length gets a ratio.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/numbers/ratio_as_length_finder.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule ratio_as_length{
    .code = "MAC230",
    .name = "angle-used-as-length",
    .summary = "A word of a move gets a sine, cosine or tangent as its length",
    .why = "SIN, COS and TAN give how one side compares with another: without the length that they are "
           "multiplied with the axis moves by less than 1.",
    .severity = Severity::note,
    .precision = Precision::high,
    .needs = {Capability::vacancy},
    .messages = {{"ratio", "Ratio for a length: '{0}' has no side that it is multiplied with.",
                  "Multiply it with the length of the side."}},
    .bad = {{"fanuc", R"nc(
O9230(CIRCLE, A ANGLE R RADIUS)
G91 G17 G2 X[#18*SIN[#1]] Y-[#18*[1-COS[#1]]] I-SIN[#1] J-[#18*COS[#1]] F200.
G90
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9230(CIRCLE, A ANGLE R RADIUS)
G91 G1 X[#18*SIN[#1]] Y[#18*COS[#1]] F200.
G90
M99
)nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const Span word : find_ratios_as_lengths(program))
        reporter.report({analysis, word}, word, "ratio", {quoted(program, word)});
}

} // namespace
} // namespace maclint::rules
