//! SIN403: a call that ends before the last parameter.
#include "analyzer/queries/calls/given_arguments.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule fewer_arguments{
    .code = "SIN403",
    .name = "fewer-arguments",
    .summary = "A call gives fewer arguments than the program has parameters, which asks for none of them",
    .why =
        "What is left out arrives as 0. A program that means that to happen gives the parameter a default, or"
        " asks by $P_SUBPAR whether it was passed.",
    .severity = Severity::note,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"fewer", "Fewer arguments: '{0}' leaves out {2} of {1}, which arrives as 0.",
                  "Pass it, or give the parameter a default."}},
    .bad = {{"sinumerik", R"nc(
%_N_MAIN_MPF
SLOT(40)
M30
%_N_SLOT_SPF
PROC SLOT(REAL WIDTH, REAL DEPTH)
G0 X=WIDTH Z=-DEPTH
M17
)nc"}},
    .good = {{"sinumerik", R"nc(
%_N_MAIN_MPF
SLOT(40,5)
SLOT(40,)
GROOVE(40)
M30
%_N_SLOT_SPF
PROC SLOT(REAL WIDTH, REAL DEPTH)
G0 X=WIDTH Z=-DEPTH
M17
%_N_GROOVE_SPF
PROC GROOVE(REAL WIDTH, REAL DEPTH)
IF $P_SUBPAR[2]==FALSE
DEPTH=3
ENDIF
G0 X=WIDTH Z=-DEPTH
M17
)nc"}},
    .sources = {"NCP19 p.494"},
    .check = &check,
};

namespace {

/// Places that the call has: commas count, too.
std::size_t places_of(const Program& program, const Call& call, Span whole) {
    const auto arguments = program.arguments_of(call);
    if (arguments.empty()) return 0;
    const auto& last = std::get<ArgumentPosition>(arguments.back().given);
    const std::string_view behind = program.slice({arguments.back().span.end, whole.end});
    return last.number + 1 + static_cast<std::size_t>(std::ranges::count(behind, ','));
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    queries::for_each_known_call(analysis, [&](const CallSite& site, const Call& call, const auto& called) {
        const Span span = program.effects[site.effect].span;
        const auto& formals = called.program().formals;
        const std::size_t given = places_of(program, call, span);
        if (given == 0 || given >= formals.size()) return; // a call without any means to leave them out
        const Formal& missing = formals[given];
        if (missing.has_default || missing.passing == Passing::by_reference || missing.type == "AXIS") return;
        reporter
            .report({analysis, site.effect}, span, "fewer",
                    {quoted(program, span), called.program().name, missing.name})
            .related.push_back({called.source(), missing.span, "the parameter is defined here"});
    });
}

} // namespace
} // namespace maclint::rules
