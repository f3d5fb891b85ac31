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
    .on_by_default = true,
    .off_reason = "",
    .data_flow = false,
    .messages =
        {{"plain",
          "'{0}' opens one bracket level more than the manual of the control allows. Compute a part of "
          "the expression in a block before."}},
    .bad = {{"fanuc", "O9701(DEEP)\n"
                      "#100=SIN[[[[[[#101]]]]]]\n"
                      "M30\n"},
            {"dinplus", "MACHINING\n"
                        "N10 INPUT(\"Radius\",#l2)\n"
                        "N20 #l4=(((((((#l2*2)+1)*3)+2)*2)-1)*4)\n"
                        "N30 PRINT(\"Feed\",#l4)\n"
                        "N40 M30\n"
                        "END\n"}},
    .good = {{"fanuc", "O9701(DEEP)\n"
                       "#100=SIN[[[[#101]]]]\n"
                       "M30\n"},
             {"dinplus", "MACHINING\n"
                         "N10 INPUT(\"Radius\",#l2)\n"
                         "N20 #l4=(((#l2*2)+1)*3)+2\n"
                         "N30 #l4=((#l4*2)-1)*4\n"
                         "N40 PRINT(\"Feed\",#l4)\n"
                         "N50 M30\n"
                         "END\n"}},
    .alarms = {{"FANUC 16i/18i/21i", "118", "PARENTHESIS NESTING ERROR"},
               {"FANUC 30i/0i-D", "118", "TOO MANY BRACKET NESTING"}},
    .sources = {"MAN-16C287", "NCT-188", "SEED-003:18887"},
    .check = SyntaxErrorKind::bracket_depth,
};

} // namespace maclint::rules
