//! The explicit list of the tables of words.
#include "rules/words/word_row.hpp"

#include <array>

namespace maclint {
namespace word_tables {

extern const WordTable fanuc_mill;
extern const WordTable dinplus_machining;

} // namespace word_tables

std::span<const WordTable* const> all_word_tables() {
    static constexpr std::array list = {&word_tables::fanuc_mill, &word_tables::dinplus_machining};
    return list;
}

} // namespace maclint
