//! The blocks of a section, plain or not, with their words.
#pragma once

#include "analyzer/program/block_view.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <variant>

namespace maclint {

/// The section that the place lies in; nullptr: it lies before all of them.
[[nodiscard]] inline const Section* section_at(const Program& program, Offset place) {
    const auto behind = std::ranges::find_if(
        program.sections, [&](const Section& section) { return section.heading.begin > place; });
    return behind == program.sections.begin() ? nullptr : &*std::prev(behind);
}

/// How many plain blocks the section has.
[[nodiscard]] inline std::size_t plain_blocks(const Program& program, const Section& section) {
    std::size_t blocks = 0;
    for (ItemId item = section.items.first; item < section.items.first + section.items.count; ++item)
        if (const auto* run = std::get_if<PlainRun>(&program.items[item])) blocks += run->blocks;
    return blocks;
}

/// `visit(BlockView, words)` for each block of the section that has words.
template<class Visit>
void for_each_block_of(const Program& program, const Section& section, const Visit& visit) {
    for_each_block_with_words(
        program, section.items, [](const PlainRun& run, const auto& take) { take(run.span); },
        [](const WordSummary&) { return true; },
        [&](const BlockView& block, std::span<const Word> words, const WordSummary*) {
            visit(block, words);
        });
}

/// `visit(BlockView, words)` for each block with one of the addresses in the parts of the program that run.
template<class Visit>
void for_each_running_block_with(const Program& program, std::string_view addresses, const Visit& visit) {
    const syntax::AddressSet wanted = addresses_named(program, addresses);
    for (const Section& section : program.sections)
        if (section.executed == Section::Executed::when_reached)
            for_each_block_with_words(
                program, section.items,
                [&](const PlainRun& run, const auto& take) {
                    if (run.words.addresses.meets(wanted)) take(run.span);
                },
                [&](const WordSummary& words) { return words.addresses.meets(wanted); },
                [&](const BlockView& block, std::span<const Word> words, const WordSummary*) {
                    visit(block, words);
                });
}

} // namespace maclint
