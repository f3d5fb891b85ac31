//! MAC577: a word that counts only beside another.
#include "rules/words/row_condition.hpp"
#include "rules/words/row_of_block.hpp"
#include "rules/words/row_text.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <string>

namespace maclint::rules {

namespace {
void check(const RowOfBlock& block, Reporter& reporter);
}

extern const Rule word_without_partner{
    .code = "MAC577",
    .name = "word-without-partner",
    .summary = "A word stands without the one that it counts with",
    .why = "A word that only tells more of another one does nothing alone: the control passes it over, and "
           "what was"
           " meant does not happen.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"alone", "Word '{0}' of {1} counts beside {2} only: {3}.", "Write {2}, or remove '{0}'."}},
    .bad = {{"dinplus", R"nc(
%TULO.NC
MACHINING
N1 G41 H1
N2 G1 X50
N3 G40
N4 G0 X80
END
)nc"}},
    .good = {{"dinplus", R"nc(
%TULO.NC
MACHINING
N1 G41 Q1 H1
N2 G1 X50
N3 G40
N4 G0 X80
END
)nc"}},
    .sources = {"SEED-003:12707", "T: further rows name theirs"},
    .check = RowCheck{.says = RowStatement::only_with, .check = &check},
};

namespace {

/// Whether one of the others stands there, with one of its values where the row names them: "O=1|2".
bool may_have_partner(const RowOfBlock& block) {
    return std::ranges::any_of(words_of(block.row().others), [&](std::string_view other) {
        const WordCondition wanted = condition_of(other);
        const Word* word = block.find(wanted.address);
        if (word == nullptr) return wanted.or_missing;
        return wanted.values.empty() || fits(*word, wanted.values) != Fits::no;
    });
}

void check(const RowOfBlock& block, Reporter& reporter) {
    const WordRow& row = block.row();
    if (may_have_partner(block)) return;
    for (const Word* word : block.own(row.words))
        block.report(
            reporter, *word, "alone",
            {block.text_of(*word), block.text_of(block.code), partners_of(row), std::string(row.effect)});
}

} // namespace
} // namespace maclint::rules
