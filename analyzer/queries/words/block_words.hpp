//! A block with its words, and what else stands there.
#pragma once

#include "analyzer/program/block_view.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <span>

namespace maclint::queries {

class ModesAt;
class SwitchesAt;

/// A block and its words; good as long as the check runs.
struct WordsOfBlock {
    const ProgramAnalysis& analysis;
    const BlockView& block;
    std::span<const Word> words;
    bool modal_calls; ///< calls of the program act on blocks after them
    const Section& section;
    ModesAt&
        modes_at; ///< `modes_at(block)`: what is in force; a rule that asks declares dataflow::BeforeNode
    SwitchesAt& switches_at; ///< what is switched on
};

/// Whether words of the block may be skipped or stand under a condition: then two that exclude each other may
/// be alternatives.
[[nodiscard]] bool has_alternatives(const WordsOfBlock& block);

/// Whether the block calls a program, or may: by a code that no table knows, or after its move.
[[nodiscard]] bool may_call(const WordsOfBlock& block);

/// Whether the block surely calls a program, or holds a code that is computed and may.
[[nodiscard]] bool calls(const WordsOfBlock& block);

/// Whether a word may belong to another code of the block than the one given: F to the G1 beside a G4. Codes
/// that only switch how others are read (G90, G54, G17) take no words.
[[nodiscard]] bool may_belong_to_another(const WordsOfBlock& block, const Word& code, const Word& word);

/// Whether the program makes modal calls, which act on the blocks after them.
[[nodiscard]] bool has_modal_calls(const Program& program);

} // namespace maclint::queries
