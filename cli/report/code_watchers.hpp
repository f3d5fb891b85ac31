//! The rules and rows that watch a code, on the controls that have it.
#pragma once

#include "rules/words/code_pages.hpp"
#include "rules/words/rule_row.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli {

/// The controls whose code it is: all of them, or the one that is asked for.
[[nodiscard]] std::vector<const ControlModel*> controls_of(const CodePage& page, const ControlModel* only);
/// Whether the page is one of a section.
[[nodiscard]] bool is_section(const CodePage& page);

/// What a row says of the code of a page.
struct RowOfPage {
    const RuleRow* rule_row;
    std::string says;
};
[[nodiscard]] std::vector<RowOfPage> rows_watching(const CodePage& page, const ControlModel* only);
/// Rules that speak of the code: in their names, "DIN906 g30-left-active", or where they say what they find.
/// Of a section the one on its words.
[[nodiscard]] std::vector<const Rule*> rules_watching(const CodePage& page, const ControlModel* only);

/// "system B or C".
[[nodiscard]] std::string systems_in_words(std::string_view systems);
/// "haas or haas-1999", "system B or C", of a line that holds on some of the page's controls alone.
[[nodiscard]] std::string narrowed_to(const WordRow& row);

} // namespace maclint::cli
