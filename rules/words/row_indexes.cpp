//! Keeps one index for each control and kind of section.
#include "rules/words/row_indexes.hpp"

#include "analyzer/program/numbered_blocks.hpp"
#include "analyzer/program/tables.hpp"
#include "rules/words/row_place.hpp"

namespace maclint {
namespace {

/// The section's kind; unknown where the program has no section words, or is called: from a contour it
/// describes one, from a machining section it machines.
std::string_view place_of(const Program& program, const Section& section) {
    if (program.control->sections.empty()) return section.kind;
    const SectionKind* kind = kind_of(*program.control, section);
    return kind == nullptr || kind->role == SectionKind::Role::subprogram ? unknown_section : section.kind;
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
