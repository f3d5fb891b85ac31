//! SIN404: a variable of another type for a parameter that gives a value back.
#include "analyzer/queries/calls/given_arguments.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <string>
#include <string_view>
#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule reference_needs_variable{
    .code = "SIN404",
    .name = "reference-needs-variable",
    .summary = "A parameter that gives a value back gets a variable of another type",
    .why =
        "The program works in the variable of its caller, which must have exactly the type of the parameter: "
        "the control stops with an alarm at the call.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"type",
                  "Variable of another type: '{0}' is {1}, and parameter {2} ({3}) of {4} is VAR {5}.",
                  "Define '{0}' as {5}, or pass another variable."}},
    .bad = {{"sinumerik", R"nc(
%_N_MAIN_MPF
DEF REAL HOLES
COUNT_UP(HOLES)
M30
%_N_COUNT_UP_SPF
PROC COUNT_UP(VAR INT TOTAL)
TOTAL=TOTAL+1
M17
)nc"},
            {"sinumerik", R"nc(
%_N_MAIN_MPF
DEF INT HOLES[4]
COUNT_UP(HOLES)
M30
%_N_COUNT_UP_SPF
PROC COUNT_UP(VAR INT TOTAL)
TOTAL=TOTAL+1
M17
)nc"}},
    .good = {{"sinumerik", R"nc(
%_N_MAIN_MPF
DEF INT HOLES
COUNT_UP(HOLES)
M30
%_N_COUNT_UP_SPF
PROC COUNT_UP(VAR INT TOTAL)
TOTAL=TOTAL+1
M17
)nc"}},
    .alarms = {{"SINUMERIK", "12330", "type of parameter wrong", false}},
    .sources = {"NCP19 p.494", "JP10 p.23"},
    .check = &check,
};

namespace {

std::string spelled(std::string_view type, bool is_array) {
    return (is_array ? "an array of " : "") + std::string(type);
}

/// "REAL", "an array of REAL"; empty where the argument is no variable, or nobody knows its type.
std::string type_of_variable(const ProgramAnalysis& analysis, const Argument& argument) {
    if (const ArrayDefinition* array = queries::array_given(analysis, argument))
        return spelled(array->type, true);
    const auto& node = analysis.program().expressions[argument.value].node;
    const bool is_value = std::holds_alternative<Literal>(node) || std::holds_alternative<Text>(node);
    return is_value ? "" : std::string(queries::type_given(analysis, argument));
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    queries::for_each_known_call(analysis, [&](const CallSite& site, const Call& call, const auto& called) {
        const auto& formals = called.program().formals;
        for (std::size_t i = 0; i < formals.size(); ++i) {
            const Formal& formal = formals[i];
            const Argument* argument = queries::argument_at(program, call, i);
            if (argument == nullptr || formal.passing != Passing::by_reference) continue;
            const std::string given = type_of_variable(analysis, *argument);
            const std::string wanted = spelled(formal.type, formal.is_array);
            if (given.empty() || given == wanted) continue;
            reporter
                .report({analysis, site.effect}, argument->span, "type",
                        {quoted(program, argument->span), given, std::to_string(i + 1), formal.name,
                         called.program().name, wanted})
                .related.push_back({called.source(), formal.span, "the parameter is defined here"});
        }
    });
}

} // namespace
} // namespace maclint::rules
