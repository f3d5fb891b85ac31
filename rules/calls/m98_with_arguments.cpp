//! MAC418: a subprogram call with words that only a macro call passes.
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/call_words.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "rules/listed.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule m98_with_arguments{
    .code = "MAC418",
    .name = "m98-with-arguments",
    .summary = "M98 passes no arguments, but the program that it calls reads them",
    .why = "The words beside M98 are words of the block: an axis word moves the axis before the program "
           "runs, the "
           "others do nothing. The variables that the program reads stay vacant.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::macro_calls, Capability::vacancy},
    .messages =
        {{"plain",
          "Arguments that are not passed: {1} passes none, so '{0}' does not reach {2}, which reads {3}.",
          "Call it with G65."}},
    .bad = {{"fanuc", R"nc(
O0418(PLATE)
G90 G54 G0 X0 Y0
M98 P9418 I5.
M30
O9418(DRILL, I)
IF[#4EQ#0]THEN #3000=1(I MISSING)
G91 G1 Z-#4 F100.
G90
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O0418(PLATE)
G90 G54 G0 X0 Y0
G65 P9418 I5.
#4=5.
M98 P9418 X20.
M30
O9418(DRILL, I)
IF[#4EQ#0]THEN #3000=1(I MISSING)
G91 G1 Z-#4 F100.
G90
M99
)nc"}},
    .sources = {"TENC-G65", "SEED-001:529"},
    .check = &check,
};

namespace {

/// Whether a block of the program stores something in the variable, or may.
bool may_set(const Program& program, Variable variable) {
    return std::ranges::any_of(program.effects, [&](const Effect& effect) {
        const auto* assign = std::get_if<Assign>(&effect.what);
        if (assign == nullptr) return std::holds_alternative<UnreadableBlock>(effect.what);
        const auto* target = std::get_if<Variable>(&assign->target);
        return target == nullptr ? std::holds_alternative<StoreAt>(assign->target) : *target == variable;
    });
}

/// Whether the locals of the program may hold something that it has not stored: arguments of its own.
bool may_be_given(const ProgramAnalysis& analysis) {
    return !analysis.is_main() &&
           (analysis.is_macro() || !analysis.callers().empty() || analysis.has_possible_callers());
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const ControlModel& control = analysis.control();
    if (may_be_given(analysis)) return;
    for (const queries::CallInBlock& call : queries::calls_with_words(analysis)) {
        const CallSite* site = call.passes_arguments() ? nullptr : analysis.call_at(call.effect);
        const ProgramAnalysis* called = site == nullptr ? nullptr : queries::called_program(analysis, *site);
        if (called == nullptr) continue;
        const std::vector<Variable> read = called->liveness().live_before(0);
        std::vector<std::string> variables;
        std::vector<const Word*> words;
        for (const Word& word : call.words) {
            if (word.address.size() != 1 || !word.has_value() || word.address == control.functions.address ||
                queries::part_of(program, call, word) != queries::CallPart::none)
                continue;
            const auto letter = std::ranges::find(control.formal_letters, word.address.front());
            if (letter == control.formal_letters.end()) continue;
            const Variable variable =
                control.formals[static_cast<std::size_t>(letter - control.formal_letters.begin())];
            if (std::ranges::find(read, variable) == read.end() || may_set(program, variable)) continue;
            variables.push_back(with_letter(*called, variable));
            words.push_back(&word);
        }
        if (words.empty()) continue;
        const Span span{words.front()->span.begin, words.back()->span.end};
        reporter.report({analysis, call.effect}, span, "plain",
                        {quoted(program, span), quoted(program, call.code_word().span),
                         called->program().name, listed(variables, " and ")});
    }
}

} // namespace
} // namespace maclint::rules
