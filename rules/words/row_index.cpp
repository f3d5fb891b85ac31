//! Compiles the rows for a control.
#include "rules/words/row_index.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/code_key.hpp"
#include "analyzer/program/tables.hpp"
#include "rules/words/book_language.hpp"
#include "rules/words/code_pages.hpp"
#include "rules/words/row_place.hpp"
#include "rules/words/scanned.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <string>
#include <variant>

namespace maclint {
namespace {

void add_code(std::vector<LetterCodes>& codes, const RowForCode& row) {
    auto place = std::ranges::find(codes, row.letter, &LetterCodes::letter);
    if (place == codes.end()) place = codes.insert(place, {row.letter, {}});
    if (row.code < CodeNumbers::capacity)
        place->codes.add(row.code);
    else
        place->codes.add_beyond();
}

/// The number of the code that the word is; -1 where it is none.
std::int64_t code_number(const Word& word) {
    const auto* literal = std::get_if<Literal>(&word.value);
    return literal == nullptr || word.address.size() != 1 ? -1
                                                          : code_key(word.address.front(), literal->value);
}

/// Of an address of one capital letter, in the table of rows of addresses.
std::size_t place_of(std::string_view address) { return static_cast<std::size_t>(address.front() - 'A'); }

} // namespace

RowIndex::RowIndex(const ControlModel& control, std::string_view section, const syntax::PlainTables* tables,
                   std::span<const RuleRow* const> rows)
    : words_of_codes_(control, section) {
    for (const RuleRow* rule_row : rows) {
        if (!applies_to(*rule_row->rule, control)) continue;
        for (const RowForCode& row : rule_row->rows) {
            if (!holds_in(row, control, section)) continue;
            is_empty_ = false;
            if (row.is_of_address()) {
                of_addresses_[place_of(row.row->words)].push_back({rule_row, &row, -1, {}, {}, {}, {}});
                if (tables != nullptr) addresses_.add(scanned_maybe(*tables, row.row->words));
                continue;
            }
            Entry entry{rule_row, &row, code_key(row.letter, row.code), {}, {}, {}, {}};
            if (tables != nullptr) {
                entry.words = scanned_surely(*tables, row.row->words);
                if (row.row->says == RowStatement::takes_only)
                    entry.words.add(scanned_surely(*tables, book_language(control.language).any_code_takes));
                entry.others = scanned_surely(*tables, row.row->others);
                entry.maybe_words = scanned_maybe(*tables, row.row->words);
                entry.maybe_others = scanned_maybe(*tables, row.row->others);
            }
            entries_.push_back(entry);
            const auto kind = scanned_kind(tables, row);
            codes_.add(kind);
            add_code(all_codes_, row);
            by_kind_[kind].push_back(entry);
        }
    }
    std::ranges::stable_sort(entries_, {}, &Entry::code);
}

std::vector<LetterCodes> RowIndex::codes_wanted(const Program& program, const PlainRun& run,
                                                const std::function<bool(const WordRow&)>& idle) const {
    if (!run.words.codes.meets(codes_)) return {};
    if (run.beside_codes.count == 0) return all_codes_;
    std::vector<LetterCodes> wanted;
    for (const CodeWords& beside :
         std::span(program.code_words).subspan(run.beside_codes.first, run.beside_codes.count))
        for (const Entry& entry : by_kind_[beside.kind])
            if (entry.can_be_wrong(beside.any, beside.all) && !idle(*entry.row->row))
                add_code(wanted, *entry.row);
    return wanted;
}

bool RowIndex::wants_block(const WordSummary& block) const {
    if (block.addresses.meets(addresses_)) return true;
    return block.codes.any_common(codes_, [&](syntax::CodeSet::Kind kind) {
        return std::ranges::any_of(by_kind_[kind], [&](const Entry& entry) {
            return entry.can_be_wrong(block.addresses, block.addresses);
        });
    });
}

std::span<const RowIndex::Entry> RowIndex::rows_at(const Word& word) const {
    const std::int64_t code = code_number(word);
    if (code < 0) return {};
    const auto [first, last] = std::ranges::equal_range(entries_, code, {}, &Entry::code);
    return {first, last};
}

std::span<const RowIndex::Entry> RowIndex::rows_at_address(const Word& word) const {
    if (word.address.size() != 1 || word.address.front() < 'A' || word.address.front() > 'Z') return {};
    return of_addresses_[place_of(word.address)];
}

} // namespace maclint
