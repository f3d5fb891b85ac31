//! MAC122: text that cannot be read, where no path leads.
#include "analyzer/queries/paths/unreached_text.hpp"

#include "analyzer/source/encoding.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <string>
#include <utility>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule unreached_text{
    .code = "MAC122",
    .name = "unreached-text",
    .summary = "A block with a slip of the pen stands where no path leads",
    .why = "The control passes it by today. When the jump before it is mended, or the blocks are put back, "
           "an alarm "
           "waits there. Remarks, separators and text behind the end of the program are nobody's loss.",
    .severity = Severity::note,
    .precision = Precision::high,
    .messages = {{"plain", "Block that no path reaches and the control could not read: in '{0}', {1}.",
                  "Correct it, or delete it."},
                 {"passed",
                  "Block that no path reaches and the control could not read: in '{0}', {1}; '{2}' passes it "
                  "by mistake.",
                  "Correct it, and the jump."}},
    .bad = {{"fanuc", R"nc(
O9122(CHECK)
IF[#101GT0]GOTO5
#3000=1(NO LENGTH)
G91 G28 Z[#101+1
N5 G0 Z#101
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9122(CHECK)
IF[#101GT0]GOTO5
#3000=1(NO LENGTH)
---------------
N5 G0 Z#101
M30
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 G0 X100 Z2
N20 M30
N30 THN
END
)nc"}},
    .exemptions =
        {{&queries::exemptions::text_that_is_no_slip,
          "no-slip",
          "What cannot be read is no slip of one letter or figure: it was hardly written to run.",
          {"fanuc", R"nc(
O0122(PLATE)
G90 G0 X0
GOTO4
SEE SHEET[4]
N4 M30
)nc"}},
         {&queries::exemptions::text_left_out,
          "left-out-on-purpose",
          "It stands behind the end of the program, or behind a jump with a remark: somebody has taken it "
          "out of use.",
          {"fanuc", R"nc(
O0122(PLATE)
G90 G0 X0
GOTO4(DELETE TO ENABLE)
G1 Z[#5-1.
N4 M30
)nc"}},
         {&queries::exemptions::text_that_is_prose,
          "prose",
          "The block neither calculates nor gives an address a number: a separator, or words for people.",
          {"fanuc", R"nc(
O9122(BORE, Z)
IF[#26EQ#0]GOTO9
G90 G0 Z#26
M99
N9 #3000=1(NO Z)
GO HOME
)nc"}}},
    .sources = {"SEED-001:642; T: no control reads on after an alarm"},
    .check = &check,
};

namespace {

std::string what_is_wrong(const SyntaxError& error) {
    const std::string subject = to_utf8(error.subject, detect_encoding(error.subject));
    if (error.kind == SyntaxErrorKind::bracket_mismatch) return "at '" + subject + "', " + error.cure;
    if (error.kind == SyntaxErrorKind::missing_value) return "'" + subject + "' has no value";
    return "'" + subject + "' is wrong";
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const queries::UnreachedText& text : queries::unreached_text(analysis)) {
        const SyntaxError& error = *text.error;
        std::vector<std::string> words{quoted(program, text.block), what_is_wrong(error)};
        if (text.lost_jump) words.push_back(quoted(program, program.effects[*text.lost_jump].span));
        Finding& finding = reporter.report({analysis.file(), error.span}, error.span,
                                           text.lost_jump ? "passed" : "plain", std::move(words));
        finding.same_cause = std::to_string(text.region.begin);
        finding.is_silent = !text.is_program_text;
    }
}

} // namespace
} // namespace maclint::rules
