//! What chapters of a language leave unsaid, a row a language.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace maclint {

struct BookLanguage {
    std::string_view language; ///< of the control
    /// Addresses that any block takes, whatever its codes: codes, the tool and what goes with the spindle,
    /// the feed and the axes.
    std::string_view any_code_takes;
    /// Those which only some codes take, in the order in which examples use them; all others are unknown.
    std::string_view of_codes;
    /// A code that stays in force takes its words in later blocks, whatever other codes they hold.
    bool codes_go_on;
};

inline constexpr std::array book_languages = {
    BookLanguage{"dinplus", "G M T N F S", "Q H V W D B E J U R O P C A QK", false},
    BookLanguage{"fanuc", "G M T N F S O H D E X Y Z U V W A B C ,R ,C ,A", "Q K L J I R P", true},
};

[[nodiscard]] constexpr const BookLanguage& book_language(std::string_view language) {
    return *std::ranges::find(book_languages, language, &BookLanguage::language);
}

/// Addresses of the language's codes, of which the code with these words takes none.
[[nodiscard]] std::string foreign_words(std::string_view language, std::string_view words);

} // namespace maclint
