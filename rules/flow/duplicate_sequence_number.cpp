//! MAC462: two blocks with one number that something jumps to.
#include "analyzer/queries/structure/repeated_numbers.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace maclint::rules {
namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule duplicate_sequence_number{
    .code = "MAC462",
    .name = "duplicate-sequence-number",
    .aliases = "DIN005",
    .summary = "Two blocks have one sequence number, and something jumps to it",
    .why = "The same jump goes to different places from different blocks, and nobody sees which. A note, on "
           "request, where each jump takes the next one.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .needs = {Capability::sequence_numbers},
    .messages =
        {{"passed-over",
          "Wrong block: {0} takes N{1} of line {2}, the first of the program, not that of line {3}.", "{4}."},
         {"unreached", "Wrong block: {0} takes N{1} of line {2}, and nothing leads to N{1} of line {3}.",
          "{4}."},
         {"after", "Sequence number N{1} is there more than once: {0} goes to line {2}, the next one.",
          "{4}.", true},
         {"in-other-part",
          "Wrong block: {0} leaves its part of the program for N{1} of line {2}, past the N{1} of line "
          "{3} in its own.",
          "{4}."},
         {"plain", "Sequence number N{1} is there more than once: {0} goes to one of them.", "{4}."}},
    .bad = {{"fanuc", R"nc(
O9462(TWO)
N20 G0 X1.
N20 G0 X2.
IF[#1000EQ1]GOTO20
M30
)nc"},
            {"dinplus", R"nc(
FINISHED
N1 G0 X0 Z0
N2 G1 X30
N2 G1 Z-20
MACHINING
N10 G810 NS2 NE2 P2
N20 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9462(TWO)
N10 G0 X1.
N20 G0 X2.
IF[#1000EQ1]GOTO20
M30
)nc"},
             {"dinplus", R"nc(
FINISHED
N1 G0 X0 Z0
N2 G1 X30
N3 G1 Z-20
MACHINING
N10 G810 NS2 NE3 P2
N20 M30
END
)nc"}},
    .exemptions = {{&queries::exemptions::computed_jump_beside_each,
                    "computed-jump-beside-each",
                    "The blocks were copied with the computed jump above them, which finds its own: a table "
                    "of texts in several languages.",
                    {"fanuc", R"nc(
O9462(TEXTS, A LANGUAGE B NUMBER)
IF[#1EQ2]GOTO50
GOTO[#2]
N1 #3006=1(OPEN THE DOOR)
GOTO99
N2 #3006=2(LOAD A PART)
GOTO99
N50 GOTO[#2]
N1 #3006=1(TUER OEFFNEN)
GOTO99
N2 #3006=2(TEIL LADEN)
N99 M99
)nc"}}},
    .sources = {"ISORP", "T: search order"},
    .check = &check,
};

namespace {

using queries::Doubling;
using queries::RepeatedNumber;

std::string_view message_for(const RepeatedNumber& repeated) {
    constexpr std::array<std::string_view, 5> messages = {"after", "passed-over", "unreached",
                                                          "in-other-part", "plain"};
    return repeated.taken ? messages[static_cast<std::size_t>(repeated.doubling)] : "plain";
}

void add_places(const ProgramAnalysis& analysis, const RepeatedNumber& repeated, Finding& finding) {
    for (const Span& block : repeated.blocks)
        if (block != finding.span)
            finding.related.push_back(
                {analysis.source(), block, "N" + std::to_string(repeated.number) + " stands here"});
    finding.related.push_back(related_at_effect(analysis, repeated.user, "this leads to it"));
}

/// Of numbers to which the same happens, the first one is spoken of.
void report(const ProgramAnalysis& analysis, const std::vector<RepeatedNumber>& alike, Reporter& reporter) {
    const RepeatedNumber& first = alike.front();
    const auto line = [&](std::optional<Span> span) {
        return line_number(analysis.file(), span.value_or(Span{}).begin);
    };
    std::string cure = "Give each block a number of its own";
    for (std::size_t i = 1; i < alike.size(); ++i)
        cure += (i == 1 ? " (also N" : ", N") + std::to_string(alike[i].number);
    if (alike.size() > 1) cure += ")";
    const Span jump = analysis.program().effects[first.user].span;
    const Span block = first.missed.value_or(first.blocks[1]);
    const bool at_jump = first.doubling == Doubling::passed_over || first.doubling == Doubling::in_other_part;
    const Span place = at_jump ? jump : block;
    Finding& finding =
        reporter.report({analysis, place}, place, message_for(first),
                        {"'" + quoted(analysis.program(), jump) + "' on line " + line(jump),
                         std::to_string(first.number), line(first.taken), line(first.missed), cure});
    if (first.doubling == Doubling::harmless) finding.severity = Severity::note;
    for (const RepeatedNumber& repeated : alike) add_places(analysis, repeated, finding);
}

/// One finding a program for all numbers that lead astray, else one for all that do not.
void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    std::vector<RepeatedNumber> astray, harmless;
    for (RepeatedNumber& repeated : queries::find_repeated_numbers(analysis)) {
        if (repeated.doubling == Doubling::referenced) report(analysis, {repeated}, reporter);
        if (repeated.doubling == Doubling::harmless) harmless.push_back(repeated);
        if (repeated.missed) astray.push_back(std::move(repeated));
    }
    if (!astray.empty()) harmless = std::move(astray);
    std::ranges::stable_sort(harmless, {}, &RepeatedNumber::doubling);
    if (!harmless.empty()) report(analysis, harmless, reporter);
}

} // namespace
} // namespace maclint::rules
