//! DIN411: two branches of a selection for one value.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <map>
#include <optional>
#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule duplicate_case{
    .code = "DIN411",
    .name = "duplicate-case",
    .summary = "Two branches of a SWITCH ask for the same value",
    .why = "The first branch is taken, the second one never: most often another value was meant.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .messages = {{"plain",
                  "Same value twice: '{0}' stands on line {1} already, and this branch is never taken.",
                  "Write the value that was meant, or delete the branch."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 INPUT("Size",#l1)
N11 SWITCH #l1
N12 CASE 1
N13 G0 X20
N14 BREAK
N15 CASE 1
N16 G0 X30
N17 BREAK
N18 ENDSWITCH
N19 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 INPUT("Size",#l1)
N11 SWITCH #l1
N12 CASE 1
N13 G0 X20
N14 BREAK
N15 CASE 2
N16 G0 X30
N17 BREAK
N18 ENDSWITCH
N19 M30
END
)nc"}},
    .sources = {"SEED-003:19851"},
    .check = &check,
};

namespace {

/// The number that the branch asks for; nothing for one that is calculated, and for DEFAULT.
std::optional<double> value_of(const Program& program, const RegionMark& mark) {
    if (mark.part != RegionMark::Part::middle || !mark.condition) return std::nullopt;
    const auto* test = std::get_if<Apply>(&program.expressions[*mark.condition].node);
    if (test == nullptr || test->operation != Operation::equal) return std::nullopt;
    const auto* value = std::get_if<Literal>(&program.expressions[program.operands_of(*test).back()].node);
    return value == nullptr ? std::nullopt : std::optional(value->value);
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const flow::Region& region : analysis.regions().all) {
        if (region.region_kind != RegionKind::selection) continue;
        std::map<double, EffectId> known;
        for (const EffectId part : region.parts) {
            const auto value = value_of(program, std::get<RegionMark>(program.effects[part].what));
            if (!value) continue;
            const auto [first, is_new] = known.emplace(*value, part);
            if (is_new) continue;
            const Span span = program.effects[part].span;
            const Span before = program.effects[first->second].span;
            Finding& finding =
                reporter.report({analysis, part}, span, "plain",
                                {quoted(program, span), line_number(analysis.file(), before.begin)});
            finding.related.push_back(
                related_at_effect(analysis, first->second, "the first one stands here"));
        }
    }
}

} // namespace
} // namespace maclint::rules
