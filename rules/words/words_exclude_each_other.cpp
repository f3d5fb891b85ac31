//! MAC575: words that exclude each other in a block.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/words/row_of_block.hpp"

#include <algorithm>
#include <string>

namespace maclint::rules {

namespace {
void check(const RowOfBlock& block, Reporter& reporter);
}

extern const Rule words_exclude_each_other{
    .code = "MAC575",
    .name = "words-exclude-each-other",
    .aliases = "DIN024",
    .summary = "Two words of a code exclude each other",
    .why =
        "A code that can be told the same in two ways takes one of them: the other is passed over without a"
        " message, or the control stops.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"both", "Words '{1}' and '{2}' exclude each other beside {0}: {3}.",
                  "Remove the one that is not meant."}},
    .bad = {{"fanuc", R"nc(
O9575(DWELL)
G90 G54 G0 X0 Y0
G4 X1. P500
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9575(DWELL)
G90 G54 G0 X0 Y0
G4 P500
M30
)nc"}},
    .sources = {"SEED-003:18040", "T: further rows name theirs"},
    .check = RowCheck{.says = RowStatement::excludes, .check = &check},
};

namespace {

void check(const RowOfBlock& block, Reporter& reporter) {
    const WordRow& row = block.row();
    for (const Word* word : block.own(row.words)) {
        const auto others = block.own(row.others);
        const auto other =
            std::ranges::find_if(others, [&](const Word* one) { return one->address != word->address; });
        if (other == others.end()) continue;
        const auto [first, second] = std::minmax(
            word, *other, [](const Word* a, const Word* b) { return a->span.begin < b->span.begin; });
        Finding& finding = block.report(reporter, *second, "both",
                                        {block.text_of(block.code), block.text_of(*first),
                                         block.text_of(*second), std::string(row.effect)});
        finding.related.push_back({block.block.analysis.source(), first->span, "the other one stands here"});
        return;
    }
}

} // namespace
} // namespace maclint::rules
