//! SIN115: texts that no variable holds.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule text_too_long{
    .code = "SIN115",
    .name = "text-too-long",
    .summary = "A text has more characters than the control takes",
    .why = "The control stops with an alarm at the text.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"cure", "Text too long: '{0}' has more than {1} characters.",
                  "Join it of parts with <<, each in a block of its own, or shorten it."}},
    .bad = {{"sinumerik", R"nc(
MSG("clean the chips from the clamp before the next part, clean the chips from the clamp before the next part, clean the chips from the clamp before the next part, clean the chips from the clamp before the next part, ")
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
MSG("clean the chips from the clamp before the next part")
M30
)nc"}},
    .alarms = {{"SINUMERIK", "12210", "string too long", false}},
    .sources = {"FUND06 p.63"},
    .check = SyntaxErrorKind::text_too_long,
};

} // namespace maclint::rules
