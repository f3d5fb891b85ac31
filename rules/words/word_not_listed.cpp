//! MAC581: a word that the manual does not list for a code.
#include "analyzer/dataflow/facts/point_state.hpp"
#include "rules/words/book_language.hpp"
#include "rules/words/row_index.hpp"
#include "rules/words/row_of_block.hpp"
#include "rules/words/word_list.hpp"

#include <string>

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
    .facts = dataflow::facts<dataflow::BeforeNode>(),
    .messages = {{"unlisted", "Word '{0}' beside {1}, which does not take it: {2}.",
                  "Write {3}, or give '{0}' a block of its own."},
                 {"wordless", "Word '{0}' beside {1}, which takes no words: {2}.",
                  "Remove '{0}', or give it a block of its own."}},
    .bad = {{"dinplus", R"nc(
%TULO.NC
MACHINING
N1 G14 Q0 H2
END
)nc"},
            {"fanuc", R"nc(
O9581(PART)
G90 G54 G80 G0 X0 Y0
G81 X10. Y10. Z-5. R2. Q1. F100.
G80
M30
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
        if (has_word("G M", word.address) && block.index.words_of_codes().know(word)) return false;
    }
    return true;
}

/// Whether a move, or an element of a contour, of the blocks before may go on in the block, whatever other
/// code stands there: its words are then not those of the code. [SEED-003:10297, 11073, 12680, 18040]
bool may_hold_move_that_goes_on(const RowOfBlock& block) {
    if (book_language(block.of_code.table->language).codes_go_on) return false; // they are asked one by one
    const Word* axis = block.find("X Y Z I K");
    return axis != nullptr && !has_word(block.row().words, axis->address) &&
           !block.may_belong_to_another(*axis);
}

void check(const RowOfBlock& block, Reporter& reporter) {
    const WordRow& row = block.row();
    if (!speaks_for_block(block) || may_hold_move_that_goes_on(block)) return;
    for (const Word& word : block.block.words) {
        if (!word.has_value()) continue; // MAC109 speaks of that, or MAC106 of its letter O
        if (block.is_taken_anywhere(word) ||
            block.index.words_of_codes().may_take(block.code, word.address) ||
            has_word(row.words, word.address) || block.may_belong_to_another(word) ||
            block.may_go_on_to(word))
            continue;
        block.report(
            reporter, word, row.words.empty() ? "wordless" : "unlisted",
            {block.text_of(word), block.text_of(block.code), std::string(row.effect), either_of(row.words)});
    }
}

} // namespace
} // namespace maclint::rules
