//! MAC462: two blocks with one number that something jumps to.
#include "analyzer/program/numbered_blocks.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

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
    .on_by_default = true,
    .off_reason = "",
    .data_flow = false,
    .messages =
        {{"taken",
          "N{0} stands twice, and '{1}' takes the one in line {2}, the next behind it. Give one of them "
          "another number."},
         {"plain", "N{0} stands twice, and '{1}' leads to it: which block is taken depends on where the "
                   "search starts. Give one of them another number."}},
    .bad = {{"fanuc", "O9462(TWO)\n"
                      "IF[#100EQ1]GOTO20\n"
                      "N20 G0 X1.\n"
                      "N20 G0 X2.\n"
                      "M30\n"},
            {"dinplus", "FINISHED\n"
                        "N1 G0 X0 Z0\n"
                        "N2 G1 X30\n"
                        "N2 G1 Z-20\n"
                        "MACHINING\n"
                        "N10 G810 NS2 NE2 P2\n"
                        "N20 M30\n"
                        "END\n"}},
    .also = {},
    .good = {{"fanuc", "O9462(TWO)\n"
                       "IF[#100EQ1]GOTO20\n"
                       "N20 G0 X1.\n"
                       "N30 G0 X2.\n"
                       "M30\n"},
             {"dinplus", "FINISHED\n"
                         "N1 G0 X0 Z0\n"
                         "N2 G1 X30\n"
                         "N3 G1 Z-20\n"
                         "MACHINING\n"
                         "N10 G810 NS2 NE3 P2\n"
                         "N20 M30\n"
                         "END\n"}},
    .alarms = {},
    .sources = {"ISORP", "T: search order"},
    .check = &check,
};

namespace {

/// The label that the jump takes, where it is a plain one.
const flow::Label* taken_by(const ProgramAnalysis& analysis, EffectId jump) {
    const auto& jumps = analysis.graph().jumps;
    const auto found = std::ranges::find(jumps, jump, &flow::ResolvedJump::jump);
    return found == jumps.end() || !found->target ? nullptr : &*found->target;
}

void report(const ProgramAnalysis& analysis, Reporter& reporter, std::int64_t number, Span second, Span first,
            EffectId user) {
    const Span span = analysis.program().effects[user].span;
    std::vector<std::string> words{std::to_string(number), quoted(analysis.program(), span)};
    const flow::Label* taken = taken_by(analysis, user);
    if (taken != nullptr) words.push_back(line_number(analysis.file(), taken->span.begin));
    Finding& finding =
        reporter.report(analysis.file(), second, taken != nullptr ? "taken" : "plain", std::move(words));
    finding.related.push_back({&analysis.file(), first, "the same number stands here"});
    finding.related.push_back(remark_at_effect(analysis, user, "this leads to it"));
}

/// Two blocks of the sections in which a reference or a restart is looked for.
void check_references(const ProgramAnalysis& analysis, Reporter& reporter) {
    using Wanted = std::pair<std::int64_t, SectionKind::Role>;
    std::map<Wanted, EffectId> users;
    std::set<std::int64_t> numbers;
    for (const BlockUser& user : find_block_users(analysis.program())) {
        users.emplace(Wanted(user.number, user.target), user.effect);
        numbers.insert(user.number);
    }
    std::map<Wanted, Span> seen;
    for (const NumberedBlock& block : find_blocks(analysis.file(), numbers)) {
        if (block.section == nullptr) continue;
        const Wanted wanted(block.number, block.section->role);
        const auto user = users.find(wanted);
        if (user == users.end()) continue;
        const auto [first, is_first] = seen.emplace(wanted, block.number_span);
        if (!is_first)
            report(analysis, reporter, block.number, block.number_span, first->second, user->second);
    }
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    check_references(analysis, reporter);
    const auto& labels = analysis.graph().labels; // equal numbers stand together
    std::optional<EffectId> user;
    for (std::size_t i = 1; i < labels.size(); ++i) {
        if (labels[i].number != labels[i - 1].number) continue;
        if (i < 2 || labels[i - 2].number != labels[i].number)
            user = analysis.user_of_label(labels[i].number);
        if (!user) continue;
        report(analysis, reporter, labels[i].number, labels[i].span, labels[i - 1].span, *user);
    }
}

} // namespace
} // namespace maclint::rules
