//! MAC122: text that cannot be read, where no path leads.
#include "analyzer/queries/unreached_text.hpp"

#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule unreached_text{
    .code = "MAC122",
    .name = "unreached-text",
    .summary = "Text that cannot be read stands where no path leads",
    .why = "The control passes it by and never stops there. It is a remark without its brackets, or blocks"
           " that somebody took out of use: an alarm waits for whoever puts them back.",
    .severity = Severity::note,
    .precision = Precision::very_high,
    .messages = {{"plain", "Unreadable text where no path leads: '{0}' is never run.",
                  "Make it a comment, or delete it."}},
    .bad = {{"fanuc", R"nc(
O9122(CHECK)
IF[#101GT0]GOTO5
#3000=1(NO LENGTH)
---------------
N5 G0 Z#101
M30
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 G0 X100 Z2
N20 M30
N30 THN
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9122(CHECK)
IF[#101GT0]GOTO5
#3000=1(NO LENGTH)
(---------------)
N5 G0 Z#101
M30
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 G0 X100 Z2
N20 M30
N30 [THN]
END
)nc"}},
    .sources = {"SEED-001:642; T: no control reads on after an alarm"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const auto& [error, region] : queries::unreached_text(analysis))
        reporter.report({analysis.file(), error->span}, error->span, "plain", {error->subject}).same_cause =
            std::to_string(region.begin);
}

} // namespace
} // namespace maclint::rules
