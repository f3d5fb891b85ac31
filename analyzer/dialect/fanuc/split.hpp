//! Cuts a Fanuc file into blocks: comments, ends of block, tape marks and program heads.
#pragma once

#include "analyzer/dialect/fanuc/tables.hpp"
#include "analyzer/dialect/raw_block.hpp"
#include "analyzer/source/span.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace maclint::fanuc {

/// After the blanks and the tape leader at `at`.
[[nodiscard]] Offset skip_blanks(std::string_view text, Offset at);

/// The block that begins at `begin`. It ends at `;`, at a line end, before a tape mark at the end of its
/// line, or before the number of the next program in `M99O0810`, where the control reads one there.
void cut_block(std::string_view text, Offset begin, Reading program_behind_end, RawBlock& block);

/// The first tape mark at or after `from`, which is the head of a line or after a mark.
/// A mark is a `%` outside of comments that begins a block or ends a line.
[[nodiscard]] std::optional<Offset> find_tape_mark(std::string_view text, Offset from);

/// Where reading starts. A file without a mark, or with blocks before its first one, is code from the start.
struct TapeStart {
    Offset begin;
    bool at_mark; ///< `begin` is a mark that opens the tape
};
[[nodiscard]] TapeStart find_tape_start(std::string_view text);

/// What stands after a mark in an open tape: another program, or nothing that the control reads.
struct AfterMark {
    Offset begin;
    bool opens; ///< `begin` is a mark that opens the tape again
};
/// After the mark that opens a tape: the first block. A title on the mark's own line is passed over.
[[nodiscard]] Offset after_opening_mark(std::string_view text, Offset mark);
/// After a mark in an open tape: the next program, or the mark that opens the tape again, or the end of the
/// text.
[[nodiscard]] AfterMark after_mark(std::string_view text, Offset mark);

/// The first code behind a mark that closes the tape, which no mark opens again: the control has ended
/// reading. `after` is what after_mark() tells.
[[nodiscard]] std::optional<Span> code_behind_tape(std::string_view text, Offset mark, AfterMark after);
/// Comments that hold a `%`, which ends the tape there, too.
[[nodiscard]] std::vector<Span> comments_with_percent(std::string_view text);

/// The folder that a line `&F=/MTB/` of a memory dump names, without its outer slashes; empty for `&F=`.
[[nodiscard]] std::optional<std::string_view> folder_mark(std::string_view text, Span block);

/// A program number or name that heads a block.
struct ProgramHead {
    Span span;
    std::optional<std::int64_t> number;
    std::string name; ///< "O9100" or "<PART>"
};
[[nodiscard]] std::optional<ProgramHead> find_program_head(std::string_view text, Span block);

} // namespace maclint::fanuc
