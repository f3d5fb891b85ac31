//! MAC514: two codes of one modal group in a block.
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/block_words.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/word_check.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace maclint::rules {

namespace {
void check(const queries::WordsOfBlock& block, Reporter& reporter);
}

extern const Rule modal_group_conflict{
    .code = "MAC514",
    .name = "modal-group-conflict",
    .summary = "Two codes of one modal group stand in a block: only the last is effective",
    .why =
        "A modal group has one code in force. The whole block runs under the last one of the group, also "
        "words"
        " that stand before it: G91 G28 Z0 G90 goes to Z0 at full height. Some controls stop with an alarm.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::exclusive_words},
    .messages = {{"plain",
                  "Codes '{0}' and '{1}' are of one modal group ({2}): the whole block runs under '{1}', or "
                  "stops with {3}.",
                  "Remove the one that is not meant, or write two blocks."}},
    .bad = {{"fanuc", R"nc(
O9514(FACE)
G90 G0 X10. Y20.
G0 G1 Z-2. F200.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9514(FACE)
G90 G0 X10. Y20.
G1 Z-2. F200.
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "5074", "ADDRESS DUPLICATION ERROR"}},
    .sources = {"T: parameter 3403#6", "SEED-001:1340-1355"},
    .check = WordCheck{.addresses = "G", .blocks = WordCheck::Blocks::conflicting, .check = &check},
};

namespace {

/// A code and the group that it is a member of.
struct Member {
    const Word* word;
    double code;
    GroupId group;
};

std::optional<Member> member(const ControlModel& control, const Word& word) {
    const auto* code = std::get_if<Literal>(&word.value);
    if (code == nullptr || word.address != "G") return std::nullopt;
    const auto group = control.group_of('G', code->value);
    if (!group) return std::nullopt;
    return Member{&word, code->value, *group};
}

void check(const queries::WordsOfBlock& block, Reporter& reporter) {
    const ControlModel& control = block.analysis.control();
    std::vector<Member> members; // one of each group
    for (const Word& word : block.words) {
        const auto found = member(control, word);
        if (!found) continue;
        const auto before = std::ranges::find(members, found->group, &Member::group);
        if (before == members.end()) {
            members.push_back(*found);
            continue;
        }
        if (before->code == found->code) continue; // the same code once more changes nothing
        if (queries::has_alternatives(block)) return;
        const Program& program = block.analysis.program();
        Finding& finding = reporter.report({block.analysis, word.span}, word.span, "plain",
                                           {quoted(program, before->word->span), quoted(program, word.span),
                                            std::string(control.groups[found->group].name),
                                            reporter.alarm_words(block.analysis.file())});
        finding.related.push_back({block.analysis.source(), before->word->span, "the other one stands here"});
        return;
    }
}

} // namespace
} // namespace maclint::rules
