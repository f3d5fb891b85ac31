//! MAC506: the variable that holds the saved state is overwritten before it is put back.
#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/conditions.hpp"
#include "analyzer/queries/copies.hpp"
#include "analyzer/queries/free_variable.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule saved_value_lost{
    .code = "MAC506",
    .name = "saved-value-lost",
    .summary = "The variable that holds a saved modal value is overwritten before the value is "
               "put back",
    .why = "The word that should restore the caller's mode gives the control some other number: "
           "another G code, or one that it does not know.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::ModalWrite, dataflow::Store>(),
    .data_flow = true,
    .messages = {{"overwritten", "Saved value overwritten: '{0}' loses the {1} that {2} keeps for '{3}'.",
                  "Use a variable that is free, such as {4}."},
                 {"none-free", "Saved value overwritten: '{0}' loses the {1} that {2} keeps for '{3}'.",
                  "Use another variable."}},
    .bad = {{"fanuc", R"nc(
O9506(UP, K STEP)
#33=#4003
G91 G0 Z#6
#33=#5003+#6
G#33
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9506(UP, K STEP)
#33=#4003
G91 G0 Z#6
#32=#5003+#6
#100=#32
G#33
M99
)nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

struct Saved {
    queries::CopySource source;
    flow::NodeId node; ///< in which the variable got it
};

/// The modal value that the variable held just before the assignment, when it was a saved one.
std::optional<Saved> saved_before(const ProgramAnalysis& analysis, const dataflow::Store& store) {
    const dataflow::Store* save = queries::store_of(analysis, store.old);
    if (save == nullptr) return std::nullopt;
    const auto source = queries::copy_source(analysis, save->expression, save->value);
    if (!source || !source->group) return std::nullopt;
    return Saved{*source, save->node};
}

/// Whether the word would have put the saved value back.
bool would_restore(const ProgramAnalysis& analysis, const dataflow::ModalWrite& write, GroupId saved) {
    return write.stated ? write.group == saved : analysis.control().groups[saved].letter == 'G';
}

/// A new feed may be computed from the saved one; a new G code may not.
bool is_computed_from(const ProgramAnalysis& analysis, const dataflow::Store& store) {
    const dataflow::ReadSet set = dataflow::variables_of(analysis.program(), store.expression);
    return std::ranges::find(set.variables, store.variable) != set.variables.end();
}

/// The saved value has served already: some word put it back.
bool is_put_back(const ProgramAnalysis& analysis, Variable variable, ExpressionId saved) {
    return std::ranges::any_of(
        analysis.facts().all<dataflow::ModalWrite>(), [&](const dataflow::ModalWrite& write) {
            if (queries::plain_variable(analysis.program(), write.expression) != variable) return false;
            const auto source = queries::copy_source(analysis, write.expression, write.value);
            return source && source->expression == saved;
        });
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const dataflow::ModalWrite& write : analysis.facts().all<dataflow::ModalWrite>()) {
        const auto variable = queries::plain_variable(program, write.expression);
        const dataflow::Store* store = queries::store_of(analysis, write.value);
        if (!variable || store == nullptr || !(store->variable == *variable)) continue;
        const auto source = queries::copy_source(analysis, store->expression, store->value);
        if (source && source->group) continue; // saved anew
        const auto saved = saved_before(analysis, *store);
        if (!saved || !would_restore(analysis, write, *saved->source.group)) continue;
        if (write.stated && is_computed_from(analysis, *store)) continue;
        if (is_put_back(analysis, *variable, saved->source.expression)) continue;
        const Span span = program.effects[store->effect].span;
        const Span word = program.effects[write.effect].span;
        std::vector<std::string> words{quoted(program, span),
                                       std::string(analysis.control().groups[*saved->source.group].name),
                                       program.spell(*variable), quoted(program, word)};
        const auto other = queries::find_free_local(analysis);
        if (other) words.push_back(program.spell(*other));
        Finding& finding = reporter.report({analysis, store->effect}, span,
                                           other ? "overwritten" : "none-free", std::move(words));
        trace(finding, analysis, saved->node,
              {analysis.source(), program.expressions[saved->source.expression].span, "it is saved here"},
              store->node, "and overwritten here");
        finding.related.push_back({analysis.source(), word, "this word should put the saved value back"});
    }
}

} // namespace
} // namespace maclint::rules
