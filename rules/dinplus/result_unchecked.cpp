//! DIN930: a measuring cycle leaves its errors to the program, which does not ask for them.
#include "analyzer/program/word_lookup.hpp"
#include "analyzer/queries/machine/machine_reads.hpp"
#include "analyzer/queries/words/block_words.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <array>
#include <string>
#include <string_view>

namespace maclint::rules {

namespace {
void check(const queries::WordsOfBlock& block, Reporter& reporter);
}

extern const Rule result_unchecked{
    .code = "DIN930",
    .name = "probe-result-unchecked",
    .summary = "A measuring cycle leaves its errors to the program, which does not ask for them",
    .why = "With O0, or Q0 of G912, the control goes on where the probe has touched nothing: the program "
           "works with a position that nobody has measured.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"plain",
                  "Result that nobody asks for: '{0}' leaves errors to the program, and no block "
                  "behind it reads {1}.",
                  "Ask for {1} behind it, or have the control stop ({2})."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N1 T5
N2 G770 R2 D0 K-8 AC50 BD0.2 O0
N3 G0 X50
N4 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N1 T5
N2 G770 R2 D0 K-8 AC50 BD0.2 O0
N3 IF #i99<999997
N4 THEN
N5 G0 X50
N6 ENDIF
N7 M30
END
)nc"},
             {"dinplus", R"nc(
MACHINING
N1 T5
N2 G770 R2 D0 K-8 AC50 BD0.2 O1
N3 G0 X50
N4 M30
END
)nc"}},
    .sources = {"SEED-003:21105-21110", "SEED-003:20333-20342", "SEED-003:21200", "SEED-003:22325"},
    .check = WordCheck{.addresses = "O Q", .blocks = WordCheck::Blocks::all, .check = &check},
};

namespace {

/// Codes of measuring, the word that leaves errors to the program where it is 0, and what tells of them.
struct Measures {
    double first, last;
    std::string_view word, result;
};
constexpr std::array rows = {
    Measures{764, 787, "O", "#i99"}, // [21105, 21200]
    Measures{912, 912, "Q", "#a9"},  // [22325]
    Measures{917, 917, "O", "#i99"}, // [20333-20342]
};

void check(const queries::WordsOfBlock& block, Reporter& reporter) {
    if (!block.analysis.is_main()) return;
    const Program& program = block.analysis.program();
    for (const Word& code : block.words) {
        const auto number = number_of(&code);
        if (!number || code.address != "G") continue;
        for (const Measures& row : rows) {
            const Word* word = find_word(block.words, row.word);
            if (*number < row.first || *number > row.last || number_of(word) != 0) continue;
            if (!queries::may_be_read_behind(program, row.result, block.block.span.end))
                reporter.report({block.analysis, word->span}, word->span, "plain",
                                {quoted(program, block.block.span), std::string(row.result),
                                 std::string(row.word) + "1"});
        }
    }
}

} // namespace
} // namespace maclint::rules
