//! MAC117: brackets that do not pair.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule bracket_mismatch{
    .code = "MAC117",
    .name = "bracket-mismatch",
    .aliases = "DIN324",
    .summary = "The brackets of an expression do not pair",
    .why = "The control refuses the block, and where it guesses another grouping than the author"
           " the result is another number.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .yields_to = "MAC122",
    .messages = {{"plain", "Brackets that do not pair: at '{0}', {1}. The control stops here."}},
    .bad = {{"fanuc", R"nc(
O9117(DEPTH)
#100=[#101+2*[#102-1]
M30
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 #l1=5
N20 G0 X(#l1+2*(3-1) Z2
N30 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9117(DEPTH)
#100=[#101+2]*[#102-1]
M30
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 #l1=5
N20 G0 X(#l1+2)*(3-1) Z2
N30 M30
END
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "114", "FORMAT ERROR IN MACRO"},
               {"FANUC 30i/0i-D", "1131", "MISSING OPEN BRACKET", true, "opening-bracket"},
               {"FANUC 30i/0i-D", "1132", "MISSING CLOSE BRACKET", true, "closing-bracket"},
               {"NCT", "3064", "BAD MACRO STATEMENT"},
               {"SINUMERIK", "12080", "syntax error at the text shown", false}},
    .sources = {"GH-ALM", "NCT-188"},
    .check = SyntaxErrorKind::bracket_mismatch,
};

} // namespace maclint::rules
