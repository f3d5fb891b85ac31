//! MAC559: an address twice in a block.
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/call_words.hpp"
#include "analyzer/queries/words/block_words.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/fixes.hpp"
#include "rules/modal/duplicate_address_finder.hpp"
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
               {"FANUC 30i/0i-D", "5074", "ADDRESS DUPLICATION ERROR"},
               {"SINUMERIK", "12000", "address programmed twice in the block", false},
               {"SINUMERIK", "16420", "axis programmed twice", false},
               {"SINUMERIK", "12010", "address programmed too often in the block", false}},
    .sources = {"T: alarm 5074", "GH-ALM", "SEED-003:10226-10231"},
    .check = WordCheck{.addresses = "", .blocks = WordCheck::Blocks::repeated, .check = &check},
};

namespace {

void check(const queries::WordsOfBlock& block, Reporter& reporter) {
    const std::vector<RepeatedAddress> repeated = repeated_addresses(block);
    if (repeated.empty()) return;
    std::string addresses;
    for (const RepeatedAddress& address : repeated)
        addresses += (addresses.empty() ? "" : ", ") + std::string(address.address);
    const auto [address, first, last, other] = *std::ranges::min_element(
        repeated, {}, [](const RepeatedAddress& one) { return one.last->span.begin; });
    const Program& program = block.analysis.program();
    const std::string after = quoted(program, last->span);
    const std::string before = other == nullptr ? after : quoted(program, other->span);
    const auto report = [&](std::string_view message, std::vector<std::string> arguments) -> Finding& {
        return reporter.report({block.analysis, last->span}, last->span, message, std::move(arguments));
    };
    const std::string alarm = reporter.alarm_words(block.analysis.file());
    const bool several = repeated.size() > 1;
    const bool forbidden = block.analysis.control().contradiction == Contradiction::forbidden;
    Finding& finding = several && forbidden ? report("several-forbidden", {addresses})
                       : several            ? report("several", {addresses, alarm})
                       : forbidden          ? report("forbidden", {addresses, before, after})
                       : other == nullptr   ? report("same", {addresses, after, alarm})
                                            : report("twice", {addresses, before, after, alarm});
    // The second one may have been meant for another address, or a part of a remark.
    if (!several && !forbidden && other == nullptr) offer_removal(finding, Applicability::unsafe, last->span);
    finding.related.push_back({block.analysis.source(), first->span, "the first one stands here"});
}

} // namespace
} // namespace maclint::rules
