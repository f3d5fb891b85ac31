//! MAC580: a code that another one must follow, or must not.
#include "analyzer/queries/words/next_block.hpp"
#include "rules/words/row_of_block.hpp"
#include "rules/words/word_list.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace maclint::rules {

namespace {
void check(const RowOfBlock& block, Reporter& reporter);
}

extern const Rule blocks_out_of_order{
    .code = "MAC580",
    .name = "blocks-out-of-order",
    .summary = "After a code stands another block than the one that it wants",
    .why = "A code that only prepares the next block acts on whatever stands there: on the wrong move, or on "
           "none.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"order", "Block after {0} holds no {1}: {2}.", "Write the block with {1} after it."},
                 {"follows", "Code {1} in the block after {0}: {2}.",
                  "Write what belongs between {0} and {1}, or change their order."}},
    .bad = {{"dinplus", R"nc(
%TULO.NC
MACHINING
N1 G0 X80 Z5
N2 G41
N3 G2 X60 Z-5 R5
N4 G40
N5 G0 X80
END
)nc"}},
    .good = {{"dinplus", R"nc(
%TULO.NC
MACHINING
N1 G0 X80 Z5
N2 G41
N3 G1 X60 Z-5
N4 G40
N5 G0 X80
END
)nc"}},
    .sources = {"SEED-003:12717", "T: further rows name theirs"},
    .check = RowCheck{.says = RowStatement::precedes, .check = &check},
};

namespace {

/// The first code of the block, where the row says that none like them may follow; nothing: one may.
const Word* code_that_must_not_follow(const RowOfBlock& block, const std::vector<Word>& next) {
    const Word* first = nullptr;
    for (const Word& word : next) {
        if (word.address != std::string_view(&block.of_code.letter, 1)) continue;
        if (!has_word(block.row().words, RowOfBlock::code_of(word))) return nullptr;
        if (first == nullptr) first = &word;
    }
    return first;
}

void check(const RowOfBlock& block, Reporter& reporter) {
    const WordRow& row = block.row();
    const auto next = queries::next_block_with(block.block, block.of_code.letter);
    if (!next) return;
    if (row.others.empty()) {
        if (const Word* code = code_that_must_not_follow(block, *next))
            block.report(reporter, *code, "follows",
                         {block.text_of(block.code), block.text_of(*code), std::string(row.effect)});
        return;
    }
    if (queries::holds_code(*next, row.others)) return;
    block.report(reporter, block.code, "order",
                 {block.text_of(block.code), either_of(row.others), std::string(row.effect)});
}

} // namespace
} // namespace maclint::rules
