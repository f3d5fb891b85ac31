//! Looks at what a program reads of the variables that it uses for itself.
#include "rules/variables/common_stale_read_checks_finder.hpp"

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/paths/exits.hpp"
#include "analyzer/queries/values/calculations.hpp"
#include "analyzer/queries/values/copies.hpp"
#include "rules/variables/common_stale_read_cases_finder.hpp"

#include <algorithm>
#include <optional>
#include <variant>

namespace maclint::rules {
namespace {

/// The condition of the node that reads it, where one of its sides leads to an alarm.
std::optional<ExpressionId> limit_that_reads(const ProgramAnalysis& analysis, const dataflow::Read& read) {
    const auto& expressions = analysis.program().expressions;
    for (const flow::EdgeId id : analysis.graph().out[read.node]) {
        const flow::Edge& edge = analysis.graph().edges[id];
        if (edge.condition && queries::ends_in_alarm(analysis, read.node, edge.holds) &&
            expressions[*edge.condition].span.contains(expressions[read.expression].span.begin))
            return edge.condition;
    }
    return std::nullopt;
}

/// Whether the test looks at something that decides what is stored: the new value is held against the last.
bool looks_at_source(const ProgramAnalysis& analysis, ExpressionId test, const dataflow::Store& store) {
    const auto tested = dataflow::variables_of(analysis.program(), test).variables;
    const auto sources = dataflow::variables_of(analysis.program(), store.expression).variables;
    return std::ranges::any_of(
        sources, [&](Variable source) { return std::ranges::find(tested, source) != tested.end(); });
}

/// Whether the program calculates the value anew in each run.
bool is_result(const ProgramAnalysis& analysis, const dataflow::Store& store) {
    return std::holds_alternative<Apply>(analysis.program().expressions[store.expression].node) &&
           !store.value.constant() && queries::is_of_own_variables(analysis, store.expression);
}

std::optional<EarlyCheck> check_before(const ProgramAnalysis& analysis, const dataflow::Store& store) {
    std::optional<EarlyCheck> found;
    bool is_used = false;
    for (const dataflow::Read* read : analysis.facts().about<dataflow::Read>(store.variable)) {
        if (queries::is_same_value(read->value, store.value)) {
            is_used = true;
            continue;
        }
        const auto limit = limit_that_reads(analysis, *read);
        if (!limit || !queries::is_same_value(read->value, store.old) ||
            (exemptions::held_against_last_value.is_on() && looks_at_source(analysis, *limit, store)))
            return std::nullopt;
        if (!found) found = EarlyCheck{read, &store};
    }
    return is_used ? found : std::nullopt;
}

} // namespace

std::vector<EarlyCheck> find_early_checks(const ProgramAnalysis& analysis) {
    std::vector<EarlyCheck> found;
    for (const dataflow::Store& store : analysis.facts().all<dataflow::Store>()) {
        if (analysis.control().spaces[store.variable.space].scope != Scope::shared ||
            analysis.facts().about<dataflow::Store>(store.variable).size() > 1 || !is_result(analysis, store))
            continue;
        const auto early = check_before(analysis, store);
        if (early && !callers_set(analysis, store.variable)) found.push_back(*early);
    }
    return found;
}

} // namespace maclint::rules
