//! Compiles the rows for a control.
#include "rules/words/row_index.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "rules/words/code_pages.hpp"
#include "rules/words/row_of_block.hpp"
#include "rules/words/row_text.hpp"
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

/// Whether the code says the same wherever it stands.
bool has_one_page(std::string_view language, const RowForCode& row) {
    return pages_of_code(language, code_of(row)).size() == 1;
}

/// `sections`: names with blanks between them; empty: any.
bool stands_in(std::string_view sections, std::string_view section) {
    std::string name(section);
    std::ranges::replace(name, ' ', '_');
    return sections.empty() || has_word(sections, name);
}

/// In either case.
void add_letter(std::string& letters, char letter) {
    letters += {letter, static_cast<char>(letter - 'A' + 'a')};
}

/// By which scanning knows the code.
syntax::CodeSet::Kind kind_of(const syntax::PlainTables* tables, const RowForCode& row) {
    const std::size_t which = row.letter == 'G' ? 0 : 1;
    if (tables == nullptr) return syntax::CodeSet::kind_of(which, static_cast<std::uint64_t>(row.code));
    const syntax::PlainCodes& codes = tables->codes[which];
    const double steps = std::pow(10.0, codes.decimals);
    const auto place = static_cast<std::size_t>(std::llround(row.code * steps));
    return place < codes.rows.size() ? codes.rows[place].kind
                                     : syntax::CodeSet::kind_of(which, static_cast<std::uint64_t>(row.code));
}

bool holds(const RowForCode& code, const ControlModel& control, std::string_view section) {
    const WordTable& table = *code.table;
    const WordRow& row = *code.row;
    if (table.language != control.language || (table.machine && *table.machine != control.machine))
        return false;
    if (!row.controls.empty() && !has_word(row.controls, control.name) &&
        !has_word(row.controls, control.model))
        return false;
    const std::string_view sections = row.sections.empty() ? table.sections : row.sections;
    if (section == unknown_section && !sections.empty())
        return row.says != RowStatement::refused && has_one_page(table.language, code);
    return stands_in(sections, section);
}

/// The number of the code that the word is; -1 where it is none.
std::int64_t code_number(const Word& word) {
    const auto* literal = std::get_if<Literal>(&word.value);
    return literal == nullptr || word.address.size() != 1 ? -1
                                                          : code_number(word.address.front(), literal->value);
}

/// The addresses of the list that scanning tells apart.
syntax::AddressSet surely(const syntax::PlainTables& tables, std::string_view list) {
    syntax::AddressSet set;
    for (std::size_t id = 0; id < tables.names.size(); ++id)
        if (!tables.names[id].empty() && has_word(list, tables.names[id]))
            set.add(static_cast<syntax::AddressId>(id));
    return set;
}

/// And those that have no name, among which one of the list may be that has no number of its own.
syntax::AddressSet maybe(const syntax::PlainTables& tables, std::string_view list) {
    syntax::AddressSet set = surely(tables, list);
    const auto words = words_of(list);
    if (set.size() == static_cast<int>(words.size())) return set;
    for (std::size_t id = 0; id < tables.names.size(); ++id)
        if (tables.names[id].empty()) set.add(static_cast<syntax::AddressId>(id));
    return set;
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
            if (!holds(row, control, section)) continue;
            Entry entry{rule_row, &row, code_number(row.letter, row.code), {}, {}, {}, {}};
            if (tables != nullptr) {
                entry.words = surely(*tables, row.row->words);
                if (row.row->says == RowStatement::takes_only)
                    entry.words.add(surely(*tables, any_code_takes));
                entry.others = surely(*tables, row.row->others);
                entry.maybe_words = maybe(*tables, row.row->words);
                entry.maybe_others = maybe(*tables, row.row->others);
            }
            entries_.push_back(entry);
            const auto kind = kind_of(tables, row);
            codes_.add(kind);
            if (letters_.find(row.letter) == std::string::npos) add_letter(letters_, row.letter);
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

std::string RowIndex::letters_wanted(const Program& program, const PlainRun& run) const {
    if (!run.words.codes.meets(codes_)) return {};
    if (run.beside_codes.count == 0) return letters_;
    std::string letters;
    for (const CodeWords& beside :
         std::span(program.code_words).subspan(run.beside_codes.first, run.beside_codes.count))
        for (const Entry& entry : by_kind_[beside.kind])
            if (letters.find(entry.row->letter) == std::string::npos &&
                can_be_wrong(entry, beside.any, beside.all))
                add_letter(letters, entry.row->letter);
    return letters;
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
