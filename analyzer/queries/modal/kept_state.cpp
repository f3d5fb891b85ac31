//! Looks at assignments of modal states, and at the words that are given what they store.
#include "analyzer/queries/modal/kept_state.hpp"

#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/modal_parts.hpp"
#include "analyzer/queries/modal/own_settings.hpp"
#include "analyzer/queries/values/copies.hpp"

#include <algorithm>

namespace maclint::queries {
namespace {

bool is_local(const ProgramAnalysis& analysis, Variable variable) {
    return analysis.control().spaces[variable.space].scope == Scope::frame;
}

class Saves {
  public:
    explicit Saves(const ProgramAnalysis& analysis)
        : analysis_(analysis) {
        for (const dataflow::ModalWrite& write : analysis.facts().all<dataflow::ModalWrite>()) {
            if (const auto group = analysis.data().table().entry_group_of(write.value.symbol))
                put_back_.push_back(*group);
            else if (const auto source = copy_source(analysis, write.expression, write.value);
                     source && source->group)
                put_back_.push_back(*source->group);
        }
    }

    std::vector<KeptState> find() const {
        std::vector<KeptState> kept;
        for (const dataflow::Store& store : analysis_.facts().all<dataflow::Store>()) {
            const auto group = saved_group(analysis_, store);
            if (!group || !can_be_kept(analysis_.control().groups[*group].restore_policy) ||
                std::ranges::find(kept, *group, &KeptState::group) != kept.end() ||
                !last_settings_before(analysis_, store.node, *group).empty())
                continue;
            const bool is_put_back = std::ranges::find(put_back_, *group) != put_back_.end();
            if (is_put_back || is_for_nothing_else(store)) kept.push_back({*group, &store, is_put_back});
        }
        return kept;
    }

  private:
    /// Whether nothing reads the value but words, none of which puts it back.
    [[nodiscard]] bool is_for_nothing_else(const dataflow::Store& store) const {
        if (!is_local(analysis_, store.variable)) return false;
        const auto reads = analysis_.facts().about<dataflow::Read>(store.variable);
        return std::ranges::all_of(reads, [&](const dataflow::Read* read) {
            return read->use == dataflow::Use::word || store_of(analysis_, read->value) != &store;
        });
    }

    const ProgramAnalysis& analysis_;
    std::vector<GroupId> put_back_; ///< groups whose state some word is given
};

} // namespace

bool can_be_kept(RestorePolicy policy) {
    switch (policy) {
    case RestorePolicy::none:
    case RestorePolicy::state:
    case RestorePolicy::value:
    case RestorePolicy::motion:
    case RestorePolicy::offset: return true;
    default: return false;
    }
}

std::vector<KeptState> find_kept_states(const ProgramAnalysis& analysis) { return Saves(analysis).find(); }

} // namespace maclint::queries
