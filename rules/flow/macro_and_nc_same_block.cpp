//! MAC332: a macro statement that does not stand alone.
#include "rules/rule.hpp"
#include "rules/syntax_errors.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule macro_and_nc_same_block{
    .code = "MAC332",
    .name = "macro-and-nc-same-block",
    .summary = "A macro statement shares its block with words or with another statement",
    .why = "The control reads a block as a macro statement or as words. It stops at one that is both."
           " Most often an end of line was lost. Two statements that are no jump: a note on request.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .yields_to = "MAC122",
    .messages = {{"plain", "A macro statement and words in one block: the control stops at '{0}'.",
                  "Give '{0}' a block of its own."},
                 {"elsewhere",
                  "A macro statement and words in one block: the assumed control stops at '{0}'.",
                  "Give '{0}' a block of its own, or name the control that takes it (--control {2})."},
                 {"jump",
                  "Jump beside another macro statement: the control does not take '{0}' behind the first.",
                  "Give '{0}' a block of its own."},
                 {"two",
                  "Two macro statements in one block: '{0}' stands after the first, and no manual says"
                  " that the control takes both.",
                  "Give '{0}' a block of its own.", true}},
    .bad = {{"fanuc", R"nc(
O9332(DEPTH)
G90 #100=5.
G0 X#100
M30
)nc"},
            {"fanuc", R"nc(
O9332(DEPTH)
#100=5. GOTO5
N5 G0 X#100
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9332(DEPTH)
G90
N10 #100=5.
/ #100=6.
G0 X#100
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "127", "NC, MACRO STATEMENT IN SAME BLOCK"},
               {"FANUC 30i/0i-D", "127", "DUPLICATE NC,MACRO STATEMENT"}},
    .sources = {"GH-ALM", "T: two statements are a note"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    report_syntax_error(file, SyntaxErrorKind::words_beside_statement, reporter);
    report_syntax_error(file, SyntaxErrorKind::jump_beside_statement, reporter,
                        {.without = "jump", .severity = Severity::warning});
    report_syntax_error(file, SyntaxErrorKind::statement_beside_statement, reporter, {.unknown = "two"});
}

} // namespace
} // namespace maclint::rules
