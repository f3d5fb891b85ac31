//! MAC412: a program that calls itself.
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <string>
#include <utility>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule recursive_call{
    .code = "MAC412",
    .name = "recursive-call",
    .aliases = "DIN502",
    .summary = "A program calls itself, directly or through others",
    .why = "Every round takes one call level, and the control has few: it stops with a nesting "
           "alarm after some rounds.",
    .severity = Severity::error,
    .severity_elsewhere = {{"dinplus", Severity::warning}},
    .precision = Precision::high,
    .data_flow = true,
    .messages = {{"plain",
                  "Recursive call: '{0}' calls {1} again, from which it was called ({2}), until the control "
                  "runs out of call levels.",
                  "Use a loop."},
                 {"self",
                  "Recursive call: '{0}' calls {1}, the very program it stands in, until the control runs "
                  "out of call levels.",
                  "Use a loop, or give this program another number when another one is meant."}},
    .bad = {{"fanuc", R"nc(
O0001(MAIN)
G65P9412
M30
O9412(STEP)
G65P9413
M99
O9413(BACK)
G65P9412
M99
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 L"HALF" LA10
N20 M30
SUBPROGRAM "HALF"
N30 #l1=#__la/2
N40 G1 Z#l1
N50 L"HALF" LA#l1
RETURN
END
)nc"}},
    .good = {{"fanuc", R"nc(
O0001(MAIN)
G65P9412
M30
O9412(STEP)
G65P9413
M99
O9413(BACK)
M99
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 #l1=10
N20 WHILE #l1>0.4
N30 #l1=#l1/2
N40 G1 Z#l1
N50 ENDWHILE
N60 M30
END
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "077", "SUB PROGRAM NESTING ERROR"},
               {"FANUC 16i/18i/21i", "122", "FOUR FOLD MACRO MODAL-CALL"}},
    .sources = {"T: follows from the nesting limits"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const CallSite& site : analysis.calls()) {
        if (!site.closes_cycle) continue;
        const Span span = analysis.program().effects[site.effect].span;
        const ProgramAnalysis& callee = *queries::called_program(analysis, site);
        const CallPath circle = callee.path_to(analysis.index());
        const bool self = &callee == &analysis;
        std::vector<RelatedLocation> path;
        std::string words = callee.program().name;
        for (const Caller& call : circle.calls) {
            // Of a circle of more programs the first and the last are named.
            if (circle.length > CallPath::most && path.size() == CallPath::most / 2)
                words += " > " + std::to_string(circle.length - CallPath::most) + " more";
            const ProgramAnalysis& calling = queries::calling_program(analysis, call);
            words += " > " + queries::called_program(calling, *calling.call_at(call.effect))->program().name;
            path.push_back(related_at_effect(calling, call.effect, "calls the next program of the circle"));
        }
        if (!self && circle.calls.empty()) words += " > other programs > " + analysis.program().name;
        Finding& finding = reporter.report(
            {analysis, site.effect}, span, self ? "self" : "plain",
            {quoted(analysis.program(), span), callee.program().name, words + " > " + callee.program().name});
        finding.path = std::move(path);
        finding.path.push_back({analysis.source(), span, "calls " + callee.program().name + " again"});
    }
}

} // namespace
} // namespace maclint::rules
