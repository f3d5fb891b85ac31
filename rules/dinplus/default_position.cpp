//! DIN412: DEFAULT that is not the last branch.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <optional>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule default_position{
    .code = "DIN412",
    .name = "default-position",
    .summary = "DEFAULT is not the last branch of a SWITCH, or stands twice",
    .why = "The manual has DEFAULT behind all CASE: what comes of the branches behind it is not said.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"plain", "DEFAULT before other branches: '{0}' on line {1} stands behind it.",
                  "Move DEFAULT to the end."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 SWITCH #g1
N11 DEFAULT
N12 G4 F1
N13 BREAK
N14 CASE 1
N15 G4 F2
N16 BREAK
N17 ENDSWITCH
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 SWITCH #g1
N14 CASE 1
N15 G4 F2
N16 BREAK
N17 DEFAULT
N18 G4 F1
N19 BREAK
N20 ENDSWITCH
N99 M30
END
)nc"}},
    .sources = {"SEED-003:19852"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const flow::Region& region : analysis.regions().all) {
        if (region.region_kind != RegionKind::selection) continue;
        std::optional<EffectId> other; // DEFAULT, as long as no branch has come behind it
        for (const EffectId part : region.parts) {
            const auto& mark = std::get<RegionMark>(program.effects[part].what);
            if (mark.part != RegionMark::Part::middle) continue;
            if (other) {
                const Span next = program.effects[part].span;
                reporter.report({analysis, *other}, program.effects[*other].span, "plain",
                                {quoted(program, next), line_number(analysis.file(), next.begin)});
                break;
            }
            if (!mark.condition) other = part;
        }
    }
}

} // namespace
} // namespace maclint::rules
