//! Gathers them from the pages of the control.
#include "rules/words/words_of_codes.hpp"

#include "analyzer/program/tables.hpp"
#include "rules/words/code_pages.hpp"
#include "rules/words/row_place.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <variant>

namespace maclint {
namespace {

/// Whether the page is of the control, or of one that may be meant.
bool may_be_of(const CodePage& page, const ControlModel& control) {
    return control.assumed ? page.book->is_of_machine(control) : page.is_of(control);
}

} // namespace

WordsOfCodes::WordsOfCodes(const ControlModel& control, std::string_view section)
    : is_assumed_(control.assumed) {
    for (const CodePage& page : all_code_pages()) {
        if (!may_be_of(page, control)) continue;
        if (section != unknown_section && !stands_in(page.sections(), section)) continue;
        for (const std::string_view code : words_of(page.head->row.code)) {
            auto& words = words_[{code.front(), code_number_of(code)}];
            for (const BookLine& line : page.lines)
                if (line.kind == BookLine::Kind::word && (control.assumed || is_of(line, control)))
                    std::ranges::copy(words_of(line.row.words), std::back_inserter(words));
        }
    }
}

bool WordsOfCodes::know(const Word& code) const {
    const auto* value = std::get_if<Literal>(&code.value);
    return value != nullptr && code.address.size() == 1 &&
           words_.contains({code.address.front(), value->value});
}

bool WordsOfCodes::may_take(const Word& code, std::string_view address) const {
    return !know(code) || may_take(code.address.front(), std::get<Literal>(code.value).value, address);
}

bool WordsOfCodes::may_take(char letter, double code, std::string_view address) const {
    constexpr double first_of_builders = 10; // M functions; most machines share those below
    if (is_assumed_ && letter == 'M' && code >= first_of_builders) return true;
    const auto found = words_.find({letter, code});
    return found == words_.end() || std::ranges::find(found->second, address) != found->second.end();
}

} // namespace maclint
