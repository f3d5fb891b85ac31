//! Finds the blocks that carry certain numbers, wherever they stand in a file.
#pragma once

#include "analyzer/program/model.hpp"
#include "analyzer/program/section_kinds.hpp"

#include <set>
#include <vector>

namespace maclint {

struct NumberedBlock {
    std::int64_t number;
    Span number_span;
    const Program* program;
    const SectionKind* section; ///< nullptr: of a program without sections
};

/// An effect that names a block by a number that is there to be read.
struct BlockUser {
    EffectId effect;
    std::int64_t number;
    SectionKind::Role target; ///< of the sections in which the block is looked for
    bool restarts;            ///< the program begins again there; otherwise the block is only referred to
};

/// References to blocks of other sections and restarts, in text order. Jumps are the flow graph's.
[[nodiscard]] std::vector<BlockUser> find_block_users(const Program& program);

/// The row of a section; nullptr where the control has none of that name.
[[nodiscard]] const SectionKind* kind_of(const ControlModel& control, const Section& section);

/// Fills ProgramFile::block_numbers: for languages in which words name blocks of other sections or restart at
/// them. Only the numbers that something names are taken in.
void index_block_numbers(ProgramFile& file);

/// The blocks of all programs of the file that carry one of the numbers, which block users name, by number,
/// then in text order. The file must be indexed.
[[nodiscard]] std::vector<NumberedBlock> find_blocks(const ProgramFile& file,
                                                     const std::set<std::int64_t>& numbers);

} // namespace maclint
