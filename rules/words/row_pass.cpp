//! Finds out which rows hold in a block, and has their rules look at it.
#include "rules/words/row_pass.hpp"

#include "analyzer/workspace/program_analysis.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>

namespace maclint {

RowPass::RowPass(const ProgramAnalysis& analysis, std::span<const Rule* const> rules)
    : analysis_(analysis) {
    for (const Rule* rule : rules)
        if (std::holds_alternative<RowCheck>(rule->check)) reporters_.emplace(rule, Reporter(*rule));
}

void RowPass::look_at(const queries::WordsOfBlock& block, const RowIndex& index) {
    if (index.empty()) return;
    for (const Word& word : block.words)
        for (const RowIndex::Entry& entry : index.rows_at(word)) look_at(block, entry, word);
}

void RowPass::look_at(const queries::WordsOfBlock& block, const RowIndex::Entry& entry, const Word& code) {
    const auto reporter = reporters_.find(entry.rule_row->rule);
    if (reporter == reporters_.end()) return;
    const WordRow& row = *entry.row->row;
    // Words of a block that calls are arguments; of some that may be skipped nobody knows which stand there.
    if ((!row.in_calls && queries::calls(block)) || queries::has_alternatives(block)) return;
    std::get<RowCheck>(reporter->first->check)
        .check({block, *entry.rule_row, *entry.row, code, {}}, reporter->second);
}

std::vector<Finding> RowPass::take() {
    std::vector<Finding> findings;
    for (auto& [rule, reporter] : reporters_)
        std::ranges::move(reporter.take(), std::back_inserter(findings));
    return findings;
}

} // namespace maclint
