//! DIN930: a measuring cycle leaves its errors to the program, which does not ask for them.
#include "analyzer/program/block_view.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <string>
#include <string_view>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
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
    .check = &check,
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

bool reads(std::string_view text, std::string_view variable) {
    return std::ranges::search(text, variable, [](char a, char b) {
               return std::tolower(static_cast<unsigned char>(a)) == b;
           }).begin() != text.end();
}

void look_at(const ProgramAnalysis& analysis, const BlockView& block, std::span<const Word> words,
             Reporter& reporter) {
    const Program& program = analysis.program();
    for (const Word& code : words) {
        const auto* number = std::get_if<Literal>(&code.value);
        if (number == nullptr || code.address != "G") continue;
        for (const Measures& row : rows) {
            if (number->value < row.first || number->value > row.last) continue;
            const auto word = std::ranges::find(words, row.word, &Word::address);
            const auto* kind = word == words.end() ? nullptr : std::get_if<Literal>(&word->value);
            if (kind == nullptr || kind->value != 0) continue;
            const std::string_view later = program.text.substr(block.span.end);
            if (!reads(later, row.result))
                reporter.report(
                    {analysis, word->span}, word->span, "plain",
                    {quoted(program, block.span), std::string(row.result), std::string(row.word) + "1"});
        }
    }
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const bool calls = std::ranges::any_of(program.effects, [](const Effect& effect) {
        return std::holds_alternative<Call>(effect.what); // that program may ask
    });
    if (calls || !analysis.is_main()) return;
    const syntax::AddressSet wanted = addresses_named(program, "O Q");
    for (const Section& section : program.sections)
        if (section.executed == Section::Executed::when_reached)
            for_each_block_with_words(
                program, section.items,
                [&](const PlainRun& run, const auto& take) {
                    if (run.words.addresses.meets(wanted)) take(run.span);
                },
                [&](const WordSummary& words) { return words.addresses.meets(wanted); },
                [&](const BlockView& block, std::span<const Word> words, const WordSummary*) {
                    look_at(analysis, block, words, reporter);
                });
}

} // namespace
} // namespace maclint::rules
