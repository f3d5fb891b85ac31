//! MAC003: a file that was to be linted holds no NC program. The command raises it while it reads files.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule unreadable_file{
    .code = "MAC003",
    .name = "unreadable-file",
    .summary = "The file holds no NC text, but binary or something else",
    .why =
        "A file that was damaged in transfer, or is no program at all, reaches the control all the same: it "
        "stops at the first character that it does not know, or it reads noise as words.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .messages = {{"not-nc", "Not an NC program but {0}.", "Name another file, or fetch this one again."}},
    .bad = {{"fanuc", "\x89PNG\r\n\x1A\n\x01\x02\x03\x04"}},
    .good = {{"fanuc", R"nc(
O0003(TEXT)
M30
)nc"}},
    .sources = {"maclint's own: the content says what the file is"},
    .check = RaisedByCommand{},
};

} // namespace maclint::rules
