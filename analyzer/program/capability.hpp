//! What the language of a control has or lacks.
#pragma once

#include <cstdint>

namespace maclint {

/// What the language of a control has, where rules speak of nothing else.
enum class Capability : std::uint8_t {
    loop_numbers,        ///< DO m … END m, which a number pairs
    sections,            ///< parts that words of their own begin
    exclusive_words,     ///< it is known which words exclude each other in a block
    vacancy,             ///< variables can hold vacant, which programs set and ask for
    unset_locals,        ///< local variables hold no number before something sets them
    undefined_variables, ///< variables have values that nothing has defined, beside those that were set
    jumps,               ///< programs jump to blocks
    sequence_numbers,    ///< programs name blocks by their numbers
    block_if,            ///< IF … THEN opens blocks up to ELSE or ENDIF
    paired_words,        ///< loops and choices pair by nesting, each with a closing word of its own
    block_references,    ///< words name blocks of certain sections
    macro_calls,         ///< calls that count against a limit of their own
    modal_calls,         ///< programs called after every move or block
    named_arguments,     ///< what a call passes is read by names of its own
    suppression,         ///< programs switch off single block, feed hold, override
};

} // namespace maclint
