//! Leaves out what a language, or a call, lets stand more than once.
#include "rules/modal/duplicate_address_finder.hpp"

#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/call_words.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <algorithm>
#include <span>
#include <variant>

namespace maclint::rules {
namespace {

/// Arguments of a call may repeat addresses that no other block may.
bool may_be_argument(const queries::WordsOfBlock& block, const Word& word) {
    const auto& repeatable = block.analysis.control().repeatable_arguments;
    return std::ranges::find(repeatable, word.address) != repeatable.end() && queries::may_call(block);
}

std::vector<RepeatedAddress> occurrences_in(std::span<const Word> words) {
    std::vector<RepeatedAddress> occurrences;
    for (const Word& word : words) {
        if (!word.has_value()) continue;
        const auto known = std::ranges::find(occurrences, word.address, &RepeatedAddress::address);
        if (known == occurrences.end())
            occurrences.push_back({word.address, &word, nullptr, nullptr});
        else
            known->last = &word;
    }
    return occurrences;
}

/// Whether both are written alike, or are the same number: F0.010 and F.010.
bool are_alike(const Program& program, const Word& one, const Word& other) {
    const auto* a = std::get_if<Literal>(&one.value);
    const auto* b = std::get_if<Literal>(&other.value);
    const bool same_number = a != nullptr && b != nullptr && a->value == b->value &&
                             a->decimal_point == b->decimal_point && one.incremental == other.incremental;
    return same_number || program.slice(one.span) == program.slice(other.span);
}

const Word* word_unlike_the_last(const Program& program, std::span<const Word> words,
                                 const RepeatedAddress& address) {
    const auto other = std::ranges::find_if(words, [&](const Word& word) {
        return word.address == address.address && word.has_value() &&
               !are_alike(program, word, *address.last);
    });
    return other == words.end() ? nullptr : &*other;
}

} // namespace

std::vector<RepeatedAddress> repeated_addresses(const queries::WordsOfBlock& block) {
    const auto& repeatable = block.analysis.control().repeatable;
    std::vector<RepeatedAddress> repeated = occurrences_in(block.words);
    std::erase_if(repeated, [&](const RepeatedAddress& address) {
        return address.last == nullptr ||
               std::ranges::find(repeatable, address.address) != repeatable.end() ||
               may_be_argument(block, *address.last);
    });
    if (repeated.empty() || queries::has_alternatives(block) ||
        queries::call_twice(block.analysis.control(), block.words))
        return {};
    for (RepeatedAddress& address : repeated)
        address.other = word_unlike_the_last(block.analysis.program(), block.words, address);
    return repeated;
}

} // namespace maclint::rules
