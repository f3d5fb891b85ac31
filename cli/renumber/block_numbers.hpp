//! The numbers of blocks in a file, and all words that name them.
#pragma once

#include "analyzer/program/model.hpp"
#include "analyzer/source/span.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace maclint::cli {

/// Digits that say a number.
struct WrittenNumber {
    Span digits;
    std::int64_t number;
};

/// Digits that name a block of the file.
struct BlockUse {
    WrittenNumber written;
    std::size_t block; ///< place in NumberSpace::blocks
};

/// Blocks among which a number is looked for, in the order of the text: those of one program, in a language
/// whose sections name each other's blocks those of the whole file.
struct NumberSpace {
    std::vector<WrittenNumber> blocks;
    std::vector<BlockUse> uses;               ///< in the order of the text
    std::vector<WrittenNumber> without_block; ///< name a block that is not there, likewise
    std::vector<std::size_t> programs;        ///< places in ProgramFile::programs
};

/// Why the numbers of a file cannot be changed together: "'GOTO#1' jumps …. Cure."
struct UnsafeNumber {
    std::shared_ptr<const Source> source;
    Span at;
    std::string why;
};

using NumberSpaces = std::vector<NumberSpace>;

/// `others`: programs of other files that the file's programs call, or that call them; what they name of the
/// file cannot be changed with it.
[[nodiscard]] std::variant<NumberSpaces, UnsafeNumber>
number_spaces(const ProgramFile& file, std::span<const ProgramFile* const> others);

} // namespace maclint::cli
