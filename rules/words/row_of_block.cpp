//! What checks of rows ask of a block.
#include "rules/words/row_of_block.hpp"

#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/modes_at.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/words/book_language.hpp"
#include "rules/words/row_index.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <utility>
#include <variant>

namespace maclint {

const Word* RowOfBlock::find(std::string_view addresses) const {
    const auto found = std::ranges::find_if(
        block.words, [&](const Word& word) { return &word != &code && has_word(addresses, word.address); });
    return found == block.words.end() ? nullptr : &*found;
}

std::vector<const Word*> RowOfBlock::own(std::string_view addresses) const {
    if (is_of_address()) return {&code};
    std::vector<const Word*> found;
    for (const Word& word : block.words)
        if (&word != &code && word.has_value() && has_word(addresses, word.address) &&
            !may_belong_to_another(word))
            found.push_back(&word);
    return found;
}

bool RowOfBlock::is_taken_anywhere(const Word& word) const {
    return has_word(book_language(of_code.table->language).any_code_takes, word.address);
}

bool RowOfBlock::may_belong_to_another(const Word& word) const {
    if (index.words_of_codes().empty()) return queries::may_belong_to_another(block, code, word);
    return std::ranges::any_of(block.words, [&](const Word& other) {
        if (&other == &code || (other.address != "G" && other.address != "M")) return false;
        return is_taken_anywhere(word) || index.words_of_codes().may_take(other, word.address);
    });
}

bool RowOfBlock::may_go_on_to(const Word& word) const {
    if (!book_language(of_code.table->language).codes_go_on) return false;
    const ControlModel& control = block.analysis.control();
    for (const ModalRole role : {ModalRole::motion, ModalRole::cycle}) {
        const auto group = control.group_with(role);
        if (!group) continue;
        queries::BlockModes modes = block.modes_at(block.block);
        const queries::Modes now = modes.with_words(*group);
        const auto code = now.sure_code();
        if (!code || index.words_of_codes().may_take(control.groups[*group].letter, *code, word.address))
            return true;
    }
    return false;
}

std::string RowOfBlock::code_of(const Word& word) {
    const auto* value = std::get_if<Literal>(&word.value);
    if (value == nullptr || !has_word("G M", word.address)) return {};
    return std::string(word.address) + number_word(value->value);
}

std::string RowOfBlock::text_of(const Word& word) const {
    return quoted(block.analysis.program(), word.span);
}

Finding& RowOfBlock::report(Reporter& reporter, const Word& word, std::string_view message_id,
                            std::vector<std::string> arguments) const {
    Finding& finding =
        reporter.report({block.analysis, word.span}, word.span, message_id, std::move(arguments));
    finding.row = &rule_row;
    finding.severity = row().severity;
    const auto alarm = std::ranges::find(row().alarms, block.analysis.control().alarms, &RowAlarm::control);
    finding.alarm = alarm != row().alarms.end() ? alarm->number
                    : row().severity == Severity::error
                        ? reporter.alarm_for(block.analysis.file(), message_id)
                        : std::string_view();
    return finding;
}

} // namespace maclint
