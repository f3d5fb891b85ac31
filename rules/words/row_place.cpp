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

bool is_one_of(const ControlModel& control, std::string_view controls, std::string_view systems) {
    const bool named =
        controls.empty() || has_word(controls, control.name) || has_word(controls, control.model);
    return named && (systems.empty() || control.code_system == 0 ||
                     systems.find(control.code_system) != std::string_view::npos);
}

bool stands_in(std::string_view sections, std::string_view section) {
    std::string name(section);
    std::ranges::replace(name, ' ', '_');
    return sections.empty() || has_word(sections, name);
}

bool is_of(const RowForCode& code, const ControlModel& control) {
    const WordTable& table = *code.table;
    if (table.language != control.language || (table.machine && *table.machine != control.machine))
        return false;
    return is_one_of(control, code.row->controls.empty() ? table.controls : code.row->controls,
                     code.row->systems);
}

bool holds_in(const RowForCode& code, const ControlModel& control, std::string_view section) {
    if (!is_of(code, control)) return false;
    const WordTable& table = *code.table;
    const WordRow& row = *code.row;
    const std::string_view sections = row.sections.empty() ? table.sections : row.sections;
    if (section == unknown_section && !sections.empty())
        return (row.says != RowStatement::refused || !row.while_on.empty() || !row.while_off.empty()) &&
               row.unless_later.empty() && has_one_page(table.language, code);
    return stands_in(sections, section);
}

} // namespace maclint
