//! MAC578: a code that wants its block for itself.
#include "rules/words/row_of_block.hpp"
#include "rules/words/word_list.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const RowOfBlock& block, Reporter& reporter);
}

extern const Rule code_not_alone{
    .code = "MAC578",
    .name = "code-not-alone",
    .summary = "A code shares its block with words that it does not take",
    .why =
        "Some codes are read before all else and want their block for themselves: what stands beside them is"
        " passed over, or the control stops.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"shared", "Word '{0}' beside {1}, which stands alone in its block: {2}.",
                  "Give '{0}' a block of its own."}},
    .bad = {{"dinplus", R"nc(
%TULO.NC
MACHINING
N1 G41 X50
N2 G1 X60
N3 G40
N4 G0 X80
END
)nc"}},
    .good = {{"dinplus", R"nc(
%TULO.NC
MACHINING
N1 G41
N2 G1 X50
N3 G40
N4 G0 X80
END
)nc"}},
    .sources = {"SEED-003:12716", "T: further rows name theirs"},
    .check = RowCheck{.says = RowStatement::alone, .check = &check},
};

namespace {

void check(const RowOfBlock& block, Reporter& reporter) {
    const WordRow& row = block.row();
    for (const Word& word : block.block.words) {
        if (&word == &block.code || has_word(row.words, word.address)) continue;
        block.report(reporter, word, "shared",
                     {block.text_of(word), block.text_of(block.code), std::string(row.effect)});
        return;
    }
}

} // namespace
} // namespace maclint::rules
