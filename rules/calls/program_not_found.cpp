//! MAC402: a call of a program that is not there.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/names/unknown_names.hpp"
#include "analyzer/queries/structure/sections.hpp"
#include "analyzer/source/budget.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>

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
           "declares the folder complete, or where the call means a program of the same file.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .messages = {{"plain",
                  "Program not found: '{0}' calls a program that is not among the programs of this control.",
                  "Add it, or correct the call."}},
    .bad = {{"fanuc",
             R"nc(
O9402(MAIN)
G65P9101
M30
)nc",
             true},
            {"dinplus", R"nc(
MACHINING
N10 L"CHAMFER" LA50
N20 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9402(MAIN)
M30
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 L"CHAMFER" LA50
N20 M30
SUBPROGRAM "CHAMFER"
N30 G0 X#__la
RETURN
END
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "078", "NUMBER NOT FOUND"},
               {"FANUC 30i/0i-D", "076", "PROGRAM NOT FOUND"},
               {"SINUMERIK", "14011", "program does not exist or is being edited", false},
               {"SINUMERIK", "12550", "name not defined, or option or function not available", false}},
    .sources = {"GH-ALM"},
    .check = &check,
};

namespace {

/// The file holds a program up to its last word, and so all that belongs to it.
bool is_closed(const ProgramAnalysis& analysis) {
    return any_within_budget(analysis.file().programs, [](const Program& program) {
        return queries::has_section(program, SectionKind::Role::end);
    });
}

/// Whether all programs that the call may mean are there.
bool knows_all(const ProgramAnalysis& analysis, const Call& call) {
    const bool in_file = analysis.control().calls[call.kind].lookup == LookupScope::same_file;
    return analysis.complete() || (in_file && is_closed(analysis));
}

/// A name that is told as a slip, that somebody lists or defines, or that the control brings a program of.
bool is_excused(const ProgramAnalysis& analysis, const Text& written) {
    const std::string_view name = analysis.program().slice(written.characters);
    return queries::is_misspelt_at(analysis, written.characters) ||
           queries::is_brought_by_control(analysis.control(), name) ||
           analysis.names_elsewhere().contain(in_capitals(name));
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const CallSite& site : analysis.calls()) {
        const Call& call = queries::call_of(program, site.effect);
        const auto* number = std::get_if<ExpressionId>(&call.program);
        const bool named = std::holds_alternative<Text>(call.program) ||
                           (number != nullptr && flow::constant_number(program, *number));
        if (!named || site.candidates != 0 || !knows_all(analysis, call)) continue;
        if (const auto* written = std::get_if<Text>(&call.program);
            written != nullptr && is_excused(analysis, *written))
            continue;
        const Span span = program.effects[site.effect].span;
        reporter.report({analysis, site.effect}, span, "plain", {quoted(program, span)});
    }
}

} // namespace
} // namespace maclint::rules
