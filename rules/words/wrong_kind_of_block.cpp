//! DIN706: a cycle names a block of a contour that it cannot machine.
#include "analyzer/queries/contours/contour_blocks.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/words/row_of_block.hpp"
#include "rules/words/word_list.hpp"

#include <string>
#include <variant>

namespace maclint::rules {

namespace {
void check(const RowOfBlock& block, Reporter& reporter);
}

extern const Rule wrong_kind_of_block{
    .code = "DIN706",
    .name = "contour-kind-mismatch",
    .summary = "A cycle names a block of a contour that it cannot machine",
    .why = "The control stops with an error when it gets to the cycle, or machines something else.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::block_references},
    .messages = {{"kind", "Block of another kind: '{0}' of {1} names N{2}, which holds {3}: {4}.",
                  "Name a block with {5}."}},
    .bad = {{"dinplus", R"nc(
FINISHED
N1 G0 X60 Z0
N2 G1 Z-40
N3 G23 H0 Z-20 I52 K4
N4 G1 Z-60
MACHINING
N10 T1
N11 G870 NS3
N12 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
FINISHED
N1 G0 X60 Z0
N2 G1 Z-40
N3 G22 Z-20 I52 K-24
N4 G1 Z-60
MACHINING
N10 T1
N11 G870 NS3
N12 M30
END
)nc"}},
    .sources = {"SEED-003:20803", "T: further rows name theirs"},
    .check = RowCheck{.says = RowStatement::names_none, .check = &check},
};

namespace {

void check(const RowOfBlock& block, Reporter& reporter) {
    const WordRow& row = block.row();
    for (const Word* word : block.own(row.words)) {
        const auto* number = std::get_if<Literal>(&word->value);
        if (number == nullptr) continue;
        const ProgramFile& file = block.block.analysis.file();
        const auto named = queries::find_contour_block(file, number->value);
        if (!named) continue;
        queries::read_block(*named, [&](const BlockView& view, std::span<const Word> words) {
            for (const Word& code : words) {
                if (!has_word(row.others, RowOfBlock::code_of(code))) continue;
                block
                    .report(reporter, *word, "kind",
                            {block.text_of(*word), block.text_of(block.code), number_word(number->value),
                             RowOfBlock::code_of(code), std::string(row.effect), either_of(row.first_block)})
                    .related.push_back({block.block.analysis.source(), view.span, "the block that is named"});
                return;
            }
        });
    }
}

} // namespace
} // namespace maclint::rules
