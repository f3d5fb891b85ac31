//! MAC118: a word that the control does not know.
#include "analyzer/program/lacking.hpp"
#include "analyzer/program/model.hpp"
#include "rules/rule.hpp"
#include "rules/syntax_errors.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule unknown_keyword{
    .code = "MAC118",
    .name = "unknown-keyword",
    .aliases = "DIN003",
    .summary = "A word that is no keyword of the language",
    .why = "The control stops with an alarm when it reaches the block, which may be hours into "
           "the job.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .yields_to = "MAC122",
    .messages =
        {{"cure", "Unknown word '{0}': the control stops here.", "Write '{1}'."},
         {"plain", "Unknown word '{0}': the control stops here.",
          "If the program is for another control, name that (--dialect, or \"files\" in the configuration)."},
         {"construct", "No block IF on this control, which stops at '{0}'.", "{1}."},
         {"construct elsewhere", "Block IF: the assumed control has none and stops at '{0}'.",
          "If the program runs on {2}, name that (--control), or give the control \"block-if\" in the "
          "configuration."}},
    .bad = {{"fanuc", R"nc(
O9118(DEPTH)
IF[#100LTE5]GOTO10
#100=5
N10 M30
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 INPUT("Diameter",#l1)
N11 IF #l1>60
N12 THN
N13 G0 X100 Z2
N14 ENDIF
N15 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9118(DEPTH)
IF[#100LE5]GOTO10
#100=5
N10 M30
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 INPUT("Diameter",#l1)
N11 IF #l1>60
N12 THEN
N13 G0 X100 Z2
N14 ENDIF
N15 M30
END
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "114", "FORMAT ERROR IN MACRO", true, "operation"},
               {"FANUC 16i/18i/21i", "199", "MACRO WORD UNDEFINED", true, "keyword"},
               {"FANUC 30i/0i-D", "199", "MACRO WORD UNDEFINED", true, "keyword"},
               {"FANUC 30i/0i-D", "1125", "ILLEGAL EXPRESSION FORMAT", true, "operation"},
               {"FANUC 30i/0i-D", "1137", "IF STATEMENT FORMAT ERROR", true, "if-form"},
               {"SINUMERIK", "12080", "syntax error at the text shown", false}},
    .sources = {"IMD-114", "ISORP", "GH-ALM"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    report_syntax_error(file, SyntaxErrorKind::unknown_keyword, reporter);
    report_syntax_error(file, SyntaxErrorKind::missing_construct, reporter,
                        {.with_cure = "construct",
                         .without = "construct",
                         .elsewhere = "construct elsewhere",
                         .is_of_another = [](const SyntaxError& error) { return lacking::is_one(error); }});
}

} // namespace
} // namespace maclint::rules
