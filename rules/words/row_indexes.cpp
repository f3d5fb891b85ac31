//! Keeps one index for each control and kind of section.
#include "rules/words/row_indexes.hpp"

#include "analyzer/program/tables.hpp"
#include "rules/words/row_place.hpp"

#include <algorithm>

namespace maclint {
namespace {

/// The section's kind; where the program has no section words, that of a subprogram if it is one.
std::string_view place_of(const Program& program, const Section& section) {
    const auto& kinds = program.control->sections;
    if (kinds.empty() || std::ranges::find(kinds, section.kind, &SectionKind::name) != kinds.end())
        return section.kind;
    if (program.started != Program::Started::by_call) return unknown_section;
    return std::ranges::find(kinds, SectionKind::Role::subprogram, &SectionKind::role)->name;
}

} // namespace

std::shared_ptr<const RowIndexes> RowIndexes::of_all(std::span<const Rule* const> rules) {
    std::vector<const RuleRow*> rows;
    for (const Rule* rule : rules)
        for (const RuleRow& row : rows_of(*rule)) rows.push_back(&row);
    return std::make_shared<const RowIndexes>(std::move(rows));
}

const RowIndex& RowIndexes::of(const Program& program, const Section& section) const {
    const std::string_view place = place_of(program, section);
    const std::scoped_lock lock(mutex_);
    auto& index = made_[{program.control, program.plain_tables[0], place}];
    if (index == nullptr)
        index = std::make_unique<RowIndex>(*program.control, place, program.plain_tables[0], rows_);
    return *index;
}

} // namespace maclint
