//! MAC720: an assignment calculates again what its variable holds already.
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/queries/values/calculations.hpp"
#include "analyzer/queries/values/copies.hpp"
#include "rules/fixes.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule redundant_recompute{
    .code = "MAC720",
    .name = "redundant-recompute",
    .summary = "An assignment calculates again what its variable holds already, from operands that nothing "
               "has changed",
    .why = "The block does nothing. Often it was copied, and another variable or another operand was meant.",
    .severity = Severity::note,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::Store>(),
    .data_flow = true,
    .messages = {{"again", "Calculated twice: '{0}' sets {1} to what it is since line {2}.",
                  "Remove the block, or correct the variable that was meant."}},
    .bad = {{"fanuc", R"nc(
O9720(SLOT, X LENGTH D TOOL)
#33=#24-#7
G0 X#33
#33=#24-#7
G0 X-#33
M99
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 INPUT("Length",#l1)
N20 #l2=#l1/2
N30 G0 X46 Z#l2
N40 #l2=#l1/2
N50 G0 X50 Z#l2
N60 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9720(SLOT, X LENGTH D TOOL Y WIDTH)
#33=#24-#7
G0 X#33
#33=#25-#7
G0 Y-#33
M99
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 INPUT("Length",#l1)
N20 #l2=#l1/2
N30 G0 X46 Z#l2
N40 #l2=#l1/3
N50 G0 X50 Z#l2
N60 M30
END
)nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

/// The assignment whose result the variable holds already; nullptr when there is none.
const dataflow::Store* repeated(const ProgramAnalysis& analysis, const dataflow::Store& store) {
    if (!std::holds_alternative<Apply>(analysis.program().expressions[store.expression].node) ||
        !queries::is_same_value(store.value, store.old) ||
        !queries::is_of_own_variables(analysis, store.expression))
        return nullptr;
    const dataflow::Store* before = queries::store_of(analysis, store.old);
    const bool same = before != nullptr && before->effect != store.effect &&
                      before->variable == store.variable &&
                      queries::same_expression(analysis.program(), before->expression, store.expression);
    return same ? before : nullptr;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const dataflow::Store& store : analysis.facts().all<dataflow::Store>()) {
        const dataflow::Store* before = repeated(analysis, store);
        if (before == nullptr) continue;
        const Span span = program.effects[store.effect].span;
        const Span earlier = program.effects[before->effect].span;
        Finding& finding = reporter.report({analysis, store}, span, "again",
                                           {quoted(program, span), with_letter(analysis, store.variable),
                                            line_number(analysis.file(), earlier.begin)});
        offer_removal(finding, Applicability::unsafe, span);
        finding.same_cause = program.name + " " + line_number(analysis.file(), earlier.begin);
        trace(finding, analysis, before->node, {analysis.source(), earlier, "the value is calculated here"},
              store.node, "and again here");
    }
}

} // namespace
} // namespace maclint::rules
