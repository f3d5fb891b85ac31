//! Follows what is read back to the assignments that made it.
#include "rules/numbers/constant_condition_settings_finder.hpp"

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/dataflow/domain/state.hpp"
#include "analyzer/queries/values/copies.hpp"
#include "analyzer/queries/values/origins.hpp"

#include <algorithm>
#include <variant>

namespace maclint::rules {
namespace {

constexpr int most_steps = 8; ///< from a setting to what is made of it

} // namespace

Settings::Settings(const ProgramAnalysis& analysis)
    : analysis_(analysis) {
    for (const dataflow::Store& store : analysis.facts().all<dataflow::Store>()) {
        const bool number =
            std::holds_alternative<Literal>(analysis.program().expressions[store.expression].node);
        const auto [known, first] = only_numbers_.try_emplace(dataflow::key_of(store.variable), number);
        if (!first) known->second = known->second && number;
    }
}

bool Settings::is_all_that_is_read(ExpressionId condition, EffectId effect) const {
    return dataflow::variables_of(analysis_.program(), condition).closed &&
           std::ranges::all_of(analysis_.facts().at<dataflow::Read>(effect),
                               [this](const dataflow::Read& read) { return is_setting(read, most_steps); });
}

bool Settings::is_read(EffectId effect) const {
    return std::ranges::any_of(analysis_.facts().at<dataflow::Read>(effect),
                               [this](const dataflow::Read& read) { return is_setting(read, most_steps); });
}

/// A variable that is read as it was when the program began is none.
bool Settings::is_setting(const dataflow::Read& read, int depth) const {
    if (depth == 0) return false;
    if (const dataflow::Store* store = queries::store_of(analysis_, read.value))
        return is_setting(*store, depth);
    if (queries::is_made_by_call(analysis_, read.value.origin)) return read.value.constant().has_value();
    const bool joined =
        analysis_.data().table().symbols[read.value.symbol].kind() == dataflow::Symbol::Kind::joined;
    const auto known = only_numbers_.find(dataflow::key_of(read.variable));
    return joined && known != only_numbers_.end() && known->second;
}

bool Settings::is_setting(const dataflow::Store& store, int depth) const {
    const auto [known, fresh] = known_.try_emplace({store.effect, depth}, false); // stays where it is
    if (fresh) known->second = is_made_of_settings(store, depth);
    return known->second;
}

bool Settings::is_made_of_settings(const dataflow::Store& store, int depth) const {
    if (std::holds_alternative<Literal>(analysis_.program().expressions[store.expression].node)) return true;
    if (store.step || !dataflow::variables_of(analysis_.program(), store.expression).closed)
        return false; // what counts is no setting
    const auto reads = analysis_.facts().at<dataflow::Read>(store.effect);
    return std::ranges::all_of(reads,
                               [&](const dataflow::Read& read) { return is_setting(read, depth - 1); });
}

} // namespace maclint::rules
