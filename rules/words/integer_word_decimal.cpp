//! MAC551: a decimal point where a whole number belongs.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/fixes.hpp"
#include "rules/words/row_index.hpp"
#include "rules/words/row_of_block.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

namespace maclint::rules {

namespace {
void check(const RowOfBlock& block, Reporter& reporter);
}

extern const Rule integer_word_decimal{
    .code = "MAC551",
    .name = "integer-word-decimal",
    .summary = "A word that takes whole numbers has a decimal point",
    .why = "Numbers of offsets, repeats and steps of a thousandth have no point: the control stops, or reads "
           "another"
           " number than the one that was meant.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"point", "Decimal point in '{0}' of {1}: {2}.", "Write the number without a point."},
                 {"of_address", "Decimal point in '{0}', a whole number: {2}.",
                  "Write the number without a point."}},
    .bad = {{"fanuc", R"nc(
O9551(CHANGE)
G91 G30 P2. Z0
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9551(CHANGE)
G91 G30 P2 Z0
M30
)nc"}},
    .sources = {"CSDN-PS: alarm 007", "T: further rows name theirs"},
    .check = RowCheck{.says = RowStatement::whole, .check = &check},
};

namespace {

/// The words that the row names. D and H, which any block takes, are the code's own beside `G41`, where the
/// chapter of no other code of the block has them.
std::vector<const Word*> words_of_row(const RowOfBlock& block) {
    const WordsOfCodes& chapters = block.index.words_of_codes();
    if (block.is_of_address() || chapters.empty()) return block.own(block.row().words);
    std::vector<const Word*> found;
    for (const Word& word : block.block.words) {
        if (!word.has_value() || !has_word(block.row().words, word.address)) continue;
        const bool is_of_another = std::ranges::any_of(block.block.words, [&](const Word& other) {
            return &other != &block.code && has_word("G M", other.address) &&
                   chapters.may_take(other, word.address);
        });
        if (!is_of_another) found.push_back(&word);
    }
    return found;
}

/// `D1.5`: on a control that nobody has named it may be the radius itself.
bool may_be_a_size(const RowOfBlock& block, const Literal& value) {
    return block.block.analysis.control().assumed && !block.is_of_address() &&
           value.value != std::floor(value.value);
}

void check(const RowOfBlock& block, Reporter& reporter) {
    const WordRow& row = block.row();
    for (const Word* word : words_of_row(block)) {
        const auto* value = std::get_if<Literal>(&word->value);
        if (value == nullptr || !value->decimal_point || may_be_a_size(block, *value)) continue;
        Finding& finding =
            block.report(reporter, *word, block.is_of_address() ? "of_address" : "point",
                         {block.text_of(*word), block.text_of(block.code), std::string(row.effect)});
        // Where the control takes the point, it may mean another number than the one without.
        const std::string text = block.text_of(*word);
        const auto point = text.find('.');
        if (point != std::string::npos && text.find_first_not_of('0', point + 1) == std::string::npos)
            offer_text(finding,
                       finding.severity == Severity::error ? Applicability::safe : Applicability::unsafe,
                       word->span, text.substr(0, point));
    }
}

} // namespace
} // namespace maclint::rules
