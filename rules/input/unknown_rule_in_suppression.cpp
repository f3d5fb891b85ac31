//! MAC002: a suppression comment names no rule that exists. The command raises it.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule unknown_rule_in_suppression{
    .code = "MAC002",
    .name = "unknown-rule-in-suppression",
    .aliases = "",
    .summary = "A suppression names a rule that does not exist",
    .why = "A mistyped code allows nothing: the finding that it was meant for comes back.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = false,
    .messages = {{"unknown", "There is no rule '{0}'. See 'maclint rules' for the list."},
                 {"similar", "There is no rule '{0}'. Write '{1}' if you mean that one."},
                 {"no-rule", "This comment names no rule. Write '{0}'."},
                 {"no-verb",
                  "'{0}' is nothing that maclint understands here. Write ALLOW, ALLOW-FILE, OFF or ON "
                  "before the rule's code."}},
    .bad = {{"fanuc", "O0002(MISTYPED CODE)\n"
                      "G0 X10. (MACLINT ALLOW MAC004X - HOUSE RULE)\n"
                      "M30\n"},
            {"dinplus", "MACHINING\n"
                        "N10 G14 Q0 [MACLINT ALLOW DIN410X - house rule]\n"
                        "N20 M30\n"
                        "END\n"}},
    .good = {{"fanuc", "O0002(NO ALLOWANCE)\n"
                       "G0 X10.\n"
                       "M30\n"},
             {"dinplus", "MACHINING\n"
                         "N10 G14 Q0\n"
                         "N20 M30\n"
                         "END\n"}},
    .alarms = {},
    .sources = {"maclint's own: suppression comments, docs/use.md"},
    .check = RaisedByCommand{},
};

} // namespace maclint::rules
