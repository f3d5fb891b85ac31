//! What each word of a block is to the call that the block makes.
#pragma once

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/call_kinds.hpp"
#include "analyzer/program/model.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace maclint::queries {

/// What a word is to a call.
enum class CallPart : std::uint8_t {
    none,     ///< the call does not take it
    code,     ///< it makes the call: G65, M98
    program,  ///< it names the program
    repeat,   ///< how often it runs
    argument, ///< it passes a value
};

/// A call that a code makes whose meaning is known, and the words of its block.
struct CallInBlock {
    EffectId effect;
    const Call& call;
    const CallKind& kind;
    Span block;
    std::span<const Word> words; ///< of the block, in text order
    std::size_t code;            ///< which of them makes the call
    std::size_t end;             ///< the first that belongs to a macro call after it

    [[nodiscard]] const Word& code_word() const { return words[code]; }
    [[nodiscard]] std::span<const Word> before() const { return words.first(code); }
    [[nodiscard]] std::span<const Word> after() const { return words.subspan(code + 1, end - code - 1); }
    /// Whether it opens a fresh set of local variables, which its arguments fill.
    [[nodiscard]] bool passes_arguments() const { return kind.frame == Frame::fresh; }
};

/// The calls of the program, in text order. Codes of the shop's own, whose words nobody knows, are left out.
[[nodiscard]] std::vector<CallInBlock> calls_with_words(const ProgramAnalysis& analysis);

/// What the word, one of the call's block, is to the call.
[[nodiscard]] CallPart part_of(const Program& program, const CallInBlock& call, const Word& word);

/// The argument that the word passes, or nullptr.
[[nodiscard]] const Argument* argument_of(const Program& program, const CallInBlock& call, const Word& word);

/// Whether the words call more than one program: G65 beside G66, M98 twice.
[[nodiscard]] bool call_twice(const ControlModel& control, std::span<const Word> words);

/// M99, M30, M02 as a word.
[[nodiscard]] bool ends_program(const ControlModel& control, const Word& word);

/// G81 as a word, whatever the control names a canned cycle; not the code that ends one.
[[nodiscard]] bool begins_cycle(const ControlModel& control, const Word& word);

/// Whether a call may give the variable a value: by a letter, or as one of a set of I, J and K.
[[nodiscard]] bool can_be_passed(const ControlModel& control, Variable variable);

} // namespace maclint::queries
