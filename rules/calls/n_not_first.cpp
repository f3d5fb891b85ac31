//! MAC465: a sequence number behind the words of its block.
#include "analyzer/program/faults.hpp"
#include "rules/rule.hpp"
#include "rules/syntax_errors.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule n_not_first{
    .code = "MAC465",
    .name = "n-not-first",
    .summary = "A sequence number does not stand at the head of its block",
    .why = "Only a skip mark may stand before N. A jump to the number does not find it, and controls stop at "
           "it: most often an end of block was lost.",
    .severity = Severity::error,
    .precision = Precision::high,
    .yields_to = "MAC122",
    .messages = {{"plain", "Sequence number behind words: the control stops at '{0}'.",
                  "Give '{0}' a block of its own, or put it at the head of this one."},
                 {"unknown", "Sequence number behind words: no jump finds '{0}' there.",
                  "Give '{0}' a block of its own, or put it at the head of this one."}},
    .bad = {{"fanuc", R"nc(
O9465(DRILL)
M9 N80
G80
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9465(DRILL)
/N80 M9
G80
M30
)nc"}},
    .alarms = {{"FANUC 30i/0i-D", "1013", "ILLEGAL POS. OF PROGRAM NO."}},
    .sources = {"NCT-173", "NCT-188", "T: the number of the alarm"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    report_syntax_error(file, SyntaxErrorKind::unreadable, reporter,
                        {.faults = {faults::block_number_misplaced}});
}

} // namespace
} // namespace maclint::rules
