//! MAC404: a word that a macro call cannot pass.
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/call_words.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <string>
#include <string_view>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule forbidden_argument{
    .code = "MAC404",
    .name = "forbidden-argument",
    .summary =
        "A macro call holds a word that cannot be an argument: G, N or O, or an eleventh set of I, J, K",
    .why =
        "All that stands after the code of a macro call is an argument. G, N, O, P and L have no variable, "
        "and the sets of I, J and K end at #33: the control stops in the block.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::macro_calls},
    .messages = {{"code",
                  "Code as an argument: '{0}' stands after {1}, which takes it as an argument and has no "
                  "variable for it, and the control stops here.",
                  "Write it in a block of its own, or before {1}."},
                 {"letter",
                  "Letter that is no argument: {1} has no variable for '{0}', and the control stops "
                  "here.",
                  "Use a letter that has one."},
                 {"set",
                  "Too many sets of I, J and K: '{0}' begins or fills set {2} of {1}, the last of which is "
                  "set {3}, and the control stops here.",
                  "Pass the values in common variables."}},
    .bad = {{"fanuc", R"nc(
O0404(PLATE)
G65 P9404 G91 X10.
M30
O9404(HOLE, X)
G0 X#24
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O0404(PLATE)
G91 G65 P9404 L2 X10.
G90
M30
O9404(HOLE, X)
G0 X#24
M99
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "129", "ILLEGAL ARGUMENT ADDRESS", true, "code letter"},
               {"FANUC 30i/0i-D", "129", "USE 'G' AS ARGUMENT", true, "code"},
               {"FANUC 30i/0i-D", "1095", "TOO MANY TYPE-2 ARGUMENT", true, "set"}},
    .sources = {"SEED-001:460", "GH-ALM", "CNCWIKI-ARG"},
    .check = &check,
};

namespace {

/// A letter of one of the sets, as the control counts them: one that does not follow the last begins a set.
bool is_of_a_set(const ControlModel& control, const Word& word) {
    return std::ranges::find(control.repeatable_arguments, word.address) !=
           control.repeatable_arguments.end();
}

/// The set to which the word belongs, from 1 on.
std::size_t set_of(const ControlModel& control, const queries::CallInBlock& call, const Word& word) {
    std::size_t set = 1;
    char last = 0;
    for (const Word& other : call.after()) {
        if (!is_of_a_set(control, other) || !other.has_value()) continue;
        if (other.address.front() <= last) ++set;
        last = other.address.front();
        if (&other == &word) break;
    }
    return set;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const ControlModel& control = analysis.control();
    for (const queries::CallInBlock& call : queries::calls_with_words(analysis)) {
        // Called after each block, it takes the codes of the block, too [GH-ALM 129].
        const bool takes_codes = call.kind.trigger == CallTrigger::after_each_block;
        if (!call.passes_arguments()) continue;
        const std::string code = quoted(program, call.code_word().span);
        const auto report = [&](const Word& word, std::string_view message) {
            const std::string set = std::to_string(set_of(control, call, word));
            reporter.report({analysis, word.span}, word.span, message,
                            {quoted(program, word.span), code, set, std::to_string(control.series.size())});
        };
        for (const Word& word : call.after()) {
            if (word.address.size() != 1) continue;
            const char letter = word.address.front();
            if (queries::part_of(program, call, word) != queries::CallPart::none || !word.has_value())
                continue;
            if (is_of_a_set(control, word)) {
                report(word, "set");
                break;
            }
            if (letter == 'G' ? !takes_codes : letter == 'N' || letter == 'O')
                report(word, letter == 'G' ? "code" : "letter");
        }
    }
}

} // namespace
} // namespace maclint::rules
