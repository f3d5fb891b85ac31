//! MAC472: a call gives more arguments than the program takes, or a value where it takes a variable.
#include "analyzer/queries/calls/given_arguments.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule argument_without_parameter{
    .code = "MAC472",
    .name = "argument-without-parameter",
    .summary =
        "A call gives more arguments than the program has parameters, or no variable where it wants one",
    .why = "The control cannot hand the argument over, and stops with an alarm at the call.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"too-many", "Argument without a parameter: '{0}' is number {1}, and {2} takes {3}.",
                  "Remove it, or add the parameter to {2}."},
                 {"no-variable",
                  "No variable to store in: {2} gives a value back by parameter {1}, and '{0}' is none.",
                  "Give it a variable."}},
    .bad = {{"sinumerik", R"nc(
%_N_MAIN_MPF
SLOT(40,-5,0.5)
M30
%_N_SLOT_SPF
PROC SLOT(REAL WIDTH, REAL DEPTH)
G0 X=WIDTH Z=DEPTH
M17
)nc"},
            {"sinumerik", R"nc(
%_N_MAIN_MPF
COUNT_UP(3)
M30
%_N_COUNT_UP_SPF
PROC COUNT_UP(VAR INT TOTAL)
TOTAL=TOTAL+1
M17
)nc"}},
    .good = {{"sinumerik", R"nc(
%_N_MAIN_MPF
DEF INT HOLES
SLOT(40,-5)
COUNT_UP(HOLES)
M30
%_N_SLOT_SPF
PROC SLOT(REAL WIDTH, REAL DEPTH)
G0 X=WIDTH Z=DEPTH
M17
%_N_COUNT_UP_SPF
PROC COUNT_UP(VAR INT TOTAL)
TOTAL=TOTAL+1
M17
)nc"}},
    .alarms = {{"SINUMERIK", "12340", "too many parameters in the call", false},
               {"SINUMERIK", "12320", "parameter is no variable", false}},
    .sources = {"NCP19 p.494", "JP10 p.23"},
    .check = &check,
};

namespace {

/// What is surely no variable: a number, a text, a calculation.
bool is_value(const Program& program, ExpressionId id) {
    const auto& node = program.expressions[id].node;
    const auto* apply = std::get_if<Apply>(&node);
    const bool calculated = apply != nullptr && apply->operation != Operation::unknown;
    return std::holds_alternative<Literal>(node) || std::holds_alternative<Text>(node) || calculated;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    queries::for_each_known_call(analysis, [&](const CallSite& site, const Call& call, const auto& analysed) {
        const Program& called = analysed.program();
        if (called.definition.empty()) return; // it has no PROC line
        for (const Argument& argument : program.arguments_of(call)) {
            const auto* place = std::get_if<ArgumentPosition>(&argument.given);
            if (place == nullptr) continue;
            const std::string number = std::to_string(place->number + 1);
            if (place->number >= called.formals.size()) {
                reporter.report({analysis, site.effect}, argument.span, "too-many",
                                {quoted(program, argument.span), number, called.name,
                                 std::to_string(called.formals.size())});
                return;
            }
            const bool wanted = called.formals[place->number].passing == Passing::by_reference;
            if (wanted && is_value(program, argument.value))
                reporter.report({analysis, site.effect}, argument.span, "no-variable",
                                {quoted(program, argument.span), number, called.name});
        }
    });
}

} // namespace
} // namespace maclint::rules
