//! MAC403: words that a macro call does not take, because they stand before it.
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/call_words.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule words_before_call{
    .code = "MAC403",
    .name = "words-before-g65",
    .summary = "Words stand before the code of a macro call, which passes only what stands after it",
    .why =
        "The called program gets no value for the letter: it runs without the depth or the position that the "
        "block names, and an axis word makes a move of its own first.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::macro_calls},
    .messages = {{"one", "Word before its macro call: '{0}' stands before {1} and is not passed.",
                  "Write it after {1}."},
                 {"several", "Words before their macro call: '{0}' stand before {1} and are not passed.",
                  "Write them after {1}."}},
    .bad = {{"fanuc", R"nc(
O0403(PLATE)
X10. Y5. G65 P9403
M30
O9403(HOLE, X Y)
IF[#24EQ#0]THEN #24=0
IF[#25EQ#0]THEN #25=0
G0 X#24 Y#25
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O0403(PLATE)
N10 G90 M8 G65 P9403 X10. Y5.
M30
O9403(HOLE, X Y)
IF[#24EQ#0]THEN #24=0
IF[#25EQ#0]THEN #25=0
G0 X#24 Y#25
M99
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "129", "ILLEGAL ARGUMENT ADDRESS"}},
    .sources = {"TENC-G65"},
    .check = &check,
};

namespace {

/// Switches something by itself, wherever it stands: coolant before a call, its tool, its speed.
bool acts_alone(const Word& word) {
    constexpr std::string_view letters = "GMSTFN";
    return word.address.size() != 1 || letters.find(word.address) != std::string_view::npos;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const ControlModel& control = analysis.control();
    for (const queries::CallInBlock& call : queries::calls_with_words(analysis)) {
        if (!call.passes_arguments()) continue;
        std::vector<const Word*> lost;
        for (const Word& word : call.before())
            if (!acts_alone(word) && word.has_value() &&
                std::ranges::find(control.formal_letters, word.address.front()) !=
                    control.formal_letters.end())
                lost.push_back(&word);
        // Of two calls in a block, the words between them are those of the first.
        if (lost.empty() || queries::call_twice(control, call.words)) continue;
        const Span span{lost.front()->span.begin, lost.back()->span.end};
        Finding& finding = reporter.report({analysis, span}, span, lost.size() == 1 ? "one" : "several",
                                           {quoted(program, span), quoted(program, call.code_word().span)});
        if (finding.alarm.empty()) finding.severity = Severity::warning; // it may go on without the value
    }
}

} // namespace
} // namespace maclint::rules
