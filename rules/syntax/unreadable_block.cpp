//! MAC121: a block that makes no sense to the control.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule unreadable_block{
    .code = "MAC121",
    .name = "unreadable-block",
    .summary = "A block that cannot be read",
    .why = "The control stops with a format alarm in this block. maclint does not guess what was"
           " meant: other rules take it that the block may do anything it names.",
    .severity = Severity::error,
    .precision = Precision::high,
    .messages = {{"cure", "'{0}' cannot be read here: expected {1}. The control stops in this block."},
                 {"plain", "'{0}' cannot be read. The control stops in this block."}},
    .bad = {{"fanuc", R"nc(
O9121(POINT)
G1 X5. Y? F100
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9121(POINT)
G1 X5. Y10. F100
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "114", "FORMAT ERROR IN MACRO"},
               {"FANUC 16i/18i/21i", "004", "ADDRESS NOT FOUND"}},
    .sources = {"CSDN-PS", "GH-ALM"},
    .check = SyntaxErrorKind::unreadable,
};

} // namespace maclint::rules
