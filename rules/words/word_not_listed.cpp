//! MAC581: a word that the manual does not list for a code.
#include "analyzer/program/tables.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/words/row_index.hpp"
#include "rules/words/row_of_block.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <variant>

namespace maclint::rules {

namespace {
void check(const RowOfBlock& block, Reporter& reporter);
}

extern const Rule word_not_listed{
    .code = "MAC581",
    .name = "word-not-listed",
    .aliases = "DIN021",
    .summary = "A word stands beside a code whose words the manual lists, and it is none of them",
    .why = "Where the manual lists all words of a code, another one is a typing error or belongs to another "
           "code: the"
           " control refuses the block, or passes the word over and does without what was meant.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"unlisted", "Word '{0}' beside {1}, which does not take it: {2}.",
                  "Write {3}, or give '{0}' a block of its own."},
                 {"wordless", "Word '{0}' beside {1}, which takes no words: {2}.",
                  "Remove '{0}', or give it a block of its own."}},
    .bad = {{"dinplus", R"nc(
%TULO.NC
MACHINING
N1 G14 Q0 H2
END
)nc"}},
    .good = {{"dinplus", R"nc(
%TULO.NC
MACHINING
N1 G14 Q0 D2
END
)nc"}},
    .sources = {"SEED-003:12287-12301", "T: further rows name theirs"},
    .check = RowCheck{.says = RowStatement::takes_only, .check = &check},
};

namespace {

/// The one code of the block that speaks for all: the first. Of a code that no chapter has nobody knows what
/// it takes.
bool speaks_for_block(const RowOfBlock& block) {
    for (const Word& word : block.block.words) {
        if (&word == &block.code) return true;
        if (has_word("G M", word.address) && block.index.words_of_code(word) != nullptr) return false;
    }
    return true;
}

/// Whether a code only switches how others are read, so that a move of the blocks before may go on beside it.
bool only_switches(const ControlModel& control, const Word& word) {
    if (word.address == "M") return true;
    const auto* code = std::get_if<Literal>(&word.value);
    const auto group = code == nullptr ? std::nullopt : control.group_of('G', code->value);
    if (!group) return false;
    switch (control.groups[*group].role) {
    case ModalRole::feed_mode:
    case ModalRole::speed_mode:
    case ModalRole::plane: return true;
    default: return false;
    }
}

/// Whether a move of the blocks before goes on in the block: its words are then not those of the code.
/// [SEED-003:10297]
bool holds_move_that_goes_on(const RowOfBlock& block) {
    const ControlModel& control = block.block.analysis.control();
    return block.find("X Y Z I K") != nullptr &&
           std::ranges::all_of(block.block.words, [&](const Word& word) {
               return !has_word("G M", word.address) || only_switches(control, word);
           });
}

void check(const RowOfBlock& block, Reporter& reporter) {
    const WordRow& row = block.row();
    if (!speaks_for_block(block) || holds_move_that_goes_on(block)) return;
    for (const Word& word : block.block.words) {
        if (!word.has_value()) continue; // MAC109 speaks of that, or MAC106 of its letter O
        if (has_word(any_code_takes, word.address) || has_word(row.words, word.address) ||
            block.may_belong_to_another(word))
            continue;
        block.report(
            reporter, word, row.words.empty() ? "wordless" : "unlisted",
            {block.text_of(word), block.text_of(block.code), std::string(row.effect), either_of(row.words)});
    }
}

} // namespace
} // namespace maclint::rules
