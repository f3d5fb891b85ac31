//! SIN412: a drilling cycle whose planes and depth contradict each other.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/sinumerik/cycles.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <optional>
#include <string_view>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule cycle_planes{
    .code = "SIN412",
    .name = "cycle-planes-contradict",
    .summary = "The depth of a drilling cycle lies on the side to which the tool is drawn back",
    .why =
        "The tool drills away from the plane to which it is drawn back (RTP), from the reference plane (RFP) "
        "to the depth (DP). Where the depth lies on the side of RTP the cycle stops with an alarm: mostly "
        "the sign of the depth is lost.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::paired_words},
    .messages = {{"depth",
                  "Depth on the wrong side: '{0}' begins at {1} and goes to {2}, and is drawn back to {3}.",
                  "Correct the depth, or one of the two planes."}},
    .bad = {{"sinumerik", R"nc(
G17 G90 G54
G0 X10 Y10 Z50
CYCLE82(50,0,2,20,,0.3)
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
G17 G90 G54
G0 X10 Y10 Z50
CYCLE82(50,0,2,-20,,0.3)
CYCLE82(50,0,2,,20,0.3)
M30
)nc"}},
    .sources = {"T: alarm 61101", "SCYC"},
    .check = &check,
};

namespace {

/// The number that stands there as the argument; nothing where it is left out or calculated.
std::optional<double> argument(const Program& program, const Call& call, const sinumerik::CycleRow& cycle,
                               std::string_view parameter) {
    const auto place = sinumerik::place_of_parameter(cycle, parameter);
    if (!place) return std::nullopt;
    for (const Argument& given : program.arguments_of(call)) {
        const auto* position = std::get_if<ArgumentPosition>(&given.given);
        if (position == nullptr || position->number != *place) continue;
        const auto* literal = std::get_if<Literal>(&program.expressions[given.value].node);
        if (literal != nullptr) return literal->value;
    }
    return std::nullopt;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const CallSite& site : analysis.calls()) {
        const auto* call = std::get_if<Call>(&program.effects[site.effect].what);
        const auto* name = call == nullptr ? nullptr : std::get_if<Text>(&call->program);
        if (name == nullptr || site.candidates != 0) continue; // the shop has a program of the name
        const auto* cycle = sinumerik::find_cycle(in_capitals(program.slice(name->characters)));
        if (cycle == nullptr) continue;
        const auto back = argument(program, *call, *cycle, "RTP"),
                   from = argument(program, *call, *cycle, "RFP"),
                   depth = argument(program, *call, *cycle, "DP");
        if (!back || !from || !depth || *back == *from || (*back > *from) == (*depth < *from)) continue;
        const Span span = program.effects[site.effect].span;
        reporter.report({analysis, site.effect}, span, "depth",
                        {quoted(program, span), number_word(*from), number_word(*depth), number_word(*back)});
    }
}

} // namespace
} // namespace maclint::rules
