//! DIN401: IF and ENDIF do not pair.
#include "analyzer/queries/structure/region_faults.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/region_faults.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <vector>

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
    .needs = {Capability::block_if},
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

/// Where a THEN is missing, in text order: one place in a block.
std::vector<Span> places_without_then(const ProgramAnalysis& analysis) {
    std::vector<Span> places;
    for (const SyntaxError& error : analysis.file().syntax_errors_in(analysis.program().span))
        if (error.kind == SyntaxErrorKind::then_missing) places.push_back(error.span);
    return places;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const auto faults = queries::nesting_faults(analysis, RegionKind::choice);
    if (faults.empty()) return;
    const auto without_then = places_without_then(analysis);
    for (const flow::RegionFault& fault : faults) {
        const Span choice = analysis.program().effects[fault.effect].span;
        // An IF that lacks its THEN, too, is reported by the rule for that.
        const auto place = std::ranges::upper_bound(without_then, choice.begin, {}, &Span::end);
        if (place == without_then.end() || place->begin >= choice.end)
            report_nesting_fault(analysis, fault, reporter);
    }
}

} // namespace
} // namespace maclint::rules
