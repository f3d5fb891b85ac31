//! SIN111: a word of a loop or branch shares its block.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule control_word_not_alone{
    .code = "SIN111",
    .name = "control-word-not-alone",
    .summary = "IF without a jump, ELSE, ENDIF or the words of a loop share a block with other words",
    .why = "A block with such a word holds nothing else: the control cannot read it, and stops with "
           "an alarm.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::paired_words},
    .messages = {{"plain", "Block shared with other words: '{0}' must stand alone.",
                  "Move what stands beside it to a block of its own."}},
    .bad = {{"sinumerik", R"nc(
IF R1>60 G0 X100
ENDIF
M30
)nc"},
            {"sinumerik", R"nc(
LOOP G0 X10
IF R1>5 GOTOF OUT_
R1=R1+1
ENDLOOP
OUT_: M30
)nc"}},
    .good = {{"sinumerik", R"nc(
IF R1>60
G0 X100
ENDIF
M30
)nc"}},
    .sources = {"JP11 p.107"},
    .check = SyntaxErrorKind::not_alone,
};

} // namespace maclint::rules
