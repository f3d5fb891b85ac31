//! MAC576: a value that its code does not take.
#include "rules/path.hpp"
#include "rules/words/row_of_block.hpp"
#include "rules/words/row_text.hpp"
#include "rules/words/word_list.hpp"

#include <string>
#include <variant>

namespace maclint::rules {

namespace {
void check(const RowOfBlock& block, Reporter& reporter);
}

extern const Rule value_not_allowed{
    .code = "MAC576",
    .name = "value-not-allowed",
    .aliases = "DIN022",
    .summary = "A word has a value that its code does not take",
    .why =
        "Outside the values of its manual a word is refused with an alarm, cut to the nearest one, or selects"
        " something else than was meant.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"outside", "Value '{0}' beside {1}, which takes {2} of {3}: {4}.", "Write {2} of {3}."},
                 {"of_address", "Value '{0}', where {2} takes {3}: {4}.", "Write {2} of {3}."}},
    .bad = {{"dinplus", R"nc(
%TULO.NC
MACHINING
N1 G48 D1 A120
END
)nc"}},
    .good = {{"dinplus", R"nc(
%TULO.NC
MACHINING
N1 G48 D1 A50
END
)nc"}},
    .sources = {"SEED-003:12500", "T: further rows name theirs"},
    .check = RowCheck{.says = RowStatement::values, .check = &check},
};

namespace {

void check(const RowOfBlock& block, Reporter& reporter) {
    const WordRow& row = block.row();
    for (const Word* word : block.own(row.words)) {
        const auto* value = std::get_if<Literal>(&word->value);
        if (value == nullptr || word->incremental || takes(row, value->value)) continue;
        block.report(reporter, *word, block.is_of_address() ? "of_address" : "outside",
                     {block.text_of(*word), block.text_of(block.code), std::string(word->address),
                      values_allowed_by(row), std::string(row.effect)});
    }
}

} // namespace
} // namespace maclint::rules
