//! MAC559: an address twice in a block.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/word_check.hpp"

#include <algorithm>
#include <string>

namespace maclint::rules {

namespace {
void check(const WordsOfBlock& block, Reporter& reporter);
}

extern const Rule duplicate_address{
    .code = "MAC559",
    .name = "duplicate-address",
    .aliases = "",
    .summary = "An address stands twice in a block",
    .why =
        "A block has one place for each address. Many controls take the last word without a message and"
        " move somewhere else than the first one says, others stop with an alarm. Often a line end was lost.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = false,
    .messages =
        {{"twice",
          "Address {0} stands twice in one block: the control takes '{2}' and passes '{1}' over, or stops "
          "with alarm 5074. Remove the word that is not meant, or write two blocks."},
         {"several",
          "Addresses {0} stand twice in one block: the control takes the last word of each, or stops with "
          "alarm 5074. Write two blocks if a line end was lost."}},
    .bad = {{"fanuc", "O9559(EDGE)\n"
                      "G90 G1 X10. Y20. F200.\n"
                      "X50. Y20. X60.\n"
                      "M30\n"}},
    .good = {{"fanuc", "O9559(EDGE)\n"
                       "G90 G1 X10. Y20. F200.\n"
                       "X50. Y20.\n"
                       "X60.\n"
                       "M30\n"}},
    .alarms = {{"FANUC 16i/18i/21i", "5074", "ADDRESS DUPLICATION ERROR"}},
    .sources = {"T: alarm 5074"},
    .check = WordCheck{.addresses = "", .blocks = WordCheck::Blocks::repeated, .check = &check},
};

namespace {

/// Arguments of a call may repeat addresses that no other block may.
bool may_be_argument(const WordsOfBlock& block, const Word& word) {
    const auto& repeatable = block.analysis.control().repeatable_arguments;
    return std::ranges::find(repeatable, word.address) != repeatable.end() && may_call(block);
}

void check(const WordsOfBlock& block, Reporter& reporter) {
    const auto& repeatable = block.analysis.control().repeatable;
    if (repeatable.empty()) return; // nobody has said which words exclude each other
    std::string addresses;
    const Word* first = nullptr;
    const Word* last = nullptr;
    std::size_t count = 0;
    for (std::size_t i = 1; i < block.words.size(); ++i) {
        const Word& word = block.words[i];
        const auto before = block.words.first(i);
        const auto same = [&](const Word& other) {
            return other.address == word.address && other.has_value();
        };
        const auto found = std::ranges::find_if(before, same);
        if (!word.has_value() || found == before.end()) continue;
        if (std::ranges::find(repeatable, word.address) != repeatable.end() || may_be_argument(block, word))
            continue;
        if (std::ranges::count_if(before, same) > 1) continue; // told at the second
        if (count++ == 0) {
            first = &*found;
            last = &word;
        }
        addresses += (addresses.empty() ? "" : ", ") + std::string(word.address);
    }
    if (count == 0 || has_alternatives(block)) return;
    const Program& program = block.analysis.program();
    Finding& finding =
        count == 1 ? reporter.report(block.analysis.file(), last->span, "twice",
                                     {addresses, quoted(program, first->span), quoted(program, last->span)})
                   : reporter.report(block.analysis.file(), last->span, "several", {addresses});
    finding.related.push_back({&block.analysis.file(), first->span, "the first one stands here"});
}

} // namespace
} // namespace maclint::rules
