//! DIN401: IF and ENDIF do not pair.
#include "analyzer/queries/region_faults.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/region_faults.hpp"
#include "rules/rule.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule if_unbalanced{
    .code = "DIN401",
    .name = "if-unbalanced",
    .summary = "IF without ENDIF, or ELSE or ENDIF without IF",
    .why = "The control does not find the end of the branch: it reports an error, or leaves out blocks that "
           "were to run in any case.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .messages = {{"never-closed", "Missing ENDIF: '{0}' is never closed.",
                  "Add ENDIF after the last block of the branch."},
                 {"never-opened", "ENDIF without IF: '{0}' belongs to none.", "Remove it, or add the IF."},
                 {"crossed", "Crossed blocks: '{0}' ends the branch while '{1}' of line {2} is still open.",
                  "End that first."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 INPUT("Diameter",#l1)
N11 IF #l1>60
N12 THEN
N13 G0 X100 Z2
N14 M30
END
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 G0 X100 Z2
N11 ENDIF
N12 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 INPUT("Diameter",#l1)
N11 IF #l1>60
N12 THEN
N13 G0 X100 Z2
N14 ENDIF
N15 M30
END
)nc"}},
    .sources = {"SEED-003:19643-19646"},
    .check = &check,
};

namespace {

/// An IF that lacks its THEN, too, is reported by the rule for that.
bool lacks_then(const ProgramAnalysis& analysis, Span choice) {
    return std::ranges::any_of(analysis.file().syntax_errors, [&](const SyntaxError& syntax_error) {
        return syntax_error.kind == SyntaxErrorKind::then_missing && syntax_error.span.begin < choice.end &&
               choice.begin < syntax_error.span.end;
    });
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const flow::RegionFault& fault : queries::nesting_faults(analysis, RegionKind::choice))
        if (!lacks_then(analysis, analysis.program().effects[fault.effect].span))
            report_nesting_fault(analysis, fault, reporter);
}

} // namespace
} // namespace maclint::rules
