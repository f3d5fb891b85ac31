//! SIN407: arguments for a program that has no PROC.
#include "analyzer/queries/calls/given_arguments.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule arguments_without_proc{
    .code = "SIN407",
    .name = "arguments-without-proc",
    .summary = "A call gives arguments to a program without PROC",
    .why = "Only a program with PROC takes arguments: the control stops with an alarm at the call.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"none", "Arguments for nothing: {1}, which '{0}' calls, has no PROC.",
                  "Give it a PROC with its parameters, or remove the arguments."}},
    .bad = {{"sinumerik", R"nc(
%_N_MAIN_MPF
SLOT(40,-5)
M30
%_N_SLOT_SPF
G0 X=R1
M17
)nc"}},
    .good = {{"sinumerik", R"nc(
%_N_MAIN_MPF
R1=40
SLOT
M30
%_N_SLOT_SPF
G0 X=R1
M17
)nc"}},
    .alarms = {{"SINUMERIK", "14510", "PROC missing though parameters are passed", false}},
    .sources = {"NCP19 p.494"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    queries::for_each_known_call(analysis, [&](const CallSite& site, const Call& call, const auto& called) {
        const bool is_program = called.program().started != Program::Started::unknown;
        if (call.arguments.count == 0 || !is_program || !called.program().definition.empty() ||
            called.program().parameters_unknown)
            return;
        const Span span = program.effects[site.effect].span;
        reporter.report({analysis, site.effect}, span, "none",
                        {quoted(program, span), called.program().name});
    });
}

} // namespace
} // namespace maclint::rules
