//! MAC107: more digits than an address takes.
#include "rules/words/row_of_block.hpp"

#include <algorithm>
#include <string>
#include <variant>

namespace maclint::rules {

namespace {
void check(const RowOfBlock& block, Reporter& reporter);
}

extern const Rule too_many_digits{
    .code = "MAC107",
    .name = "too-many-digits",
    .summary = "A number has more digits before its point than the control takes",
    .why =
        "A digit too many, or two words that ran together, make a position far outside of the machine: the "
        "control stops before it reads on.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"digits", "Number of {1} digits in '{0}', of which the control takes {2}: {3}.",
                  "Write the number that was meant."}},
    .bad = {{"fanuc", R"nc(
O9107(PART)
G90 G54 G0 X123456789. Y0
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9107(PART)
G90 G54 G0 X123.456789 Y0
M30
)nc"}},
    .sources = {"CSDN-PS: alarm 003", "T: further rows name theirs"},
    .check = RowCheck{.says = RowStatement::digits, .check = &check},
};

namespace {

/// Those before the point, zeros in front left out.
std::size_t digits_of(std::string_view word) {
    const std::string_view whole = word.substr(0, word.find('.'));
    const std::size_t first = whole.find_first_of("123456789");
    if (first == std::string_view::npos) return 0;
    return static_cast<std::size_t>(
        std::ranges::count_if(whole.substr(first), [](char c) { return c >= '0' && c <= '9'; }));
}

void check(const RowOfBlock& block, Reporter& reporter) {
    const WordRow& row = block.row();
    for (const Word* word : block.own(row.words)) {
        if (!std::holds_alternative<Literal>(word->value)) continue;
        const std::size_t digits = digits_of(block.text_of(*word));
        if (static_cast<double>(digits) <= row.most) continue;
        block.report(reporter, *word, "digits",
                     {block.text_of(*word), std::to_string(digits),
                      std::to_string(static_cast<int>(row.most)), std::string(row.effect)});
    }
}

} // namespace
} // namespace maclint::rules
