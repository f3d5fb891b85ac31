//! SIN402: a call leaves out a parameter that needs a variable or an axis.
#include "analyzer/queries/calls/given_arguments.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule missing_reference_argument{
    .code = "SIN402",
    .name = "missing-reference-argument",
    .summary = "A call leaves out a parameter that gives a value back, or that is an axis",
    .why =
        "A parameter that is left out arrives as 0, but for those with VAR and those of an axis: the control"
        " has nothing to put there, and stops with an alarm at the call.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"variable", "Missing variable: {1} gives a value back by its parameter {2} ({3}).",
                  "Give it a variable."},
                 {"axis", "Missing axis: parameter {2} ({3}) of {1} may not be left out.",
                  "Give it an axis."}},
    .bad = {{"sinumerik", R"nc(
%_N_MAIN_MPF
DEF INT HOLES
DRILL(5)
M30
%_N_DRILL_SPF
PROC DRILL(REAL DEPTH, VAR INT TOTAL)
G0 Z=-DEPTH
TOTAL=TOTAL+1
M17
)nc"}},
    .good = {{"sinumerik", R"nc(
%_N_MAIN_MPF
DEF INT HOLES
DRILL(5,HOLES)
DRILL(,HOLES)
M30
%_N_DRILL_SPF
PROC DRILL(REAL DEPTH, VAR INT TOTAL)
G0 Z=-DEPTH
TOTAL=TOTAL+1
M17
)nc"}},
    .alarms = {{"SINUMERIK", "12300", "call-by-reference parameter missing in the call", false},
               {"SINUMERIK", "12310", "axis parameter missing in the call", false}},
    .sources = {"NCP19 p.494"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    queries::for_each_known_call(analysis, [&](const CallSite& site, const Call& call, const auto& called) {
        const auto& formals = called.program().formals;
        for (std::size_t i = 0; i < formals.size(); ++i) {
            const Formal& formal = formals[i];
            const bool variable = formal.passing == Passing::by_reference;
            const bool needed = variable || formal.type == "AXIS";
            if (!needed || formal.has_default || queries::argument_at(program, call, i) != nullptr) continue;
            const Span span = program.effects[site.effect].span;
            reporter
                .report({analysis, site.effect}, span, variable ? "variable" : "axis",
                        {quoted(program, span), called.program().name, std::to_string(i + 1), formal.name})
                .related.push_back({called.source(), formal.span, "the parameter is defined here"});
            return;
        }
    });
}

} // namespace
} // namespace maclint::rules
