//! Finds out which rows hold in a block, and has their rules look at it.
#include "rules/words/row_pass.hpp"

#include "analyzer/program/tables.hpp"
#include "analyzer/program/word_condition.hpp"
#include "analyzer/queries/modal/modes_at.hpp"
#include "analyzer/queries/words/next_block.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/words/row_switch.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <variant>

namespace maclint {
namespace {

/// Whether nothing is left of the words of a block before: the code's group was surely cancelled.
bool is_first_of_its_kind(const queries::WordsOfBlock& block, const RowForCode& row) {
    const auto group = block.analysis.control().group_of(row.letter, row.code);
    if (!group) return true;
    const auto cancel = block.analysis.control().groups[*group].cancel;
    return cancel && block.modes_at(block.block).before(*group).is_surely_one_of({&*cancel, 1});
}

/// The codes of WordRow::under of which one is surely in force in the block, "G41 or G42"; empty: none is.
std::string in_force(const queries::WordsOfBlock& block, const WordRow& row) {
    const ControlModel& control = block.analysis.control();
    std::map<GroupId, std::vector<double>> codes;
    for (const std::string_view code : words_of(row.under))
        if (const auto group = control.group_of(code.front(), code_number_of(code)))
            codes[*group].push_back(code_number_of(code));
    queries::BlockModes modes = block.modes_at(block.block);
    for (const auto& [group, of_group] : codes) {
        const queries::Modes now = modes.with_words(group);
        if (!now.is_surely_one_of(of_group)) continue;
        if (const auto code = now.sure_code()) return control.spell(group, *code);
        return either_of(row.under);
    }
    return {};
}

/// Whether the blocks around this one are as the row wants them. Where nobody knows what stands there, a row
/// that is for blocks after some code does not hold, others do.
bool holds_between(const queries::WordsOfBlock& block, const WordRow& row) {
    if (!row.unless_next.empty()) {
        const auto next = queries::next_block_with(block, 'G');
        if (next && queries::holds_code(*next, row.unless_next)) return false;
    }
    if (!row.after.empty() || !row.unless_after.empty()) {
        const auto before = queries::last_block_with(block, 'G');
        if (!row.after.empty() && (!before || !queries::holds_code(*before, row.after))) return false;
        if (!row.unless_after.empty() && before && queries::holds_code(*before, row.unless_after))
            return false;
    }
    return row.unless_later.empty() || !queries::comes_later(block, row.unless_later);
}

/// Whether the row's code, which a shop could make a call of its own, is one of the named control's.
bool is_builtin(const queries::WordsOfBlock& block, const RowForCode& row) {
    const ControlModel& control = block.analysis.control();
    return !control.assumed && row.letter == 'G' && control.first_free_code != 0 &&
           row.code >= control.first_free_code;
}

} // namespace

RowPass::RowPass(std::span<const Rule* const> rules) {
    for (const Rule* rule : rules)
        if (std::holds_alternative<RowCheck>(rule->check)) reporters_.emplace(rule, Reporter(*rule));
}

void RowPass::look_at(const queries::WordsOfBlock& block, const RowIndex& index) {
    // A block of a person's or a post processor's has some ten words; rows ask each word for all others.
    constexpr std::size_t most_words = 500;
    if (index.empty() || block.words.size() > most_words) return;
    for (const Word& word : block.words)
        for (const auto entries : {index.rows_at(word), index.rows_at_address(word)})
            for (const RowIndex::Entry& entry : entries) look_at(block, index, entry, word);
}

void RowPass::look_at(const queries::WordsOfBlock& block, const RowIndex& index, const RowIndex::Entry& entry,
                      const Word& code) {
    const auto reporter = reporters_.find(entry.rule_row->rule);
    if (reporter == reporters_.end()) return;
    const WordRow& row = *entry.row->row;
    // Words of a block that calls are arguments; of some that may be skipped nobody knows which stand there.
    if ((!row.in_calls && queries::calls(block) && !is_builtin(block, *entry.row)) ||
        queries::has_alternatives(block))
        return;
    if (!block.analysis.file().syntax_errors_in(code.span).empty()) return; // that is told: GO5 for G05
    if (row.kept && !is_first_of_its_kind(block, *entry.row)) return;
    if (fits_beside(block.words, code, row.when) != Fits::yes || !holds_between(block, row)) return;
    std::string under = row.under.empty() ? std::string() : in_force(block, row);
    if (under.empty() && !row.under.empty()) return;
    const auto switched = switched_as(block, row);
    if (!switched) return;
    std::get<RowCheck>(reporter->first->check)
        .check({block, index, *entry.rule_row, *entry.row, code, std::move(under), nullptr, *switched},
               reporter->second);
}

bool RowPass::look_at_arc(const queries::WordsOfBlock& block, const RowIndex& index, GroupId group,
                          const queries::Mode& arc) {
    if (queries::calls(block) || queries::has_alternatives(block)) return false;
    Word code{"G", Literal{*arc.code, false}, false, {}};
    bool holds = false;
    for (const RowIndex::Entry& entry : index.rows_at(code)) {
        const WordRow& row = *entry.row->row;
        const auto reporter = reporters_.find(entry.rule_row->rule);
        if (reporter == reporters_.end() || !goes_on_in_blocks(row) ||
            fits_beside(block.words, code, row.when) != Fits::yes)
            continue;
        const auto axis =
            std::ranges::find(block.words, condition_of(words_of(row.when).front()).address, &Word::address);
        code.span = axis->span;
        std::get<RowCheck>(reporter->first->check)
            .check({block, index, *entry.rule_row, *entry.row, code,
                    block.analysis.control().spell(group, *arc.code), &arc},
                   reporter->second);
        holds = true;
    }
    return holds;
}

std::vector<Finding> RowPass::take() {
    std::vector<Finding> findings;
    for (auto& [rule, reporter] : reporters_)
        std::ranges::move(reporter.take(), std::back_inserter(findings));
    return findings;
}

} // namespace maclint
