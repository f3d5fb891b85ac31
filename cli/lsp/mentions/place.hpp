//! What stands at a place of a text: the program, the block with its words, what is named there.
#pragma once

#include "analyzer/program/block_view.hpp"
#include "cli/lsp/documents/text_reader.hpp"
#include "cli/lsp/mentions/mention.hpp"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace maclint::cli::lsp {

/// Whether the place is in the span or directly behind it, where a cursor stands that has just written it.
[[nodiscard]] inline bool touches(Span span, Offset at) { return span.begin <= at && at <= span.end; }

/// The program that the place lies in, or the last before it; nothing before the first.
[[nodiscard]] std::optional<std::size_t> program_at(const ProgramFile& file, Offset at);

/// What is named there, the shortest of what touches the place; nothing: no name is.
[[nodiscard]] std::optional<Mention> mention_at(const Program& program, Offset at);

/// The words of the block at the place, read again where it is a plain one; none between blocks.
[[nodiscard]] std::vector<Word> words_at(const Program& program, const LineTable& lines, Offset at);

/// Letters, figures and what else names are made of, around the place; empty where none are.
[[nodiscard]] Span name_at(std::string_view text, Offset at);
/// Letters alone.
[[nodiscard]] Span letters_at(std::string_view text, Offset at);

/// Whether the place lies in a comment of its line, as the language writes them.
[[nodiscard]] bool is_in_comment(const ReadText& text, Offset at);

} // namespace maclint::cli::lsp
