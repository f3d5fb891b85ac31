//! MAC579: a word that a code does not take.
#include "rules/words/row_of_block.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const RowOfBlock& block, Reporter& reporter);
}

extern const Rule word_not_taken{
    .code = "MAC579",
    .name = "word-not-taken",
    .summary = "A code stands beside a word that it does not take",
    .why = "What a code does not take is passed over, or means something of its own: often the word was "
           "meant for"
           " another code, or for the block after.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"foreign", "Word '{0}' beside {1}, which does not take it: {2}.",
                  "Remove '{0}', or give it a block of its own."}},
    .bad = {{"fanuc", R"nc(
O9579(DWELL)
G90 G54 G0 X0 Y0
G4 X2. T5
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9579(DWELL)
G90 G54 G0 X0 Y0
G4 X2.
T5
M30
)nc"}},
    .sources = {"GH-ALM: alarm 245", "T: further rows name theirs"},
    .check = RowCheck{.says = RowStatement::takes_not, .check = &check},
};

namespace {

void check(const RowOfBlock& block, Reporter& reporter) {
    const WordRow& row = block.row();
    const auto words = block.own(row.words);
    if (words.empty()) return;
    block.report(reporter, *words.front(), "foreign",
                 {block.text_of(*words.front()), block.text_of(block.code), std::string(row.effect)});
}

} // namespace
} // namespace maclint::rules
