//! Keeps one index for each control and kind of section.
#include "rules/words/row_indexes.hpp"

namespace maclint {

std::shared_ptr<const RowIndexes> RowIndexes::of_all(std::span<const Rule* const> rules) {
    std::vector<const RuleRow*> rows;
    for (const Rule* rule : rules)
        for (const RuleRow& row : rows_of(*rule)) rows.push_back(&row);
    return std::make_shared<const RowIndexes>(std::move(rows));
}

const RowIndex& RowIndexes::of(const Program& program, const Section& section) const {
    const std::scoped_lock lock(mutex_);
    auto& index = made_[{program.control, program.plain_tables[0], section.kind}];
    if (index == nullptr)
        index = std::make_unique<RowIndex>(*program.control, section.kind, program.plain_tables[0], rows_);
    return *index;
}

} // namespace maclint
