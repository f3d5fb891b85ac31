//! The sections in which the codes of a language have no place.
#pragma once

#include "rules/words/code_pages.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace maclint {

struct PlacelessCode {
    std::string_view code;
    const CodePage* page; ///< one that it has elsewhere
    std::string sections; ///< of other codes, blanks between them
};

/// In the order of their names; codes that may stand in every section are left out.
[[nodiscard]] std::vector<PlacelessCode> codes_without_place(std::string_view language);

} // namespace maclint
