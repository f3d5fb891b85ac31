//! MAC462: two blocks with one number that something jumps to.
#include "analyzer/queries/repeated_numbers.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <cstddef>
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
    .why = "Which of the two the control finds depends on where its search starts: the same jump"
           " goes to different places from different blocks.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .needs = {Capability::sequence_numbers},
    .messages = {{"after",
                  "N{0} stands {2}, and '{1}' takes the one in line {3}, the next after it. Give each block "
                  "a number of its own."},
                 {"from-the-top",
                  "N{0} stands {2}, and '{1}' takes the one in line {3}, the first of the program, as "
                  "none is after it. Give each block a number of its own."},
                 {"plain",
                  "N{0} stands {2}, and '{1}' leads to it: which block is taken depends on where the search "
                  "starts. Give each block a number of its own."}},
    .bad = {{"fanuc", R"nc(
O9462(TWO)
IF[#100EQ1]GOTO20
N20 G0 X1.
N20 G0 X2.
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
IF[#100EQ1]GOTO20
N20 G0 X1.
N30 G0 X2.
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
    .sources = {"ISORP", "T: search order"},
    .check = &check,
};

namespace {

/// One finding for all blocks of a number, at the second of them.
void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const queries::RepeatedNumber& repeated : queries::find_repeated_numbers(analysis)) {
        const auto& blocks = repeated.blocks;
        const Span span = analysis.program().effects[repeated.user].span;
        std::vector<std::string> words{std::to_string(repeated.number), quoted(analysis.program(), span),
                                       blocks.size() == 2 ? "twice"
                                                          : std::to_string(blocks.size()) + " times"};
        std::string_view message = "plain";
        if (repeated.taken) {
            words.push_back(line_number(analysis.file(), repeated.taken->begin));
            message = repeated.taken->begin > span.begin ? "after" : "from-the-top";
        }
        Finding& finding = reporter.report({analysis, blocks[1]}, blocks[1], message, std::move(words));
        for (std::size_t i = 0; i < blocks.size(); ++i)
            if (i != 1)
                finding.related.push_back({analysis.source(), blocks[i], "the same number stands here"});
        finding.related.push_back(related_at_effect(analysis, repeated.user, "this leads to it"));
    }
}

} // namespace
} // namespace maclint::rules
