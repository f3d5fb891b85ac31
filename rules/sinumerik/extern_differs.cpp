//! SIN405: EXTERN tells other parameters than the program has.
#include "analyzer/queries/calls/given_arguments.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <set>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule extern_differs{
    .code = "SIN405",
    .name = "extern-differs",
    .summary = "EXTERN tells other parameters than the program has",
    .why = "The control holds EXTERN against the PROC of the program, and stops with an alarm.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"count", "Other number of parameters: '{0}' tells {1}, and {2} has {3}.",
                  "Write it as PROC does."},
                 {"type", "Other parameter: '{0}' tells {1} at place {4}, and {2} has {3}.",
                  "Write it as PROC does."}},
    .bad = {{"sinumerik", R"nc(
%_N_MAIN_MPF
EXTERN RING(REAL,INT)
RING(20,3)
M30
%_N_RING_SPF
PROC RING(REAL DIAM_, REAL DEPTH)
G0 X=DIAM_ Z=DEPTH
M17
)nc"}},
    .good = {{"sinumerik", R"nc(
%_N_MAIN_MPF
EXTERN RING(REAL,REAL)
RING(20,3)
M30
%_N_RING_SPF
PROC RING(REAL DIAM_, REAL DEPTH)
G0 X=DIAM_ Z=DEPTH
M17
)nc"}},
    .alarms = {{"SINUMERIK", "14530", "EXTERN and PROC differ", false}},
    .sources = {"NCP19 p.494", "JP10 p.23"},
    .check = &check,
};

namespace {

std::string words_for(std::string_view type, Passing passing, bool is_array) {
    return (passing == Passing::by_reference ? "VAR " : "") + std::string(type) + (is_array ? "[ ]" : "");
}

void compare(const ProgramAnalysis& analysis, const ExternalDeclaration& declared,
             const ProgramAnalysis& called, Reporter& reporter) {
    const std::string written = quoted(analysis.program(), declared.span);
    const auto& formals = called.program().formals;
    const auto& told = declared.parameters;
    const auto report = [&](std::string_view message, std::vector<std::string> arguments) {
        reporter.report({analysis, declared.span}, declared.span, message, std::move(arguments))
            .related.push_back({called.source(), called.program().definition, "the program is defined here"});
    };
    if (told.size() != formals.size())
        return report("count", {written, std::to_string(told.size()), called.program().name,
                                std::to_string(formals.size())});
    for (std::size_t i = 0; i < told.size(); ++i) {
        const std::string there = words_for(formals[i].type, formals[i].passing, formals[i].is_array);
        const std::string here = words_for(told[i].type, told[i].passing, told[i].is_array);
        if (here != there)
            return report("type", {written, here, called.program().name, there, std::to_string(i + 1)});
    }
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    if (program.externals.empty()) return;
    std::set<const ExternalDeclaration*> told;
    queries::for_each_known_call(analysis, [&](const CallSite&, const Call&, const auto& called) {
        if (called.program().definition.empty()) return;
        const auto declared =
            std::ranges::find(program.externals, called.program().name, &ExternalDeclaration::name);
        if (declared != program.externals.end() && told.insert(&*declared).second)
            compare(analysis, *declared, called, reporter);
    });
}

} // namespace
} // namespace maclint::rules
