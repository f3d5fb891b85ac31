//! MAC426: a subprogram is to start at a block that it does not have.
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/program/whole_number.hpp"
#include "analyzer/queries/calls/call_words.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule start_block_missing{
    .code = "MAC426",
    .name = "start-block-missing",
    .summary = "M98 with Q starts a program at a sequence number that it does not have",
    .why = "Newer controls begin the subprogram at the block that Q names. They search it there and stop "
           "with an "
           "alarm where it is not; older ones pass over Q.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::macro_calls, Capability::sequence_numbers},
    .messages = {{"plain", "Missing start block: '{0}' starts {1} at N{2}, which {1} does not have.",
                  "Add the sequence number there, or correct Q."}},
    .bad = {{"fanuc", R"nc(
O0426(PLATE)
M98 P1426 Q200
M30
O1426(HOLES)
N100 X10.
N300 X20.
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O0426(PLATE)
M98 P1426 Q300
M30
O1426(HOLES)
N100 X10.
N300 X20.
M99
)nc"}},
    .alarms = {{"FANUC 30i/0i-D", "078", "SEQUENCE NUMBER NOT FOUND"}},
    .sources = {"GH-ALM"},
    .check = &check,
};

namespace {

bool has_block(const Program& program, std::int64_t number) {
    bool found = false;
    for_each_block(program, [&](const BlockView& block) {
        found = block.number == number;
        return !found;
    });
    return found;
}

/// The word that names the block at which the program starts, and its number.
struct Start {
    const Word* word;
    std::int64_t number;
};

std::optional<Start> start_in(const queries::CallInBlock& call) {
    for (const Word& word : call.words) {
        const auto* literal = std::get_if<Literal>(&word.value);
        if (word.address != "Q" || literal == nullptr) continue;
        if (const auto number = whole_number(literal->value)) return Start{&word, *number};
    }
    return std::nullopt;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const bool stops = !reporter.alarm_for(analysis.file(), "plain").empty();
    if (!stops && !analysis.control().assumed) return; // nothing is known of Q on the others
    const Program& program = analysis.program();
    for (const queries::CallInBlock& call : queries::calls_with_words(analysis)) {
        const CallSite* site = call.passes_arguments() ? nullptr : analysis.call_at(call.effect);
        const ProgramAnalysis* called = site == nullptr ? nullptr : queries::called_program(analysis, *site);
        const auto start = called == nullptr ? std::nullopt : start_in(call);
        if (!start || has_block(called->program(), start->number)) continue;
        const Span span = program.effects[call.effect].span;
        Finding& finding =
            reporter.report({analysis, start->word->span}, start->word->span, "plain",
                            {quoted(program, span), called->program().name, std::to_string(start->number)});
        if (!stops) finding.severity = Severity::warning;
    }
}

} // namespace
} // namespace maclint::rules
