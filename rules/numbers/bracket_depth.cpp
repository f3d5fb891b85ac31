//! MAC701: more bracket levels than the control has.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule bracket_depth{
    .code = "MAC701",
    .name = "bracket-depth",
    .aliases = "DIN325",
    .summary = "Brackets are nested deeper than the control allows, those of functions included",
    .why = "A Fanuc control stops with an alarm when it reaches the block. The manual of DIN PLUS prints a "
           "limit "
           "of six in unclear words, and not what happens beyond it.",
    .severity = Severity::error,
    .severity_elsewhere = {{"dinplus", Severity::note}},
    .precision = Precision::very_high,
    .messages =
        {{"plain",
          "Brackets nested too deep: '{0}' opens one level more than the manual of the control allows.",
          "Compute a part of the expression in a block before."}},
    .bad = {{"fanuc", R"nc(
O9701(DEEP)
#100=SIN[[[[[[#101]]]]]]
M30
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 INPUT("Radius",#l2)
N20 #l4=(((((((#l2*2)+1)*3)+2)*2)-1)*4)
N30 PRINT("Feed",#l4)
N40 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9701(DEEP)
#100=SIN[[[[#101]]]]
M30
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 INPUT("Radius",#l2)
N20 #l4=(((#l2*2)+1)*3)+2
N30 #l4=((#l4*2)-1)*4
N40 PRINT("Feed",#l4)
N50 M30
END
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "118", "PARENTHESIS NESTING ERROR"},
               {"FANUC 30i/0i-D", "118", "TOO MANY BRACKET NESTING"},
               {"NCT", "3064", "BAD MACRO STATEMENT"}},
    .sources = {"MAN-16C287", "NCT-188", "SEED-003:18887", "GH-ALM"},
    .check = SyntaxErrorKind::bracket_depth,
};

} // namespace maclint::rules
