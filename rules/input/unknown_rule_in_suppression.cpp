//! MAC002: a suppression comment names no rule that exists. The command raises it.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule unknown_rule_in_suppression{
    .code = "MAC002",
    .name = "unknown-rule-in-suppression",
    .summary = "A suppression names a rule that does not exist",
    .why = "A mistyped code allows nothing: the finding that it was meant for comes back.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .messages = {{"unknown", "Unknown rule: there is no '{0}'.", "See 'maclint rules' for the list."},
                 {"similar", "Unknown rule: there is no '{0}'.", "Write '{1}' if you mean that one."},
                 {"no-rule", "Comment for maclint that names no rule.", "Write '{0}'."},
                 {"tied", "Comment for maclint that allows nothing: '{0}' is not how it is written.",
                  "Write '{1}' with a blank between."},
                 {"no-verb", "Unknown instruction: '{0}' is nothing that maclint understands here.",
                  "Write ALLOW, ALLOW-FILE, OFF or ON before the rule's code."}},
    .bad = {{"fanuc", R"nc(
O0002(MISTYPED CODE)
G0 X10. (MACLINT ALLOW MAC004X - HOUSE RULE)
M30
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 G14 Q0 [MACLINT ALLOW DIN410X - house rule]
N20 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O0002(NO ALLOWANCE)
G0 X10.
M30
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 G14 Q0
N20 M30
END
)nc"}},
    .sources = {"maclint's own: suppression comments, docs/use.md"},
    .check = RaisedByCommand{},
};

} // namespace maclint::rules
