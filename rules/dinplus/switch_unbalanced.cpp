//! DIN409: SWITCH and ENDSWITCH do not pair, or a branch stands outside.
#include "analyzer/queries/structure/region_faults.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/region_faults.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule switch_unbalanced{
    .code = "DIN409",
    .name = "switch-unbalanced",
    .summary = "SWITCH without ENDSWITCH, or CASE, DEFAULT, BREAK or ENDSWITCH without SWITCH",
    .why = "The control cannot tell which branch a block belongs to. BREAK ends a branch of SWITCH and "
           "nothing else: it does not leave a loop.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .messages = {{"never-closed", "Missing ENDSWITCH: '{0}' is never closed.",
                  "Add ENDSWITCH after the last branch."},
                 {"never-opened", "ENDSWITCH without SWITCH: '{0}' belongs to none.",
                  "Remove it, or add the SWITCH."},
                 {"crossed", "Crossed blocks: '{0}' ends the branches while '{1}' of line {2} is still open.",
                  "End that first."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 INPUT("Size",#l1)
N11 SWITCH #l1
N12 CASE 1
N13 G0 X20
N14 BREAK
N15 M30
END
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 INPUT("Size",#l1)
N11 CASE 1
N12 G0 X20
N13 BREAK
N14 ENDSWITCH
N15 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 INPUT("Size",#l1)
N11 SWITCH #l1
N12 CASE 1
N13 G0 X20
N14 BREAK
N15 ENDSWITCH
N16 M30
END
)nc"}},
    .sources = {"SEED-003:19850-19853"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const flow::RegionFault& fault : queries::nesting_faults(analysis, RegionKind::selection))
        report_nesting_fault(analysis, fault, reporter);
}

} // namespace
} // namespace maclint::rules
