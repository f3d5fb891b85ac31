//! MAC402: a call of a program that is not there.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule program_not_found{
    .code = "MAC402",
    .name = "program-not-found",
    .aliases = "DIN503",
    .summary = "The called program is not among the programs of the control",
    .why = "The control stops with an alarm at the call, with the tool where it happens to be. Programs that "
           "stay on the control are not in every folder, so the rule speaks only where the configuration "
           "declares the folder complete.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = false,
    .messages = {{"plain", "'{0}' calls a program that is not among the programs of this control. Add it, or "
                           "correct the call."}},
    .bad = {{"fanuc",
             "O9402(MAIN)\n"
             "G65P9101\n"
             "M30\n",
             true},
            {"dinplus",
             "MACHINING\n"
             "N10 L\"CHAMFER\" LA50\n"
             "N20 M30\n"
             "END\n",
             true}},
    .also = {},
    .good = {{"fanuc", "O9402(MAIN)\n"
                       "M30\n"},
             {"dinplus",
              "MACHINING\n"
              "N10 L\"CHAMFER\" LA50\n"
              "N20 M30\n"
              "SUBPROGRAM \"CHAMFER\"\n"
              "N30 G0 X#__la\n"
              "RETURN\n"
              "END\n",
              true}},
    .alarms = {{"FANUC 16i/18i/21i", "078", "NUMBER NOT FOUND"},
               {"FANUC 30i/0i-D", "076", "PROGRAM NOT FOUND"}},
    .sources = {"GH-ALM"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    if (!analysis.workspace().complete()) return;
    const Program& program = analysis.program();
    for (const CallSite& site : analysis.calls()) {
        const auto& call = std::get<Call>(program.effects[site.effect].what);
        const auto* number = std::get_if<ExpressionId>(&call.program);
        const bool named = std::holds_alternative<Text>(call.program) ||
                           (number != nullptr && flow::constant_target(program, *number));
        if (!named || site.candidates != 0) continue;
        const Span span = program.effects[site.effect].span;
        reporter.report(analysis.file(), span, "plain", {quoted(program, span)});
    }
}

} // namespace
} // namespace maclint::rules
