//! MAC718: a condition that always holds or never does.
#include "analyzer/dataflow/conditions.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule constant_condition{
    .code = "MAC718",
    .name = "constant-condition",
    .aliases = "DIN405",
    .summary = "A condition always holds or never does, because of what the program did before",
    .why = "Blocks run that should have been left out, or never run. Often another variable was "
           "meant, or an earlier test already went away with the case.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = true,
    .messages = {{"never", "'{0}' never holds here. Correct the condition, or remove what it guards."},
                 {"always", "'{0}' always holds here. Correct the condition, or remove it."}},
    .bad = {{"fanuc", "O9718(LEVELS, K LEVEL)\n"
                      "IF[#6GT5]GOTO1\n"
                      "IF[#6GT10]GOTO2\n"
                      "G90 G0 Z0\n"
                      "M99\n"
                      "N1 G90 G0 Z10.\n"
                      "M99\n"
                      "N2 G90 G0 Z20.\n"
                      "M99\n"}},
    .also = {},
    .good = {{"fanuc", "O9718(LEVELS, K LEVEL)\n"
                       "IF[#6GT10]GOTO2\n"
                       "IF[#6GT5]GOTO1\n"
                       "G90 G0 Z0\n"
                       "M99\n"
                       "N1 G90 G0 Z10.\n"
                       "M99\n"
                       "N2 G90 G0 Z20.\n"
                       "M99\n"}},
    .alarms = {},
    .sources = {"T"},
    .check = &check,
};

namespace {

bool is_loop(const Program& program, EffectId effect) {
    return std::holds_alternative<Structure>(program.effects[effect].what);
}

/// A number that users edit in the program's head.
bool is_setting(const ProgramAnalysis& analysis, Place place) {
    std::size_t count = 0;
    bool literal = true;
    for (const dataflow::Store& store : analysis.facts().stores) {
        if (!(store.place == place)) continue;
        ++count;
        literal &= std::holds_alternative<Literal>(analysis.program().expressions[store.expression].node);
    }
    return count == 1 && literal;
}

bool is_assigned_once(const ProgramAnalysis& analysis, Place place) {
    return std::ranges::count(analysis.facts().stores, place, &dataflow::Store::place) <= 1;
}

bool depends_on_settings(const ProgramAnalysis& analysis, const dataflow::ReadSet& reads) {
    return std::ranges::any_of(reads.places, [&](Place place) { return is_setting(analysis, place); }) ||
           std::ranges::all_of(reads.places, [&](Place place) { return is_assigned_once(analysis, place); });
}

/// What the condition guards: IF[#1GT#2]THEN#1=#2 makes sure, whether it is needed or not.
bool only_clamps(const ProgramAnalysis& analysis, const dataflow::Condition& condition,
                 const dataflow::ReadSet& reads) {
    const Program& program = analysis.program();
    const auto* guarded = std::get_if<Guarded>(&program.effects[condition.effect].what);
    if (guarded == nullptr) return false;
    return std::ranges::any_of(program.effects_in(guarded->effects), [&](const Effect& effect) {
        const auto* assign = std::get_if<Assign>(&effect.what);
        const auto* place = assign == nullptr ? nullptr : std::get_if<Place>(&assign->target);
        return place != nullptr && std::ranges::find(reads.places, *place) != reads.places.end();
    });
}

std::optional<std::int64_t> jump_target(const Program& program, EffectId effect) {
    const auto* guarded = std::get_if<Guarded>(&program.effects[effect].what);
    if (guarded == nullptr || guarded->effects.count != 1) return std::nullopt;
    const auto* jump = std::get_if<Jump>(&program.effects[guarded->effects.first].what);
    return jump == nullptr ? std::nullopt : flow::constant_target(program, jump->target);
}

/// An earlier test sends to the same place: the second is not needed, but does no harm.
bool repeats_another(const ProgramAnalysis& analysis, const dataflow::Condition& condition) {
    const Program& program = analysis.program();
    const auto target = jump_target(program, condition.effect);
    return target && std::ranges::any_of(analysis.facts().conditions, [&](const dataflow::Condition& other) {
               return other.node < condition.node && jump_target(program, other.effect) == target;
           });
}

struct Sides {
    bool constant = true; ///< all are known numbers
    bool vacant = false;  ///< one has never been set
    bool open = true;     ///< no comparison is decided by itself: #1LT8 OR #1GT6
};

Sides sides_of(const ProgramAnalysis& analysis, const dataflow::Condition& condition) {
    Sides sides;
    const auto& comparisons = analysis.facts().comparisons;
    for (auto comparison =
             std::ranges::lower_bound(comparisons, condition.node, {}, &dataflow::Comparison::node);
         comparison != comparisons.end() && comparison->node == condition.node; ++comparison) {
        if (comparison->effect != condition.effect) continue;
        sides.open &= comparison->truth.can_hold && comparison->truth.can_fail;
        for (const dataflow::Value* value : {&comparison->left, &comparison->right}) {
            sides.constant &= value->constant().has_value();
            sides.vacant |= value->vacancy == dataflow::Vacancy::vacant;
        }
    }
    return sides;
}

bool is_defect(const ProgramAnalysis& analysis, const dataflow::Condition& condition) {
    const Program& program = analysis.program();
    const bool always = condition.truth.can_hold;
    if (always && is_loop(program, condition.effect)) return false; // MAC319's, when there is no way out
    if (dataflow::tests_any_vacancy(program, condition.expression)) return false; // MAC222's and MAC228's
    const Sides sides = sides_of(analysis, condition);
    const dataflow::ReadSet reads = dataflow::variables_of(program, condition.expression);
    if (sides.open) return true;
    if (sides.constant) return !depends_on_settings(analysis, reads);
    if (only_clamps(analysis, condition, reads) || repeats_another(analysis, condition)) return false;
    if (std::ranges::any_of(reads.places, [&](Place place) { return is_setting(analysis, place); }))
        return false;
    // What is left over after all other cases were tested may be tested once more.
    return !always && !sides.vacant;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    if (analysis.structures().balance_in_doubt) return; // a loop that cannot be read may repeat the block
    for (const dataflow::Condition& condition : analysis.facts().conditions) {
        const dataflow::Truth truth = condition.truth;
        if (truth.can_hold == truth.can_fail || !is_defect(analysis, condition)) continue;
        const Span span = program.expressions[condition.expression].span;
        Finding& finding = reporter.report(analysis.file(), span, truth.can_hold ? "always" : "never",
                                           {quoted(program, span)});
        trace(finding, analysis, condition.node, truth.can_hold ? "it always holds" : "it never holds");
    }
}

} // namespace
} // namespace maclint::rules
