//! MAC523: a code without a word that it needs.
#include "rules/words/row_of_block.hpp"
#include "rules/words/row_text.hpp"
#include "rules/words/word_list.hpp"

#include <string>
#include <utility>
#include <vector>

namespace maclint::rules {

namespace {
void check(const RowOfBlock& block, Reporter& reporter);
}

extern const Rule word_missing{
    .code = "MAC523",
    .name = "word-missing",
    .aliases = "DIN023",
    .summary = "A code stands without a word that it needs",
    .why = "A cycle without its depth, a thread without its pitch: the control stops with an alarm, or goes "
           "on with"
           " what it has, which is another program than the one that was meant.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"missing", "Word missing beside {0}: {1}. Without it {2}.", "Write {3}."},
                 {"goes_on", "Word missing in a block that goes on with {4}: {1} beside {0}. Without it {2}.",
                  "Write {3}, or G1 if a straight move is meant."}},
    .bad = {{"fanuc", R"nc(
O9523(PECK)
G90 G54 G0 X0 Y0
G43 Z50. H1
S2000 M3
G83 X10. Y10. Z-30. R2. F150.
G80
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9523(PECK)
G90 G54 G0 X0 Y0
G43 Z50. H1
S2000 M3
G83 X10. Y10. Z-30. R2. Q5. F150.
G80
M30
)nc"}},
    .sources = {"GH-ALM: alarm 045", "SEED-003:15592", "T: further rows name theirs"},
    .check = RowCheck{.says = RowStatement::needs, .check = &check},
};

namespace {

void check(const RowOfBlock& block, Reporter& reporter) {
    const WordRow& row = block.row();
    if (block.find(row.words) != nullptr) return;
    std::vector<std::string> texts = {block.text_of(block.code), words_with_meaning(row),
                                      std::string(row.effect), either_of(row.words)};
    if (block.goes_on == nullptr) {
        block.report(reporter, block.code, "missing", std::move(texts));
        return;
    }
    texts.push_back(block.under);
    const ProgramAnalysis& analysis = block.block.analysis;
    Finding& finding = block.report(reporter, block.code, "goes_on", std::move(texts));
    if (block.goes_on->set_by == queries::Mode::SetBy::word)
        finding.related.push_back(
            {analysis.source(), queries::span_of(analysis, *block.goes_on), block.under + " stands here"});
}

} // namespace
} // namespace maclint::rules
