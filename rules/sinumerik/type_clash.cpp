//! SIN209: texts where numbers belong, numbers where texts belong.
#include "analyzer/queries/calls/given_arguments.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <string>
#include <string_view>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule type_clash{
    .code = "SIN209",
    .name = "type-clash",
    .summary = "A text is stored, passed or calculated with where a number belongs, or the other way round",
    .why =
        "Texts become numbers by NUMBER( ), and numbers texts by << alone: the control stops with an alarm.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"text", "Text for a number: '{0}' is given where {1} is wanted.",
                  "Give a number, or make one of the text with NUMBER( )."},
                 {"number", "Number for a text: '{0}' is given where {1} is wanted.",
                  "Make a text of it: \"\"<<{0}."},
                 {"mixed", "Text in a calculation: '{0}' takes a text for a number.",
                  "Join texts with <<, and make a number of a text with NUMBER( )."}},
    .bad = {{"sinumerik", R"nc(
DEF STRING[8] SIZE_="40"
R1=SIZE_*2
M30
)nc"},
            {"sinumerik", R"nc(
%_N_MAIN_MPF
DEF STRING[8] SIZE_="40"
RIM(SIZE_)
M30
%_N_RIM_SPF
PROC RIM(REAL DIAM_)
G0 X=DIAM_
M17
)nc"}},
    .good = {{"sinumerik", R"nc(
%_N_MAIN_MPF
DEF STRING[8] SIZE_="40"
MSG("Size "<<SIZE_)
R1=NUMBER(SIZE_)*2
RIM(R1)
M30
%_N_RIM_SPF
PROC RIM(REAL DIAM_)
G0 X=DIAM_
M17
)nc"}},
    .alarms = {{"SINUMERIK", "12150", "operation does not fit the data types", false},
               {"SINUMERIK", "12330", "type of parameter wrong", false}},
    .sources = {"NCP19 p.444"},
    .check = &check,
};

namespace {

constexpr std::string_view text_type = "STRING";

bool is_number(std::string_view type) { return type == "REAL" || type == "INT" || type == "BOOL"; }

std::string_view message_for(std::string_view wanted, std::string_view given) {
    if (is_number(wanted) && given == text_type) return "text";
    return wanted == text_type && is_number(given) ? "number" : "";
}

std::string_view message_for(SyntaxErrorKind kind) {
    switch (kind) {
    case SyntaxErrorKind::text_for_number: return "text";
    case SyntaxErrorKind::number_for_text: return "number";
    case SyntaxErrorKind::text_in_calculation: return "mixed";
    default: return "";
    }
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const SyntaxError& error : analysis.file().syntax_errors_in(program.span))
        if (const std::string_view message = message_for(error.kind); !message.empty())
            reporter.report({analysis, error.span}, error.span, message, {error.subject, error.cure});
    queries::for_each_known_call(analysis, [&](const CallSite& site, const Call& call, const auto& called) {
        const auto& formals = called.program().formals;
        for (std::size_t i = 0; i < formals.size(); ++i) {
            const Argument* argument = queries::argument_at(program, call, i);
            if (argument == nullptr || formals[i].passing == Passing::by_reference || formals[i].is_array)
                continue;
            const std::string_view message =
                message_for(formals[i].type, queries::type_given(analysis, *argument));
            if (message.empty()) continue;
            reporter
                .report({analysis, site.effect}, argument->span, message,
                        {quoted(program, argument->span), std::string(formals[i].type)})
                .related.push_back({called.source(), formals[i].span, "the parameter is defined here"});
        }
    });
}

} // namespace
} // namespace maclint::rules
