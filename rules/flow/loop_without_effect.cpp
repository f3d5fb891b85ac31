//! MAC342: a loop that counts, and nobody reads what it has counted.
#include "analyzer/queries/loops/loop_exits.hpp"
#include "rules/flow/loop_without_effect_finder.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <string>
#include <utility>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule loop_without_effect{
    .code = "MAC342",
    .name = "loop-without-effect",
    .summary = "A loop only stores in variables, and nothing reads behind it what it has stored",
    .why = "The loop is run for nothing. Mostly its jump names the wrong block: the blocks that should be "
           "repeated stand outside of it and run once.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .data_flow = true,
    .messages = {{"anew",
                  "Loop without effect: up to '{0}' it only counts {1}, and '{2}' on line {3} replaces that.",
                  "Correct the jump, or remove the loop."},
                 {"plain", "Loop without effect: up to '{0}' it only counts {1}, and nothing reads that.",
                  "Correct the jump, or remove the loop."}},
    .bad = {{"fanuc", R"nc(
O9342(SLOT IN STEPS, Z DEPTH Q STEP)
IF[#26EQ#0]GOTO9
IF[#17EQ#0]GOTO9
#10=0
N1 #10=#10+#17
IF[#10LE ABS[#26]]GOTO1
#10=ABS[#26]
N2 G1 Z-#10 F#9
IF[#10LT ABS[#26]]GOTO1
G0 Z5.
M99
N9 #3000=1(Z OR Q MISSING)
)nc"}},
    .good = {{"fanuc", R"nc(
O9342(SLOT IN STEPS, Z DEPTH Q STEP)
IF[#26EQ#0]GOTO9
IF[#17EQ#0]GOTO9
#10=0
N1 #10=#10+#17
IF[#10LE ABS[#26]]GOTO2
#10=ABS[#26]
N2 G1 Z-#10 F#9
IF[#10LT ABS[#26]]GOTO1
G0 Z5.
M99
N9 #3000=1(Z OR Q MISSING)
)nc"},
             {"fanuc", R"nc(
O9342(THE FIRST FREE PLACE)
#1=501
WHILE[#[#1]NE#0]DO1
#1=#1+1
END1
#[#1]=#24
M99
)nc"}},
    .exemptions = {{&exemptions::counts_to_a_number,
                    "counts-to-a-number",
                    "The loop counts up to a number that stands there: it lets time pass.",
                    {"fanuc", R"nc(
O0342(WAIT)
#1=0
WHILE[#1LT500]DO1
#1=#1+1
END1
G0 Z50.
M30
)nc"}}},
    .sources = {"T"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const LoopWithoutEffect& found : find_loops_without_effect(analysis)) {
        const Span span = queries::span_of_repetition(analysis, *found.loop);
        const std::string head = quoted(program, span), counted = program.spell(found.counted);
        std::vector<std::string> words = {head, counted};
        if (found.anew) {
            const Span anew = program.effects[*found.anew].span;
            words.push_back(quoted(program, anew));
            words.push_back(line_number(analysis.file(), anew.begin));
        }
        Finding& finding =
            reporter.report({analysis, span}, span, found.anew ? "anew" : "plain", std::move(words));
        if (found.anew)
            finding.related.push_back(related_at_effect(analysis, *found.anew, "it is set anew here"));
        trace_round(finding, analysis, *found.loop, "and it has only counted");
    }
}

} // namespace
} // namespace maclint::rules
