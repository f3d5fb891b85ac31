//! Holds the fields of a row against a control and a section.
#include "rules/words/row_place.hpp"

#include "analyzer/program/tables.hpp"
#include "rules/words/code_pages.hpp"
#include "rules/words/row_text.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <string>

namespace maclint {
namespace {

/// Whether the code says the same wherever it stands.
bool has_one_page(std::string_view language, const RowForCode& row) {
    return pages_of_code(language, code_of(row)).size() == 1;
}

} // namespace

bool stands_in(std::string_view sections, std::string_view section) {
    std::string name(section);
    std::ranges::replace(name, ' ', '_');
    return sections.empty() || has_word(sections, name);
}

bool holds_in(const RowForCode& code, const ControlModel& control, std::string_view section) {
    const WordTable& table = *code.table;
    const WordRow& row = *code.row;
    if (table.language != control.language || (table.machine && *table.machine != control.machine))
        return false;
    if (!row.controls.empty() && !has_word(row.controls, control.name) &&
        !has_word(row.controls, control.model))
        return false;
    const std::string_view sections = row.sections.empty() ? table.sections : row.sections;
    if (section == unknown_section && !sections.empty())
        return row.says != RowStatement::refused && row.unless_later.empty() &&
               has_one_page(table.language, code);
    return stands_in(sections, section);
}

} // namespace maclint
