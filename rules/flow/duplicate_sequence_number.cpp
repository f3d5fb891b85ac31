//! MAC462: two blocks with one number that something jumps to.
#include "analyzer/program/numbered_blocks.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string>
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

/// The label that the jump takes, where it is a plain one.
const flow::LabelledBlock* taken_by(const ProgramAnalysis& analysis, EffectId jump) {
    const auto& jumps = analysis.graph().jumps;
    const auto found = std::ranges::find(jumps, jump, &flow::ResolvedJump::jump);
    return found == jumps.end() || !found->target ? nullptr : &*found->target;
}

/// One finding for all blocks of a number, at the second of them.
void report(const ProgramAnalysis& analysis, Reporter& reporter, std::int64_t number,
            std::span<const Span> blocks, EffectId user) {
    const Span span = analysis.program().effects[user].span;
    std::vector<std::string> words{std::to_string(number), quoted(analysis.program(), span),
                                   blocks.size() == 2 ? "twice" : std::to_string(blocks.size()) + " times"};
    std::string_view message = "plain";
    if (const flow::LabelledBlock* taken = taken_by(analysis, user)) {
        words.push_back(line_number(analysis.file(), taken->span.begin));
        message = taken->span.begin > span.begin ? "after" : "from-the-top";
    }
    Finding& finding = reporter.report({analysis, blocks[1]}, blocks[1], message, std::move(words));
    for (std::size_t i = 0; i < blocks.size(); ++i)
        if (i != 1) finding.related.push_back({analysis.source(), blocks[i], "the same number stands here"});
    finding.related.push_back(related_at_effect(analysis, user, "this leads to it"));
}

/// Blocks of the sections in which a reference or a restart is looked for.
void check_references(const ProgramAnalysis& analysis, Reporter& reporter) {
    using Wanted = std::pair<std::int64_t, SectionKind::Role>;
    std::map<Wanted, EffectId> users;
    std::set<std::int64_t> numbers;
    for (const BlockUser& user : find_block_users(analysis.program())) {
        users.emplace(Wanted(user.number, user.target), user.effect);
        numbers.insert(user.number);
    }
    std::map<Wanted, std::vector<Span>> found;
    for (const NumberedBlock& block : find_blocks(analysis.file(), numbers)) {
        if (block.section == nullptr) continue;
        const Wanted wanted(block.number, block.section->role);
        if (users.contains(wanted)) found[wanted].push_back(block.number_span);
    }
    for (const auto& [wanted, blocks] : found)
        if (blocks.size() > 1) report(analysis, reporter, wanted.first, blocks, users.at(wanted));
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    check_references(analysis, reporter);
    const auto& labels = analysis.graph().labels; // equal ones stand together
    for (auto first = labels.begin(); first != labels.end();) {
        const Label label = first->label;
        std::vector<Span> blocks;
        for (; first != labels.end() && first->label == label; ++first) blocks.push_back(first->span);
        const auto* number = std::get_if<std::int64_t>(&label);
        if (number == nullptr || blocks.size() == 1) continue;
        if (const auto user = analysis.user_of_label(label))
            report(analysis, reporter, *number, blocks, *user);
    }
}

} // namespace
} // namespace maclint::rules
