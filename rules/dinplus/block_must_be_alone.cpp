//! DIN008: IF, THEN, ELSE or ENDIF shares its block.
#include "rules/rule.hpp"
#include "rules/syntax_errors.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule block_must_be_alone{
    .code = "DIN008",
    .name = "block-must-be-alone",
    .summary = "IF, THEN, ELSE, ENDIF or a section word shares its block with other commands",
    .why = "A block with one of these words may hold nothing else: the control rejects the program, or "
           "leaves out the rest of the block.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .messages = {{"plain", "Block shared with other words: '{0}' must stand alone.",
                  "Move what stands beside it to a block of its own."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 INPUT("Diameter",#l1)
N11 IF #l1>60
N12 THEN G0 X100 Z2
N13 ENDIF
N14 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 INPUT("Diameter",#l1)
N11 IF #l1>60
N12 THEN
N13 G0 X100 Z2
N14 ENDIF
N15 M30
END
)nc"}},
    .sources = {"SEED-003:19668", "SEED-003:2656-2686 (parameters of sections)"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    report_syntax_error(file, SyntaxErrorKind::not_alone, reporter);
}

} // namespace
} // namespace maclint::rules
