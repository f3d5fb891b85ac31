//! Writes the rows of addresses.
#include "rules/words/address_book.hpp"

#include "rules/words/word_list.hpp"

#include <algorithm>
#include <array>

namespace maclint {
namespace address_books {

extern const AddressBook fanuc;
extern const AddressBook fanuc_mill;

} // namespace address_books

std::span<const AddressBook* const> all_address_books() {
    static constexpr std::array list = {&address_books::fanuc, &address_books::fanuc_mill};
    return list;
}

namespace {

WordRow row_of(const AddressLine& line, TableText address, RowStatement says,
               std::span<const RowAlarm> alarms) {
    WordRow row{.says = says,
                .code = "*",
                .words = address,
                .controls = line.controls,
                .systems = line.systems,
                .means = line.means,
                .effect = "the control stops",
                .severity = line.severity,
                .source = line.source};
    std::ranges::copy(alarms, row.alarms.begin());
    return row;
}

/// Rows from `first` on once more for a control that nobody has named, where they warn.
void add_milder(std::vector<WordRow>& rows, std::size_t first, TableText assumed) {
    for (std::size_t i = first, end = rows.size(); i < end; ++i) {
        rows.push_back(rows[i]);
        rows.back().controls = assumed;
        rows.back().severity = Severity::warning;
    }
}

} // namespace

TableText meaning_of_address(std::string_view language, std::string_view address) {
    for (const AddressBook* book : all_address_books())
        for (const AddressLine& line : book->lines)
            if (book->language == language && has_word(line.addresses, address)) return line.means;
    return {};
}

std::vector<WordRow> rows_of(const AddressBook& book, std::deque<std::string>& texts) {
    std::vector<WordRow> rows;
    for (const AddressLine& line : book.lines)
        for (const std::string_view word : words_of(line.addresses)) {
            const TableText address = texts.emplace_back(word);
            const std::size_t first = rows.size();
            if (line.whole) rows.push_back(row_of(line, address, RowStatement::whole, book.point));
            if (line.positive) {
                rows.push_back(row_of(line, address, RowStatement::values, book.minus));
                rows.back().least = 0;
            }
            if (line.most_digits != 0) {
                rows.push_back(row_of(line, address, RowStatement::digits, book.digits));
                rows.back().most = line.most_digits;
            }
            if (line.severity == Severity::error && !book.assumed.empty())
                add_milder(rows, first, book.assumed);
        }
    return rows;
}

} // namespace maclint
