//! MAC718: a condition that always holds or never does.
#include "analyzer/dataflow/conditions.hpp"
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/numbers/deliberate_conditions.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>
#include <optional>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule constant_condition{
    .code = "MAC718",
    .name = "constant-condition",
    .aliases = "DIN405",
    .summary = "A condition is always true or never, because of what the program did before",
    .why = "Blocks run that should have been left out, or never run. Often another variable was "
           "meant, or an earlier test already went away with the case.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .data_flow = true,
    .messages = {{"never", "'{0}' is never true here. Correct the condition, or remove what it guards."},
                 {"always", "'{0}' is always true here. Correct the condition, or remove it."}},
    .bad = {{"fanuc", R"nc(
O9718(LEVELS, K LEVEL)
IF[#6GT5]GOTO1
IF[#6GT10]GOTO2
G90 G0 Z0
M99
N1 G90 G0 Z10.
M99
N2 G90 G0 Z20.
M99
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 INPUT("Diameter",#l1)
N20 IF #l1>50
N30 THEN
N40 #l3=0.4
N50 ELSE
N60 #l3=0.25
N70 IF #l1>80
N80 THEN
N90 #l3=0.5
N100 ENDIF
N110 ENDIF
N120 G95 F#l3
N130 M30
END
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 WHILE 1==1
N20 G0 X10
N30 G0 X20
N40 ENDWHILE
N50 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9718(LEVELS, K LEVEL)
IF[#6GT10]GOTO2
IF[#6GT5]GOTO1
G90 G0 Z0
M99
N1 G90 G0 Z10.
M99
N2 G90 G0 Z20.
M99
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 INPUT("Diameter",#l1)
N20 IF #l1>50
N30 THEN
N40 #l3=0.4
N50 ELSE
N60 #l3=0.25
N70 IF #l1>30
N80 THEN
N90 #l3=0.3
N100 ENDIF
N110 ENDIF
N120 G95 F#l3
N130 M30
END
)nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

bool is_loop(const Program& program, EffectId effect) {
    return std::holds_alternative<RegionMark>(program.effects[effect].what);
}

/// What the condition guards: IF[#1GT#2]THEN#1=#2 makes sure, whether it is needed or not.
bool only_clamps(const ProgramAnalysis& analysis, const dataflow::Condition& condition,
                 const dataflow::ReadSet& reads) {
    const Program& program = analysis.program();
    const auto* guarded = std::get_if<Guarded>(&program.effects[condition.effect].what);
    if (guarded == nullptr) return false;
    return std::ranges::any_of(program.effects_in(guarded->effects), [&](const Effect& effect) {
        const auto* assign = std::get_if<Assign>(&effect.what);
        const auto* variable = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
        return variable != nullptr && std::ranges::find(reads.variables, *variable) != reads.variables.end();
    });
}

struct Sides {
    bool constant = true; ///< all are known numbers
    bool vacant = false;  ///< one has never been set
    bool open = true;     ///< no comparison is decided by itself: #1LT8 OR #1GT6
};

Sides sides_of(const ProgramAnalysis& analysis, const dataflow::Condition& condition) {
    Sides sides;
    for (const auto& comparison : analysis.facts().at<dataflow::Comparison>(condition.effect)) {
        sides.open &= comparison.truth.can_hold && comparison.truth.can_fail;
        for (const dataflow::Value* value : {&comparison.left, &comparison.right}) {
            sides.constant &= value->constant().has_value();
            sides.vacant |= value->vacancy == dataflow::Vacancy::vacant;
        }
    }
    return sides;
}

/// A loop that no variable decides, and that nothing else can end.
bool never_ends(const ProgramAnalysis& analysis, const dataflow::Condition& condition) {
    const Program& program = analysis.program();
    const dataflow::ReadSet reads = dataflow::variables_of(program, condition.expression);
    if (analysis.control().loops_left_by_jump || !reads.closed || !reads.variables.empty()) return false;
    return std::ranges::any_of(analysis.loops(), [&](const dataflow::Loop& loop) {
        return loop.region && analysis.regions().all[*loop.region].open == condition.effect && !loop.can_stop;
    });
}

bool is_defect(const ProgramAnalysis& analysis, const dataflow::Condition& condition,
               const DeliberateConditions& deliberate) {
    const Program& program = analysis.program();
    const bool always = condition.truth.can_hold;
    // Where a jump can leave it, a loop without an exit is MAC319's.
    if (always && is_loop(program, condition.effect)) return never_ends(analysis, condition);
    if (dataflow::tests_any_vacancy(program, condition.expression)) return false; // MAC222's and MAC228's
    const Sides sides = sides_of(analysis, condition);
    const dataflow::ReadSet reads = dataflow::variables_of(program, condition.expression);
    if (sides.open) return true;
    if (sides.constant) return !deliberate.depends_on_settings(reads);
    if (only_clamps(analysis, condition, reads) || deliberate.repeats_another(condition)) return false;
    if (deliberate.reads_setting(reads)) return false;
    // What is left over after all other cases were tested may be tested once more.
    return !always && !sides.vacant;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    if (analysis.regions().balance_unknown) return; // a loop that cannot be read may repeat the block
    std::optional<DeliberateConditions> deliberate; // most programs have no such condition
    for (const dataflow::Condition& condition : analysis.facts().all<dataflow::Condition>()) {
        const dataflow::Truth truth = condition.truth;
        if (truth.can_hold == truth.can_fail) continue;
        if (!deliberate) deliberate.emplace(analysis);
        if (!is_defect(analysis, condition, *deliberate)) continue;
        const Span span = program.expressions[condition.expression].span;
        Finding& finding = reporter.report({analysis, condition}, span, truth.can_hold ? "always" : "never",
                                           {quoted(program, span)});
        trace(finding, analysis, condition.node, truth.can_hold ? "it is always true" : "it is never true");
    }
}

} // namespace
} // namespace maclint::rules
