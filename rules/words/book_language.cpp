//! Looks addresses up.
#include "rules/words/book_language.hpp"

#include "rules/words/word_list.hpp"

namespace maclint {

std::string foreign_words(std::string_view language, std::string_view words) {
    std::string foreign;
    for (const std::string_view address : words_of(book_language(language).of_codes))
        if (!has_word(words, address)) foreign.append(foreign.empty() ? "" : " ").append(address);
    return foreign;
}

} // namespace maclint
