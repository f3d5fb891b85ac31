//! MAC516: blocks of data that hold what is none, or do not end.
#include "analyzer/queries/words/enclosed_blocks.hpp"
#include "analyzer/queries/words/next_block.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/words/row_of_block.hpp"
#include "rules/words/row_text.hpp"
#include "rules/words/word_list.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const RowOfBlock& block, Reporter& reporter);
}

extern const Rule data_not_closed{
    .code = "MAC516",
    .name = "data-not-closed",
    .summary = "Blocks of data hold words that are none, or are not ended",
    .why =
        "After G10 L50 or L3 the control takes every block for parameters or tool lives. A move that stands "
        "there, or a G11 that is missing, stops it with an alarm, after half of the data has been written.",
    .severity = Severity::error,
    .precision = Precision::high,
    .messages = {{"foreign", "Word '{0}' in the data of {1}, before {2}: {3}.",
                  "Move it behind {2}, or end the data before it."},
                 {"open", "Data of {1} that no {2} ends: {3}.", "Write {2} after the data."}},
    .bad = {{"fanuc", R"nc(
O9516(DATA)
G90 G54 G0 X0 Y0
G10 L50
N3410 R10
G0 X10.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9516(DATA)
G90 G54 G0 X0 Y0
G10 L50
N3410 R10
G11
G0 X10.
M30
)nc"}},
    .sources = {"GH-ALM", "T: further rows name theirs"},
    .check = RowCheck{.says = RowStatement::until, .check = &check},
};

namespace {

void check(const RowOfBlock& block, Reporter& reporter) {
    const WordRow& row = block.row();
    const Program& program = block.block.analysis.program();
    const std::string until = either_of(row.others);
    bool is_over = false;
    const auto tell = [&](const Word& word, std::string_view id) {
        is_over = true;
        block.report(reporter, word, id,
                     {block.text_of(word), block.text_of(block.code), until, std::string(row.effect)});
    };
    queries::for_each_block_in(program,
                               {block.block.block.span.end, static_cast<Offset>(program.text.size())},
                               [&](const BlockView&, std::span<const Word> words) {
                                   if (is_over) return;
                                   if (queries::holds_code({words.begin(), words.end()}, row.others)) {
                                       is_over = true;
                                       return;
                                   }
                                   for (const Word& word : words)
                                       if (!is_over && !has_word(row.words, word.address))
                                           tell(word, "foreign");
                               });
    if (!is_over) tell(block.code, "open");
}

} // namespace
} // namespace maclint::rules
