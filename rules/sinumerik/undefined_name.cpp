//! SIN202: a name that is defined nowhere.
#include "analyzer/queries/calls/given_arguments.hpp"
#include "analyzer/queries/names/unknown_names.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <set>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule undefined_name{
    .code = "SIN202",
    .name = "undefined-name",
    .summary = "A value is read by a name that neither the program nor a file of definitions defines",
    .why =
        "The control stops with an alarm at the block. What a machine's maker defines is in no program, so "
        "the rule speaks only where a file of definitions (.DEF) lies by the program, the configuration "
        "lists `known-names`, or declares the folder complete.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"plain",
                  "Name that is defined nowhere: '{0}' is no variable of this program, and no file of "
                  "definitions gives it.",
                  "Define it, or list it under 'known-names' in .maclint.json if the machine has it."}},
    .bad = {{"sinumerik", R"nc(
DEF REAL DEPTH=5
G0 X0 Y0
G1 Z=-DEPTH F=FEED_DOWN
M30
)nc",
             true}},
    .good = {{"sinumerik", R"nc(
DEF REAL DEPTH=5, FEED_DOWN=100
G0 X0 Y0
G1 Z=-DEPTH F=FEED_DOWN
M30
)nc",
              true}},
    .alarms = {{"SINUMERIK", "12550", "name not defined, or option or function not available"}},
    .sources = {"NCP19 p.404", "T: alarm 12550"},
    .check = &check,
};

namespace {

/// Beginnings of arguments for parameters that take an axis: the machine names its axes and spindles.
std::set<Offset> arguments_for_axes(const ProgramAnalysis& analysis) {
    std::set<Offset> found;
    queries::for_each_known_call(analysis, [&](const CallSite&, const Call& call, const auto& called) {
        const auto& formals = called.program().formals;
        for (std::size_t i = 0; i < formals.size(); ++i)
            if (const Argument* argument = queries::argument_at(analysis.program(), call, i);
                argument != nullptr && formals[i].type == "AXIS")
                found.insert(argument->span.begin);
    });
    return found;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    if (analysis.program().unknown_names.empty()) return;
    const std::set<Offset> axes = arguments_for_axes(analysis);
    for (const UnknownName& name : analysis.program().unknown_names)
        if (queries::is_undefined(analysis, name) && !queries::is_g_code(name) &&
            !axes.contains(name.span.begin))
            reporter.report({analysis.file(), name.span}, name.span, "plain",
                            {std::string(analysis.program().slice(name.span))});
}

} // namespace
} // namespace maclint::rules
