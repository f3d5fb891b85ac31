//! MAC559: an address twice in a block.
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/call_words.hpp"
#include "analyzer/queries/words/block_words.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/fixes.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/word_check.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace maclint::rules {

namespace {
void check(const queries::WordsOfBlock& block, Reporter& reporter);
}

extern const Rule duplicate_address{
    .code = "MAC559",
    .name = "duplicate-address",
    .aliases = "DIN006",
    .summary = "An address stands twice in a block",
    .why =
        "A block has one place for each address. Many controls take the last word without a message and"
        " move somewhere else than the first one says, others stop with an alarm. Often a line end was lost.",
    .severity = Severity::warning,
    .severity_elsewhere = {{"dinplus", Severity::error}},
    .precision = Precision::high,
    .needs = {Capability::exclusive_words},
    .messages =
        {{"twice",
          "Address {0} stands twice in one block: the control takes '{2}' and passes '{1}' over, or stops "
          "with {3}.",
          "Remove the word that is not meant, or write two blocks."},
         {"same", "Address {0} stands twice in one block, both times as '{1}': some controls stop with {2}.",
          "Remove one of the two."},
         {"several",
          "Addresses {0} stand twice in one block: the control takes the last word of each, or stops with "
          "{1}.",
          "Write two blocks if a line end was lost."},
         {"forbidden", "Address {0} stands twice in one block, which the language forbids: '{1}' and '{2}'.",
          "Remove the word that is not meant, or write two blocks."},
         {"several-forbidden", "Addresses {0} stand twice in one block, which the language forbids.",
          "Write two blocks if a line end was lost."}},
    .bad = {{"fanuc", R"nc(
O9559(EDGE)
G90 G1 X10. Y20. F200.
X50. Y20. X60.
M30
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 G1 X60 Z2 X50
N11 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9559(EDGE)
G90 G1 X10. Y20. F200.
X50. Y20.
X60.
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "5074", "ADDRESS DUPLICATION ERROR"},
               {"FANUC 30i/0i-D", "5074", "ADDRESS DUPLICATION ERROR"}},
    .sources = {"T: alarm 5074", "GH-ALM", "SEED-003:10226-10231"},
    .check = WordCheck{.addresses = "", .blocks = WordCheck::Blocks::repeated, .check = &check},
};

namespace {

/// Arguments of a call may repeat addresses that no other block may.
bool may_be_argument(const queries::WordsOfBlock& block, const Word& word) {
    const auto& repeatable = block.analysis.control().repeatable_arguments;
    return std::ranges::find(repeatable, word.address) != repeatable.end() && queries::may_call(block);
}

/// An address of a block, and the first and the last of its words that have a value.
struct Occurrence {
    std::string_view address;
    const Word* first;
    const Word* last;
};

/// In the order of their first words.
std::vector<Occurrence> occurrences_in(std::span<const Word> words) {
    std::vector<Occurrence> occurrences;
    for (const Word& word : words) {
        if (!word.has_value()) continue;
        const auto known = std::ranges::find(occurrences, word.address, &Occurrence::address);
        if (known == occurrences.end())
            occurrences.push_back({word.address, &word, nullptr});
        else
            known->last = &word;
    }
    return occurrences;
}

void check(const queries::WordsOfBlock& block, Reporter& reporter) {
    const auto& repeatable = block.analysis.control().repeatable;
    std::vector<Occurrence> repeated = occurrences_in(block.words);
    std::erase_if(repeated, [&](const Occurrence& address) {
        return address.last == nullptr ||
               std::ranges::find(repeatable, address.address) != repeatable.end() ||
               may_be_argument(block, *address.last);
    });
    if (repeated.empty() || queries::has_alternatives(block)) return;
    if (queries::call_twice(block.analysis.control(), block.words)) return; // MAC423's
    std::string addresses;
    for (const Occurrence& address : repeated)
        addresses += (addresses.empty() ? "" : ", ") + std::string(address.address);
    const auto [address, first, last] = *std::ranges::min_element(
        repeated, {}, [](const Occurrence& occurrence) { return occurrence.last->span.begin; });
    const Program& program = block.analysis.program();
    const std::string after = quoted(program, last->span);
    // Of more than two the first that the last one is not.
    const auto other = std::ranges::find_if(block.words, [&, name = address](const Word& word) {
        return word.address == name && word.has_value() && quoted(program, word.span) != after;
    });
    const std::string before = other == block.words.end() ? after : quoted(program, other->span);
    const auto report = [&](std::string_view message, std::vector<std::string> arguments) -> Finding& {
        return reporter.report({block.analysis, last->span}, last->span, message, std::move(arguments));
    };
    const std::string alarm = reporter.alarm_words(block.analysis.file());
    const bool several = repeated.size() > 1;
    const bool forbidden = block.analysis.control().contradiction == Contradiction::forbidden;
    Finding& finding = several && forbidden ? report("several-forbidden", {addresses})
                       : several            ? report("several", {addresses, alarm})
                       : forbidden          ? report("forbidden", {addresses, before, after})
                       : before == after    ? report("same", {addresses, after, alarm})
                                            : report("twice", {addresses, before, after, alarm});
    // The second one may have been meant for another address, or a part of a remark.
    if (!several && !forbidden && before == after) offer_removal(finding, Applicability::unsafe, last->span);
    finding.related.push_back({block.analysis.source(), first->span, "the first one stands here"});
}

} // namespace
} // namespace maclint::rules
