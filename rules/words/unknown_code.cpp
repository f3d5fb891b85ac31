//! MAC583: a code that the language's manual does not have.
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/lines_with.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/reporter.hpp"
#include "rules/rule.hpp"
#include "rules/words/code_pages.hpp"

#include <array>
#include <cstddef>
#include <string_view>
#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule unknown_code{
    .code = "MAC583",
    .name = "unknown-code",
    .summary = "A code stands in no chapter of the language's manual",
    .why = "A code that nobody describes is a typing error (G27 for G17), comes from another control, or "
           "belongs to the"
           " maker of the machine: on any other machine the control stops there.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"unknown", "Unknown code {0}: the manual describes none of that number.",
                  "Correct it; if it is one of the machine's maker, allow it with a comment or in the "
                  "configuration."}},
    .bad = {{"dinplus", R"nc(
%TULO.NC
MACHINING
N1 G0 X80 Z5
N2 G27 X5
END
)nc"}},
    .good = {{"dinplus", R"nc(
%TULO.NC
MACHINING
N1 G0 X80 Z5
N2 G26 S2000
END
)nc"}},
    .sources = {"SEED-003:9940-10160", "T: chapters of the manual are complete"},
    .check = &check,
};

namespace {

/// The G codes that chapters lack.
LetterCodes unknown_codes(const ControlModel& control) {
    LetterCodes unknown{'G', {}};
    for (std::size_t code = 0; code < CodeNumbers::capacity; ++code)
        if (!has_code_page(control, 'G', static_cast<double>(code)))
            unknown.codes.add(static_cast<double>(code));
    unknown.codes.add_beyond();
    return unknown;
}

void look_at(const ProgramAnalysis& analysis, std::span<const Word> words, Reporter& reporter) {
    for (const Word& word : words) {
        const auto* value = std::get_if<Literal>(&word.value);
        if (word.address != "G" || value == nullptr) continue;
        if (has_code_page(analysis.control(), 'G', value->value)) continue;
        reporter.report({analysis, word.span}, word.span, "unknown", {quoted(analysis.program(), word.span)});
    }
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    if (!has_all_codes(analysis.control())) return;
    const std::array unknown = {unknown_codes(analysis.control())};
    const Slice all{0, static_cast<Id>(program.items.size())};
    for_each_block_with_words(
        program, all,
        [&](const PlainRun& run, const auto& take) {
            for_each_line_with(unknown, program.text, run.span, take);
        },
        [](const WordSummary&) { return true; },
        [&](const BlockView&, std::span<const Word> words, const WordSummary*) {
            look_at(analysis, words, reporter);
        });
}

} // namespace
} // namespace maclint::rules
