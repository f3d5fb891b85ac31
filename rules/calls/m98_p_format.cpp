//! MAC417: how often a program runs stands in the digits of its number.
#include "analyzer/program/tables.hpp"
#include "analyzer/program/whole_number.hpp"
#include "analyzer/queries/calls/call_words.hpp"
#include "analyzer/source/budget.hpp"
#include "rules/fixes.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <cstdint>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule m98_p_format{
    .code = "MAC417",
    .name = "m98-p-format",
    .summary = "M98 P51002 runs O1002 five times on one control, and looks for O51002 on another",
    .why = "With program numbers of four digits, what stands before them in P is the number of repeats. "
           "Controls "
           "with longer numbers, Haas among them, take all of it for the number: the wrong program runs, or "
           "none.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::macro_calls},
    .messages =
        {{"both", "Repeats in the program number: '{0}' runs O{1} {2} times, and O{3} is there, too.",
          "Write the repeats with L."},
         {"whole",
          "Program number of more than four digits: '{0}' calls O{3}, which is not there, and not O{1} {2} "
          "times.",
          "Write the repeats with L."},
         {"packed", "Repeats in the program number: '{0}' runs O{1} {2} times.",
          "Write the repeats with L, which all controls read alike.", true}},
    .bad = {{"fanuc", R"nc(
O0417(PLATE)
M98 P51417
M30
O1417(HOLE)
X10.
M99
O51417(SLOT)
Y10.
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O0417(PLATE)
M98 P1417 L5
M30
O1417(HOLE)
X10.
M99
O51417(SLOT)
Y10.
M99
)nc"}},
    .sources = {"CPH-M98"},
    .check = &check,
};

namespace {

constexpr std::int64_t after_four_digits = 10'000;
constexpr std::size_t figures = 4; ///< of a program's number

/// Of a program, as P has it; nullptr where it is computed.
const Word* word_with_number(const Program& program, const queries::CallInBlock& call) {
    const auto found = std::ranges::find_if(call.words, [&](const Word& word) {
        return std::holds_alternative<Literal>(word.value) &&
               queries::part_of(program, call, word) == queries::CallPart::program;
    });
    return found == call.words.end() ? nullptr : &*found;
}

/// The whole number.
std::optional<std::int64_t> number_in(const Program& program, const queries::CallInBlock& call) {
    const Word* word = word_with_number(program, call);
    if (word == nullptr) return std::nullopt;
    return whole_number(std::get<Literal>(word->value).value);
}

bool is_there(const ProgramAnalysis& analysis, std::int64_t number) {
    return any_within_budget(analysis.workspace().programs(), [number](const ProgramAnalysis& other) {
        return other.program().number == number;
    });
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const queries::CallInBlock& call : queries::calls_with_words(analysis)) {
        const auto written = call.passes_arguments() ? std::nullopt : number_in(program, call);
        const auto* id = std::get_if<ExpressionId>(&call.call.program);
        if (!written || *written < after_four_digits || *written % after_four_digits == 0 || id == nullptr)
            continue;
        const auto* called = std::get_if<Literal>(&program.expressions[*id].node);
        const bool holds_repeats = called != nullptr && called->value != static_cast<double>(*written);
        const CallSite* site = analysis.call_at(call.effect);
        const std::int64_t last = *written % after_four_digits;
        const bool whole_is_there = is_there(analysis, *written);
        const bool lacks_whole = !holds_repeats && !call.call.repeat && !whole_is_there && site != nullptr &&
                                 site->candidates == 0 && is_there(analysis, last);
        if (!holds_repeats && !lacks_whole) continue;
        const Span span = program.effects[call.effect].span;
        const std::string_view message = lacks_whole ? "whole" : whole_is_there ? "both" : "packed";
        Finding& finding =
            reporter.report({analysis, call.effect}, span, message,
                            {quoted(program, span), std::to_string(last),
                             std::to_string(*written / after_four_digits), std::to_string(*written)});
        const Word* word = word_with_number(program, call);
        const std::string text(program.slice(word->span)); // P30100
        const bool is_plain = text.find_first_not_of("0123456789", 1) == std::string::npos;
        // Another control takes all of it for the number of the program.
        if (message == "packed" && is_plain && text.size() > 1 + figures)
            offer_text(finding, Applicability::unsafe, word->span,
                       text.substr(0, 1) + text.substr(text.size() - figures) + " L" +
                           std::to_string(*written / after_four_digits));
    }
}

} // namespace
} // namespace maclint::rules
