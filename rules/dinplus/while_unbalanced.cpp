//! DIN404: WHILE and ENDWHILE do not pair.
#include "analyzer/queries/structure/region_faults.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/region_faults.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule while_unbalanced{
    .code = "DIN404",
    .name = "while-unbalanced",
    .summary = "WHILE without ENDWHILE, or ENDWHILE without WHILE",
    .why = "The control does not find the end of the loop, or comes to one that it never entered, and stops "
           "with an error.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .messages = {{"never-closed", "Missing ENDWHILE: '{0}' is never closed.",
                  "Add ENDWHILE after the last block of the loop."},
                 {"never-opened", "ENDWHILE without WHILE: '{0}' belongs to none.",
                  "Remove it, or add the WHILE."},
                 {"crossed", "Crossed blocks: '{0}' ends the loop while '{1}' of line {2} is still open.",
                  "End that first."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 #l1=0
N11 WHILE #l1<5
N12 G0 Xi2
N13 #l1=#l1+1
N14 M30
END
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 G0 X100
N11 ENDWHILE
N12 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 #l1=0
N11 WHILE #l1<5
N12 G0 Xi2
N13 #l1=#l1+1
N14 ENDWHILE
N15 M30
END
)nc"}},
    .sources = {"SEED-003:19774-19775"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const flow::RegionFault& fault : queries::nesting_faults(analysis, RegionKind::while_loop))
        report_nesting_fault(analysis, fault, reporter);
}

} // namespace
} // namespace maclint::rules
