//! DIN404: WHILE and ENDWHILE do not pair.
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
    .aliases = "",
    .summary = "WHILE without ENDWHILE, or ENDWHILE without WHILE",
    .why = "The control does not find the end of the loop, or comes to one that it never entered, and stops "
           "with an error.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = false,
    .messages = {{"never-closed", "'{0}' has no ENDWHILE. Add it after the last block of the loop."},
                 {"never-opened", "'{0}' ends no loop. Remove it, or add the WHILE."},
                 {"crossed", "'{0}' ends the loop while '{1}' of line {2} is still open. End that first."}},
    .bad = {{"dinplus", "MACHINING\n"
                        "N10 #l1=0\n"
                        "N11 WHILE #l1<5\n"
                        "N12 G0 Xi2\n"
                        "N13 #l1=#l1+1\n"
                        "N14 M30\n"
                        "END\n"},
            {"dinplus", "MACHINING\n"
                        "N10 G0 X100\n"
                        "N11 ENDWHILE\n"
                        "N12 M30\n"
                        "END\n"}},
    .good = {{"dinplus", "MACHINING\n"
                         "N10 #l1=0\n"
                         "N11 WHILE #l1<5\n"
                         "N12 G0 Xi2\n"
                         "N13 #l1=#l1+1\n"
                         "N14 ENDWHILE\n"
                         "N15 M30\n"
                         "END\n"}},
    .alarms = {},
    .sources = {"SEED-003:19774-19775"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const flow::RegionFault& fault : nesting_faults(analysis, RegionKind::while_loop))
        report_nesting_fault(analysis, fault, reporter);
}

} // namespace
} // namespace maclint::rules
