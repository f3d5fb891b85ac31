//! MAC121: a block that makes no sense to the control.
#include "analyzer/program/model.hpp"
#include "rules/rule.hpp"
#include "rules/syntax_errors.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule unreadable_block{
    .code = "MAC121",
    .name = "unreadable-block",
    .summary = "A block that cannot be read",
    .why = "The control stops with a format alarm in this block. maclint does not guess what was"
           " meant: other rules take it that the block may do anything it names. Remarks after '//' or ';'"
           " are the habit of some controls: one warning a file names them all.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .yields_to = "MAC122",
    .messages =
        {{"cure", "Unreadable text '{0}': expected {1}. The control stops in this block."},
         {"plain", "Unreadable text '{0}': the control stops in this block."},
         {"remark", "Remark without brackets: after {1}, the control runs '{0}' as a block.",
          "Put it in ( ), or name the program's control (--dialect, or \"files\" in the configuration)."},
         {"sign", "Wide character '{0}' in code: the control does not know it, and stops in this block.",
          "Write '{1}'."},
         {"point", "Variable number with a decimal point: '{0}'. No manual says that the control takes it.",
          "Write '{1}'."},
         {"before return", "Condition before M99: the control stops at '{0}'.", "Put IF before it."},
         {"before return elsewhere", "Condition before M99: the assumed control stops at '{0}'.",
          "If the program runs on {2}, name that (--control)."},
         {"fraction", "Variable number with a decimal point: '{0}', as Haas has them.",
          "Choose that control (--control haas) if the program runs there."}},
    .bad = {{"fanuc", R"nc(
O9121(POINT)
G1 X5. Y? F100
M30
)nc"},
            {"fanuc", R"nc(
O9121(REMARKS)
// first side, clamp at the rear
G0 X5. ; over the bore
M30
)nc"},
            {"fanuc", R"nc(
O9121(DOOR OPEN)
IF[#30003.036EQ1]GOTO2
#504.=1
N2 M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9121(POINT)
G1 X5. Y10. F100
G0 X#504 ; (OVER THE BORE)
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "003", "TOO MANY DIGITS", true, "digits"},
               {"FANUC 16i/18i/21i", "004", "ADDRESS NOT FOUND", true, "no-address"},
               {"FANUC 16i/18i/21i", "006", "ILLEGAL USE OF NEGATIVE SIGN", true, "two-signs"},
               {"FANUC 16i/18i/21i", "007", "ILLEGAL USE OF DECIMAL POINT", true, "two-points"},
               {"FANUC 16i/18i/21i", "009", "ILLEGAL ADDRESS INPUT", true, "character"},
               {"FANUC 16i/18i/21i", "114", "FORMAT ERROR IN MACRO", true,
                "expression no-equals no-comma argument"},
               {"FANUC 16i/18i/21i", "125", "FORMAT ERROR IN MACRO", true, "statement if-form while-form"},
               {"FANUC 30i/0i-D", "006", "ILLEGAL USE OF MINUS SIGN", true, "two-signs"},
               {"FANUC 30i/0i-D", "007", "ILLEGAL USE OF DECIMAL POINT", true, "two-points"},
               {"FANUC 30i/0i-D", "009", "IMPROPER NC-ADDRESS", true, "character"},
               {"FANUC 30i/0i-D", "125", "MACRO STATEMENT FORMAT ERROR", true, "statement"},
               {"FANUC 30i/0i-D", "1013", "ILLEGAL POS. OF PROGRAM NO.", true, "number-misplaced"},
               {"FANUC 30i/0i-D", "1014", "ILLEGAL FORMAT OF PROGRAM NO.", true,
                "no-program-number no-sequence-number"},
               {"FANUC 30i/0i-D", "1097", "TOO LONG VARIABLE NAME", true, "long-variable-name"},
               {"FANUC 30i/0i-D", "1099", "ILLEGAL SUFFIX [ ]", true, "suffix"},
               {"FANUC 30i/0i-D", "1120", "ILLEGAL ARGUMENT FORMAT", true, "argument"},
               {"FANUC 30i/0i-D", "1125", "ILLEGAL EXPRESSION FORMAT", true, "expression"},
               {"FANUC 30i/0i-D", "1133", "MISSING '='", true, "no-equals"},
               {"FANUC 30i/0i-D", "1134", "MISSING ','", true, "no-comma"},
               {"FANUC 30i/0i-D", "1137", "IF STATEMENT FORMAT ERROR", true, "if-form"},
               {"FANUC 30i/0i-D", "1138", "WHILE STATEMENT FORMAT ERROR", true, "while-form"},
               {"NCT", "3064", "BAD MACRO STATEMENT", true,
                "expression no-equals statement if-form while-form"},
               {"SINUMERIK", "12080", "syntax error at the text shown", false},
               {"SINUMERIK", "12110", "syntax of the block cannot be interpreted", false}},
    .sources = {"CSDN-PS", "GH-ALM"},
    .check = &check,
};

namespace {

void report(const ProgramFile& file, SyntaxErrorKind kind, std::string_view message, Severity severity,
            Reporter& reporter) {
    SyntaxCauses causes(file);
    for (const SyntaxError& error : file.syntax_errors) {
        if (error.kind != kind) continue;
        Finding& finding =
            reporter.report({file, error.span}, error.span, message, {error.subject, error.cure});
        finding.severity = severity;
        finding.same_cause = causes.of(error);
    }
}

void check(const ProgramFile& file, Reporter& reporter) {
    report_syntax_error(file, SyntaxErrorKind::unreadable, reporter);
    report_syntax_error(file, SyntaxErrorKind::condition_before_return, reporter,
                        {.without = "before return", .elsewhere = "before return elsewhere"});
    report(file, SyntaxErrorKind::wide_sign, "sign", Severity::error, reporter);
    report(file, SyntaxErrorKind::nested_comment, "cure", Severity::error, reporter);
    report(file, SyntaxErrorKind::bare_remark, "remark", Severity::warning, reporter);
    report(file, SyntaxErrorKind::point_in_variable_number, "point", Severity::warning, reporter);
    report(file, SyntaxErrorKind::fraction_in_variable_number, "fraction", Severity::error, reporter);
}

} // namespace
} // namespace maclint::rules
