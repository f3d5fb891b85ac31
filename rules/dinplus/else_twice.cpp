//! DIN423: ELSE twice in one IF.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <optional>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule else_twice{
    .code = "DIN423",
    .name = "else-twice",
    .summary = "An IF has a second ELSE",
    .why = "An IF has two branches: the control stops at the second ELSE with an error.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"plain", "Second ELSE: '{0}' belongs to the IF on line {1}, which has an ELSE on line {2}.",
                  "Write an IF of its own for it."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N1 IF #g1>3
N2 THEN
N3 G4 F1
N4 ELSE
N5 G4 F2
N6 ELSE
N7 G4 F3
N8 ENDIF
N9 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N1 IF #g1>3
N2 THEN
N3 G4 F1
N4 ELSE
N5 G4 F2
N6 ENDIF
N7 M30
END
)nc"}},
    .sources = {"SEED-003:19643-19646"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const flow::Region& region : analysis.regions().all) {
        if (region.region_kind != RegionKind::choice) continue;
        std::optional<EffectId> first;
        for (const EffectId part : region.parts) {
            const auto& mark = std::get<RegionMark>(program.effects[part].what);
            if (mark.part != RegionMark::Part::middle || mark.condition) continue;
            const Span span = program.effects[part].span;
            if (first)
                reporter.report({analysis, part}, span, "plain",
                                {quoted(program, span),
                                 line_number(analysis.file(), program.effects[region.open].span.begin),
                                 line_number(analysis.file(), program.effects[*first].span.begin)});
            else
                first = part;
        }
    }
}

} // namespace
} // namespace maclint::rules
