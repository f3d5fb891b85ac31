//! MAC408: a length that a macro call passes without its decimal point.
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/call_words.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/source/budget.hpp"
#include "rules/fixes.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <string_view>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule argument_missing_decimal{
    .code = "MAC408",
    .name = "argument-missing-decimal",
    .summary = "A macro call passes a length without its point, while those beside it have one",
    .why =
        "A value without a point counts in the least input increment of its letter: X100 is 0.1 mm, and the "
        "called program moves there. Only controls set to calculator input take it for 100 mm.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::macro_calls},
    .facts = dataflow::facts<dataflow::Read>(),
    .messages = {{"plain",
                  "Argument without its point: '{0}' counts in least increments, {1} moves to {2}, and '{3}' "
                  "beside it has a point.",
                  "Write the point, if {0} is meant as a length."}},
    .bad = {{"fanuc", R"nc(
O0408(PLATE)
G65 P9408 X100 Y36.
M30
O9408(HOLE, X Y)
G0 X#24 Y#25
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O0408(PLATE)
G65 P9408 X100. Y36. C4
G65 P9408 X0 Y36. C4
M30
O9408(HOLES, X Y C)
WHILE[#3GT0]DO1
G91 X#24 Y#25
#3=#3-1
END1
G90
M99
)nc"}},
    .sources = {"MAN-PB278", "TENC-G65"},
    .check = &check,
};

namespace {

/// A whole number other than 0 without a point.
bool lacks_point(const Word& word) {
    const auto* literal = std::get_if<Literal>(&word.value);
    return literal != nullptr && !literal->decimal_point && literal->value != 0;
}

bool has_point(const Word& word) {
    const auto* literal = std::get_if<Literal>(&word.value);
    return literal != nullptr && literal->decimal_point;
}

/// Whether the value of the word is the variable that is read there, or the same with its sign turned.
bool is_all_of(const Program& program, const Word& word, ExpressionId read) {
    const auto* id = std::get_if<ExpressionId>(&word.value);
    const auto* apply = id == nullptr ? nullptr : std::get_if<Apply>(&program.expressions[*id].node);
    const bool negated = apply != nullptr && apply->operation == Operation::negate;
    return id != nullptr && (negated ? program.operands_of(*apply).front() : *id) == read;
}

/// The word of the program that moves an axis to the variable's value, of a letter of that kind.
const Word* word_that_moves(const ProgramAnalysis& called, Variable variable, std::string_view lengths) {
    const Program& program = called.program();
    for (const dataflow::Read& read : called.facts().all<dataflow::Read>()) {
        if (!Budget::allows()) return nullptr;
        if (read.variable != variable) continue;
        const Offset at = program.expressions[read.expression].span.begin;
        const auto after =
            std::ranges::upper_bound(program.words, at, {}, [](const Word& word) { return word.span.begin; });
        if (after == program.words.begin()) continue;
        const Word& word = *(after - 1);
        if (is_all_of(program, word, read.expression) && lengths.find(word.address) != std::string_view::npos)
            return &word;
    }
    return nullptr;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    constexpr std::string_view lengths = "XYZUVWIJKR";
    const Program& program = analysis.program();
    if (program.control->calculator_input) return;
    const auto is_length = [&](const Word& word) {
        return lengths.find(word.address) != std::string_view::npos;
    };
    for (const queries::CallInBlock& call : queries::calls_with_words(analysis)) {
        const CallSite* site = call.passes_arguments() ? analysis.call_at(call.effect) : nullptr;
        const ProgramAnalysis* called = site == nullptr ? nullptr : queries::called_program(analysis, *site);
        if (called == nullptr) continue;
        const auto pointed = std::ranges::find_if(
            call.after(), [&](const Word& word) { return is_length(word) && has_point(word); });
        if (pointed == call.after().end()) continue;
        for (const Word& word : call.after()) {
            if (!is_length(word) || !lacks_point(word)) continue;
            const Argument* argument = queries::argument_of(program, call, word);
            const Variable* given = argument == nullptr ? nullptr : std::get_if<Variable>(&argument->given);
            const Word* moves = given == nullptr ? nullptr : word_that_moves(*called, *given, lengths);
            if (moves == nullptr) continue;
            Finding& finding =
                reporter.report({analysis, word.span}, word.span, "plain",
                                {quoted(program, word.span), called->program().name,
                                 quoted(called->program(), moves->span), quoted(program, pointed->span)});
            offer_text(finding, Applicability::unsafe, word.span,
                       std::string(program.slice(word.span)) + ".");
            finding.related.push_back({called->source(), moves->span, "the value moves an axis here"});
        }
    }
}

} // namespace
} // namespace maclint::rules
