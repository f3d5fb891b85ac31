//! DIN015: UNIT and END_OF_UNIT do not pair.
#include "analyzer/queries/structure/region_faults.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/region_faults.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);

constexpr Exemption half_of_a_loop;
} // namespace

extern const Rule unit_unbalanced{
    .code = "DIN015",
    .name = "unit-unbalanced",
    .summary = "UNIT without END_OF_UNIT, a unit inside a unit, or END_OF_UNIT without UNIT",
    .why = "A unit reaches up to its END_OF_UNIT: without it, what follows counts as a part of the unit.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .messages = {{"never-closed", "Missing END_OF_UNIT: '{0}' is never closed.",
                  "Add END_OF_UNIT after the last block of the unit."},
                 {"never-opened", "END_OF_UNIT without UNIT: '{0}' belongs to none.",
                  "Remove it, or add the UNIT."},
                 {"nested", "Units do not nest: '{0}' stands inside the unit of line {1}.",
                  "End that one first."},
                 {"crossed", "Crossed blocks: '{0}' ends the unit while '{1}' of line {2} is still open.",
                  "End that first."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N1 UNIT ID"START"
N3 G26 S3000
N4 UNIT ID"END"
N6 M30
N7 END_OF_UNIT
END
)nc"},
            {"dinplus", R"nc(
MACHINING
N1 G26 S3000
N2 END_OF_UNIT
N3 M30
END
)nc"},
            {"dinplus", R"nc(
MACHINING
N1 UNIT ID"START"
N3 UNIT ID"G26"
N4 G26 S3000
N5 END_OF_UNIT
N6 END_OF_UNIT
N7 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N1 UNIT ID"START"
N3 G26 S3000
N4 END_OF_UNIT
N5 UNIT ID"END"
N7 M30
N8 END_OF_UNIT
END
)nc"},
             {"dinplus", R"nc(
MACHINING
N1 UNIT ID"REPEAT"
N2 #c1=0
N3 WHILE #c1<3
N4 END_OF_UNIT
N5 G0 X10
N6 UNIT ID"REPEAT"
N7 #c1=#c1+1
N8 ENDWHILE
N9 END_OF_UNIT
N10 M30
END
)nc"}},
    .exemptions =
        {{&half_of_a_loop,
          "half-of-a-loop",
          "A unit REPEAT begins a repetition and another one ends it: each holds a half of the loop.",
          {"dinplus", R"nc(
MACHINING
UNIT ID"REPEAT"
N10 WHILE #l1<3
END_OF_UNIT
N20 G0 X10
UNIT ID"REPEAT"
N30 ENDWHILE
END_OF_UNIT
N40 M30
END
)nc"}}},
    .sources = {"SEED-003:2233", "SEED-003:8566-8593"},
    .check = &check,
};

namespace {

/// A unit REPEAT begins a repetition, another one ends it: each may hold a half of the loop. The manual does
/// not show which blocks they stand for.
bool may_hold_half_a_loop(const ProgramAnalysis& analysis, const flow::RegionFault& fault) {
    if (fault.what != flow::Imbalance::crossed) return false;
    const auto& regions = analysis.regions().all;
    const auto unit = std::ranges::find(regions, std::optional(fault.effect), &flow::Region::close);
    if (unit == regions.end()) return false;
    const Program& program = analysis.program();
    return program.slice(program.effects[unit->open].span).find("\"REPEAT\"") != std::string_view::npos;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const flow::RegionFault& fault : queries::nesting_faults(analysis, RegionKind::unit))
        if (!half_of_a_loop.is_on() || !may_hold_half_a_loop(analysis, fault))
            report_nesting_fault(analysis, fault, reporter);
}

} // namespace
} // namespace maclint::rules
