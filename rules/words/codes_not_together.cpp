//! MAC582: two codes that the control does not take in one block.
#include "rules/words/row_of_block.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <string>
#include <variant>

namespace maclint::rules {

namespace {
void check(const RowOfBlock& block, Reporter& reporter);
}

extern const Rule codes_not_together{
    .code = "MAC582",
    .name = "codes-not-together",
    .summary = "Two codes stand in a block that the control takes one at a time",
    .why =
        "Of two codes that want the block for different things one is not carried out, or the control stops.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"both", "Code {0} beside {1}: {2}.", "Give {0} a block of its own."}},
    .bad = {{"dinplus", R"nc(
%TULO.NC
MACHINING
N1 G41
N2 G1 X60 Z0
N3 G40 G14 Q0
END
)nc"}},
    .good = {{"dinplus", R"nc(
%TULO.NC
MACHINING
N1 G41
N2 G1 X60 Z0
N3 G40
N4 G0 X80
N5 G14 Q0
END
)nc"}},
    .sources = {"SEED-003:12680", "T: further rows name theirs"},
    .check = RowCheck{.says = RowStatement::apart, .check = &check},
};

namespace {

void check(const RowOfBlock& block, Reporter& reporter) {
    const WordRow& row = block.row();
    for (const Word& word : block.block.words) {
        if (&word == &block.code || !std::holds_alternative<Literal>(word.value)) continue;
        if (!has_word(row.others, RowOfBlock::code_of(word))) continue;
        block.report(reporter, block.code, "both",
                     {block.text_of(block.code), block.text_of(word), std::string(row.effect)});
        return;
    }
}

} // namespace
} // namespace maclint::rules
