//! Few files have settings of their own: each kind of settings is asked once.
#include "cli/engine/row_choice.hpp"

#include "rules/words/row_indexes.hpp"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace maclint::cli {

RowChoice::RowChoice(const Snapshot& snapshot)
    : is_wanted_(all_rule_rows().size()) {
    std::unordered_set<const RuleStates*> seen;
    for (const SnapshotFile& file : snapshot.files) {
        const RuleStates* states = file.settings.rules.get();
        if (!file.input.asked || !seen.insert(states).second) continue;
        for (std::size_t i = 0; i < is_wanted_.size(); ++i)
            if (states->rows()[i].on) is_wanted_[i] = true;
    }
    std::vector<const RuleRow*> wanted;
    std::vector<const RuleRow*> all;
    for (const RuleRow& row : all_rule_rows()) {
        all.push_back(&row);
        if (is_wanted_[row.index]) wanted.push_back(&row);
    }
    wanted_ = std::make_shared<const RowIndexes>(std::move(wanted));
    all_ = std::make_shared<const RowIndexes>(std::move(all));
}

bool RowChoice::wants(const NamedRule& named) const {
    if (named.row != nullptr) return is_wanted_[named.row->index];
    return std::ranges::all_of(rows_of(*named.rule),
                               [&](const RuleRow& row) { return is_wanted_[row.index]; });
}

} // namespace maclint::cli
