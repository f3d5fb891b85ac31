//! MAC584: more words of a kind than a code takes.
#include "rules/words/row_of_block.hpp"
#include "rules/words/row_text.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <string>

namespace maclint::rules {

namespace {
void check(const RowOfBlock& block, Reporter& reporter);
}

extern const Rule too_many_words{
    .code = "MAC584",
    .name = "too-many-words",
    .summary = "A block has more words of a kind than its code takes",
    .why = "Chamfer or corner, plane and two axes more: where a block asks for more than the control can do "
           "at once, it stops, or leaves out what stands first.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"too_many", "Too many words beside {0}: {1}, of which it takes {2} at most; {3}.",
                  "Leave {2} of them."}},
    .bad = {{"fanuc", R"nc(
O9584(ARC)
G90 G54 G17 G0 X0 Y0 Z5.
G2 X20. Y0 R10. Z-1. A5. B6. C7. F100.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9584(ARC)
G90 G54 G17 G0 X0 Y0 Z5.
G2 X20. Y0 R10. Z-1. A5. F100.
M30
)nc"}},
    .sources = {"GH-ALM", "T: further rows name theirs"},
    .check = RowCheck{.says = RowStatement::at_most, .check = &check},
};

namespace {

void check(const RowOfBlock& block, Reporter& reporter) {
    const WordRow& row = block.row();
    std::string there;
    int count = 0;
    const Word* last = nullptr;
    for (const Word& word : block.block.words) {
        if (!has_word(row.words, word.address)) continue;
        there.append(there.empty() ? "" : ", ").append(block.text_of(word));
        last = &word;
        ++count;
    }
    if (count <= row.most) return;
    block.report(reporter, *last, "too_many",
                 {block.text_of(block.code), there, std::to_string(static_cast<int>(row.most)),
                  std::string(row.effect)});
}

} // namespace
} // namespace maclint::rules
