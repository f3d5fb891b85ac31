//! Looks the words of jumps up in the tables of the control.
#include "rules/flow/other_direction.hpp"

#include "analyzer/program/tables.hpp"
#include "rules/fixes.hpp"

#include <algorithm>
#include <string>

namespace maclint::rules {
namespace {

char in_capital(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

} // namespace

void offer_other_direction(Finding& finding, const ProgramAnalysis& analysis, Span jump) {
    const auto& words = analysis.control().jump_words;
    const std::string_view written = analysis.program().slice(jump);
    for (const JumpWord& from : words) {
        if (!std::ranges::equal(written.substr(0, from.word.size()), from.word, {}, in_capital)) continue;
        const auto other =
            std::ranges::find_if(words, [&](const JumpWord& to) { return to.search != from.search; });
        if (other == words.end()) return;
        const Span word{jump.begin, jump.begin + static_cast<Offset>(from.word.size())};
        offer_text(finding, Applicability::unsafe, word, std::string(other->word));
        return;
    }
}

} // namespace maclint::rules
