//! SIN112: a label or a skip mark in the block of a loop or branch.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule label_at_structure{
    .code = "SIN112",
    .name = "label-or-skip-at-control-structure",
    .summary = "A label or a skip mark stands in a block that opens or closes a loop or a branch",
    .why = "Such blocks can be neither skipped nor jumped to: the control stops with an alarm.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"plain", "Label or skip mark at a loop or branch: '{0}' may not stand in such a block.",
                  "Give it a block of its own before this one."}},
    .bad = {{"sinumerik", R"nc(
DEF INT ROW
ROWS: FOR ROW=1 TO 4
G0 X=ROW*10
ENDFOR
R1=R1+1
IF R1<3 GOTOB ROWS
M30
)nc"},
            {"sinumerik", R"nc(
/IF R1==1
G0 X10
ENDIF
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
DEF INT ROW
ROWS:
FOR ROW=1 TO 4
G0 X=ROW*10
ENDFOR
R1=R1+1
IF R1<3 GOTOB ROWS
M30
)nc"}},
    .alarms = {{"SINUMERIK", "12630", "skip mark or label in a block with a control structure", false}},
    .sources = {"JP11 p.107"},
    .check = SyntaxErrorKind::head_at_structure,
};

} // namespace maclint::rules
