//! The explicit list of the tables of words; those of chapters of codes are made from them.
#include "rules/words/book_rows.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

namespace maclint {
namespace word_tables {

extern const WordTable fanuc_mill;

} // namespace word_tables

std::span<const WordTable* const> all_word_tables() {
    static const auto list = [] {
        std::vector<const WordTable*> tables = {&word_tables::fanuc_mill};
        std::ranges::copy(tables_of_books(), std::back_inserter(tables));
        return tables;
    }();
    return list;
}

} // namespace maclint
