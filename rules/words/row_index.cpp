//! Compiles the rows for a control.
#include "rules/words/row_index.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "rules/words/code_pages.hpp"
#include "rules/words/row_of_block.hpp"
#include "rules/words/row_place.hpp"
#include "rules/words/scanned.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

namespace maclint {
namespace {

/// A letter and a number of at most three decimals as one number; -1 for a number that is no code's.
std::int64_t code_number(char letter, double code) {
    constexpr double decimals = 1000;
    constexpr std::int64_t letters = 256;
    constexpr double beyond_codes = 1e6;
    if (!(code >= 0 && code < beyond_codes)) return -1;
    return std::llround(code * decimals) * letters + static_cast<unsigned char>(letter);
}

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
                                                          : code_number(word.address.front(), literal->value);
}

/// Whether the row can be wrong in one of several blocks with its code: `any` are the addresses of all of
/// them, `all` those that each holds.
bool can_be_wrong(const RowIndex::Entry& entry, syntax::AddressSet any, syntax::AddressSet all) {
    switch (entry.row->row->says) {
    case RowStatement::needs: return !all.meets(entry.words);
    case RowStatement::takes_not:
    case RowStatement::values:
    case RowStatement::whole: return any.meets(entry.maybe_words);
    case RowStatement::excludes: return any.meets(entry.maybe_words) && any.meets(entry.maybe_others);
    case RowStatement::only_with: return any.meets(entry.maybe_words) && !all.meets(entry.others);
    case RowStatement::takes_only: return !any.without(entry.words).empty();
    case RowStatement::alone:
    case RowStatement::apart:
    case RowStatement::precedes:
    case RowStatement::refused: return true;
    }
    return true;
}

} // namespace

RowIndex::RowIndex(const ControlModel& control, std::string_view section, const syntax::PlainTables* tables,
                   std::span<const RuleRow* const> rows) {
    for (const RuleRow* rule_row : rows) {
        if (!applies_to(*rule_row->rule, control)) continue;
        for (const RowForCode& row : rule_row->rows) {
            if (!holds_in(row, control, section)) continue;
            Entry entry{rule_row, &row, code_number(row.letter, row.code), {}, {}, {}, {}};
            if (tables != nullptr) {
                entry.words = scanned_surely(*tables, row.row->words);
                if (row.row->says == RowStatement::takes_only)
                    entry.words.add(scanned_surely(*tables, any_code_takes));
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
    for (const CodePage& page : all_code_pages()) {
        if (page.book->language != control.language) continue;
        if (section != unknown_section && !stands_in(page.sections(), section)) continue;
        for (const std::string_view code : words_of(page.head->row.code)) {
            auto& words = words_of_codes_[code_number(code.front(), code_number_of(code))];
            for (const BookLine& line : page.lines)
                if (line.kind == BookLine::Kind::word) words.push_back(line.row.words);
        }
    }
}

std::vector<LetterCodes> RowIndex::codes_wanted(const Program& program, const PlainRun& run) const {
    if (!run.words.codes.meets(codes_)) return {};
    if (run.beside_codes.count == 0) return all_codes_;
    std::vector<LetterCodes> wanted;
    for (const CodeWords& beside :
         std::span(program.code_words).subspan(run.beside_codes.first, run.beside_codes.count))
        for (const Entry& entry : by_kind_[beside.kind])
            if (can_be_wrong(entry, beside.any, beside.all)) add_code(wanted, *entry.row);
    return wanted;
}

bool RowIndex::wants_block(const WordSummary& block) const {
    return block.codes.any_common(codes_, [&](syntax::CodeSet::Kind kind) {
        return std::ranges::any_of(by_kind_[kind], [&](const Entry& entry) {
            return can_be_wrong(entry, block.addresses, block.addresses);
        });
    });
}

std::span<const RowIndex::Entry> RowIndex::rows_at(const Word& word) const {
    const std::int64_t code = code_number(word);
    if (code < 0) return {};
    const auto [first, last] = std::ranges::equal_range(entries_, code, {}, &Entry::code);
    return {first, last};
}

const std::vector<std::string_view>* RowIndex::words_of_code(const Word& word) const {
    const auto found = words_of_codes_.find(code_number(word));
    return found == words_of_codes_.end() ? nullptr : &found->second;
}

} // namespace maclint
