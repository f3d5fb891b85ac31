//! MAC104: code in small letters.
#include "analyzer/program/model.hpp"
#include "rules/rule.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule lower_case_code{
    .code = "MAC104",
    .name = "lower-case-code",
    .summary = "Words of the program are written in small letters",
    .why =
        "Manuals print addresses and keywords in capitals, and say nothing of small letters: a control may "
        "refuse the block.",
    .severity = Severity::note,
    .precision = Precision::medium,
    .needs = {Capability::sections},
    .on_by_default = false,
    .off_reason = "no document says what a control makes of small letters.",
    .messages = {{"plain", "Small letters: '{0}', the first of the file.", "Write '{1}'."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 g0 x60 z2
N11 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 G0 X60 Z2
N11 M30
END
)nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

/// One for a file: whoever writes so writes all of it so.
void check(const ProgramFile& file, Reporter& reporter) {
    const auto first =
        std::ranges::find(file.syntax_errors, SyntaxErrorKind::small_letters, &SyntaxError::kind);
    if (first == file.syntax_errors.end()) return;
    reporter.report({file, first->span}, first->span, "plain", {first->subject, first->cure});
}

} // namespace
} // namespace maclint::rules
