//! MAC514: two codes of one modal group in a block.
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/words/block_words.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/modal/modal_group_conflict_finder.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/word_check.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace maclint::rules {

namespace {
void check(const queries::WordsOfBlock& block, Reporter& reporter);
}

extern const Rule modal_group_conflict{
    .code = "MAC514",
    .name = "modal-group-conflict",
    .aliases = "DIN007",
    .summary = "Two codes of one modal group stand in a block: only the last is effective",
    .why =
        "A modal group has one code in force. The whole block runs under the last one of the group, also "
        "words"
        " that stand before it: G91 G28 Z0 G90 goes to Z0 at full height. Some controls stop with an alarm.",
    .severity = Severity::warning,
    .severity_elsewhere = {{"dinplus", Severity::error}},
    .precision = Precision::high,
    .needs = {Capability::exclusive_words},
    .messages = {{"plain",
                  "Codes '{0}' and '{1}' are of one modal group ({2}): the whole block runs under '{1}', or "
                  "stops with {3}.",
                  "Remove the one that is not meant, or write two blocks."},
                 {"forbidden",
                  "Codes '{0}' and '{1}' contradict each other ({2}): they may not stand in one block.",
                  "Remove the one that is not meant, or write two blocks."}},
    .bad = {{"fanuc", R"nc(
O9514(FACE)
G90 G0 X10. Y20.
G0 G1 Z-2. F200.
M30
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 T1
N11 G96 S180 G95 F0.25 M4
N12 G0 X62 Z2
N13 M3 M4
N14 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9514(FACE)
G90 G0 X10. Y20.
G1 Z-2. F200.
M30
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 T1
N11 G96 S180 G95 F0.25 M4
N12 G0 X62 Z2
N13 M30
END
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "5074", "ADDRESS DUPLICATION ERROR"},
               {"FANUC 30i/0i-D", "5074", "ADDRESS DUPLICATION ERROR"},
               {"SINUMERIK", "12060", "two G codes of the same group in a block", false},
               {"SINUMERIK", "14760", "two auxiliary functions of one group in the block", false}},
    .sources = {"T: parameter 3403#6", "GH-ALM", "SEED-001:1340-1355", "SEED-003:10226-10231"},
    .check = WordCheck{.addresses = "G M", .blocks = WordCheck::Blocks::conflicting, .check = &check},
};

namespace {

void report(const queries::WordsOfBlock& block, const ExclusiveCode& before, const ExclusiveCode& found,
            Reporter& reporter) {
    const Program& program = block.analysis.program();
    const bool forbidden = block.analysis.control().contradiction == Contradiction::forbidden;
    Finding& finding =
        reporter.report({block.analysis, found.span}, found.span, forbidden ? "forbidden" : "plain",
                        {quoted(program, before.span), quoted(program, found.span),
                         std::string(found.kind.name), reporter.alarm_words(block.analysis.file())});
    finding.related.push_back({block.analysis.source(), before.span, "the other one stands here"});
}

void check(const queries::WordsOfBlock& block, Reporter& reporter) {
    std::vector<ExclusiveCode> first; // one of each kind
    for (const ExclusiveCode& found : exclusive_codes_in(block)) {
        const auto before = std::ranges::find_if(
            first, [&](const ExclusiveCode& known) { return known.kind.row == found.kind.row; });
        if (before == first.end()) {
            first.push_back(found);
            continue;
        }
        if (before->code == found.code) continue; // the same code once more changes nothing
        if (!queries::has_alternatives(block)) report(block, *before, found, reporter);
        return;
    }
}

} // namespace
} // namespace maclint::rules
