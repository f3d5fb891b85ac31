//! MAC405: I, J and K of a macro call out of the order of the alphabet.
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/call_words.hpp"
#include "analyzer/queries/calls/callers.hpp"
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

extern const Rule argument_order_ijk{
    .code = "MAC405",
    .name = "argument-order-ijk",
    .summary =
        "I, J and K of a macro call do not stand in this order, so one of them arrives in another variable",
    .why =
        "I, J and K come in sets. A letter that does not follow the one before it in the alphabet begins the "
        "next set: K1. I2. gives #6 and #7, and #4 stays vacant. Only a parameter (6008#7) ends that.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::macro_calls},
    .yields_to = "MAC470",
    .messages =
        {{"read",
          "Argument in the wrong order: '{0}' stands behind '{1}', begins a second set and arrives as {2}, "
          "but {3} reads {4}.",
          "Write I, J and K in this order."},
         {"unknown",
          "Arguments out of order: '{0}' stands behind '{1}', begins a second set and arrives as {2}, "
          "not as {4}.",
          "Write I, J and K in this order, if no second set is meant.", true}},
    .bad = {{"fanuc", R"nc(
O0405(PLATE)
G65 P9405 K1. I2.
M30
O9405(SLOT, I K)
IF[#4EQ#0]THEN #4=10.
G1 X#4 Z-#6 F200.
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O0405(PLATE)
G65 P9405 I2. K1.
G65 P9406 K1. I2.
M30
O9405(SLOT, I K)
IF[#4EQ#0]THEN #3000=1(I MISSING)
G1 X#4 Z-#6 F200.
M99
O9406(TWO SETS)
G1 X#7 Z-#6 F200.
M99
)nc"}},
    .sources = {"CNCWIKI-ARG", "ZAPP-ARG"},
    .check = &check,
};

namespace {

/// The letters of the sets that stand behind the code, each once: then no sets are meant.
std::vector<const Word*> letters_once(const ControlModel& control, const queries::CallInBlock& call) {
    std::vector<const Word*> letters;
    for (const Word& word : call.after()) {
        const auto& sets = control.repeatable_arguments;
        if (!word.has_value() || std::ranges::find(sets, word.address) == sets.end()) continue;
        const auto same = [&](const Word* other) { return other->address == word.address; };
        if (std::ranges::any_of(letters, same)) return {};
        letters.push_back(&word);
    }
    return letters;
}

/// Whether the program reads the variable as a call gives it.
bool reads(const ProgramAnalysis& called, Variable variable) {
    return std::ranges::count(called.liveness().live_before(0), variable) != 0;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const ControlModel& control = analysis.control();
    for (const queries::CallInBlock& call : queries::calls_with_words(analysis)) {
        if (!call.passes_arguments()) continue;
        const std::vector<const Word*> letters = letters_once(control, call);
        const CallSite* site = analysis.call_at(call.effect);
        const ProgramAnalysis* called = site == nullptr ? nullptr : queries::called_program(analysis, *site);
        for (std::size_t i = 1; i < letters.size(); ++i) {
            const Argument* argument = queries::argument_of(program, call, *letters[i]);
            const Variable* given = argument == nullptr ? nullptr : std::get_if<Variable>(&argument->given);
            const auto formal = std::ranges::find(control.formal_letters, letters[i]->address.front());
            if (given == nullptr || formal == control.formal_letters.end()) continue;
            const Variable meant =
                control.formals[static_cast<std::size_t>(formal - control.formal_letters.begin())];
            if (*given == meant) continue;
            if (called != nullptr && (!reads(*called, meant) || reads(*called, *given))) continue;
            const Span span = letters[i]->span;
            reporter.report(
                {analysis, call.effect}, span, called != nullptr ? "read" : "unknown",
                {quoted(program, span), quoted(program, letters[i - 1]->span), program.spell(*given),
                 called != nullptr ? called->program().name : std::string(), program.spell(meant)});
            break;
        }
    }
}

} // namespace
} // namespace maclint::rules
