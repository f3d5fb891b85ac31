//! Standard output and standard error.
#pragma once

#include "cli/command_line.hpp"
#include "cli/notice.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace maclint::cli {

inline constexpr int exit_clean = 0;
inline constexpr int exit_findings = 1;
inline constexpr int exit_error = 2;

/// "maclint: error: " and the message, made fit for a terminal, on standard error.
void print_error(std::string_view message);
/// The notice as an error or a note on standard error.
void print_notice(const Notice& notice);

/// A part of the report on the run itself, lines that each end in a line feed, on standard error.
void print_aside(std::string_view lines);

/// Writes to standard output; the exit status says whether that worked.
[[nodiscard]] int print_text(std::string_view text);

/// Writes a file whole or not at all, or standard output for "-". What went wrong, or nothing.
[[nodiscard]] std::optional<Notice> write_to(const std::string& path, std::string_view text);

/// Colours for standard output.
[[nodiscard]] Colour colour_for_output(ColourChoice choice);
[[nodiscard]] bool output_is_terminal();
/// Columns of standard output: of the terminal, else as usual.
[[nodiscard]] std::size_t output_width();
/// Whether standard error is a terminal on which a line can be written over.
[[nodiscard]] bool error_shows_progress();

} // namespace maclint::cli
