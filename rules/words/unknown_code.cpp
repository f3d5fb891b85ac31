//! MAC123: a code that neither the control nor its machine has.
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/lines_with.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/reporter.hpp"
#include "rules/rule.hpp"
#include "rules/words/known_codes.hpp"
#include "rules/words/unknown_code_finder.hpp"

#include <algorithm>
#include <string_view>
#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule unknown_code{
    .code = "MAC123",
    .name = "unknown-code",
    .aliases = "MAC583",
    .summary = "A code that neither the control nor its machine has",
    .why = "A code that nobody describes is a typing error (G27 for G17), comes from another control, or "
           "belongs to the maker of the machine: on any other machine the control stops there.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"unknown", "Unknown code {0}: the control has none of that number.",
                  "Correct it; if it is one of the machine's own, name it in the configuration (\"codes\"), "
                  "or allow it "
                  "with a comment."},
                 {"of-no-control", "Unknown code {0}: no control that is known here has one of that number.",
                  "Correct it, or name the machine's own codes in the configuration."},
                 {"not-listed",
                  "Unknown code {0}: the control has none of that number, and the configuration does not "
                  "list it among the machine's own.",
                  "Correct it, or add it to \"codes\" of the control."},
                 {"not-fitted",
                  "Option missing: {0} is a code that this machine lacks, as the configuration says.",
                  "Write the program without it, or correct the configuration."}},
    .bad = {{"dinplus", R"nc(
%TULO.NC
MACHINING
N1 G0 X80 Z5
N2 G27 X5
END
)nc"},
            {"fanuc", R"nc(
%
O1000 (PLATE)
G90 G54
G06 X20. Y10.
M30
%
)nc"}},
    .good = {{"dinplus", R"nc(
%TULO.NC
MACHINING
N1 G0 X80 Z5
N2 G26 S2000
END
)nc"},
             {"fanuc", R"nc(
%
O1000 (PLATE)
G90 G54
G00 X20. Y10.
M30
%
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "010", "IMPROPER G-CODE", false},
               {"FANUC 30i/0i-D", "010", "IMPROPER G-CODE", false}},
    .sources = {"SEED-003:9940-10160", "CSDN-PS", "T: chapters of the manuals are complete"},
    .check = &check,
};

namespace {

/// The message for the code, or empty where it is known, or nobody can know it.
std::string_view message_for(const ProgramAnalysis& analysis, char letter, double code) {
    switch (standing_of(analysis.control(), letter, code)) {
    case CodeStanding::known: return {};
    case CodeStanding::not_fitted: return "not-fitted";
    case CodeStanding::not_listed: return "not-listed";
    case CodeStanding::unknown: return has_macros_for_codes(analysis) ? std::string_view() : "unknown";
    case CodeStanding::of_no_control:
        return has_macros_for_codes(analysis) ? std::string_view() : "of-no-control";
    }
    return {};
}

/// Whether M is an argument there.
bool calls_macro(const Program& program, const BlockView& block) {
    return std::ranges::any_of(program.effects_in(block.effects), [&](const Effect& effect) {
        const auto* call = std::get_if<Call>(&effect.what);
        return call != nullptr && program.control->calls[call->kind].counts_against == NestingLimit::macro;
    });
}

void look_at(const ProgramAnalysis& analysis, const BlockView& block, std::span<const Word> words,
             Reporter& reporter) {
    const bool has_arguments = calls_macro(analysis.program(), block);
    for (const Word& word : words) {
        const auto* value = std::get_if<Literal>(&word.value);
        if ((word.address != "G" && (word.address != "M" || has_arguments)) || value == nullptr) continue;
        const std::string_view message = message_for(analysis, word.address.front(), value->value);
        if (message.empty()) continue;
        Finding& finding = reporter.report({analysis, word.span}, word.span, message,
                                           {quoted(analysis.program(), word.span)});
        if (message == "of-no-control") finding.severity = Severity::note;
    }
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const auto unknown = codes_to_look_at(analysis.control());
    if (unknown->codes.empty()) return;
    const Slice all{0, static_cast<Id>(program.items.size())};
    for_each_block_with_words(
        program, all,
        [&](const PlainRun& run, const auto& take) {
            if (run.words.codes.meets(unknown->kinds))
                for_each_line_with(unknown->codes, program.text, run.span, take);
        },
        [](const WordSummary&) { return true; },
        [&](const BlockView& block, std::span<const Word> words, const WordSummary*) {
            look_at(analysis, block, words, reporter);
        });
}

} // namespace
} // namespace maclint::rules
