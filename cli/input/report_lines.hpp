//! What single lines of maclint's reports look like.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace maclint {
struct Rule;
}

namespace maclint::cli {

/// The rule of "error[MAC303]: Jump into a loop"; nullptr: it is no such line.
[[nodiscard]] const Rule* rule_of_headline(std::string_view line);

/// Whether a text begins like a finding of the rule, up to the words that differ from finding to finding.
[[nodiscard]] bool are_words_of(const Rule& rule, std::string_view text);

/// "O1.nc:4:1: error[MAC301] Missing"
[[nodiscard]] bool is_concise_finding(std::string_view line);

/// "::error file=O1.nc,line=4,endLine=4,title=MAC303 jump-into-loop::Jump into a loop"
[[nodiscard]] bool is_workflow_command(std::string_view line);

/// "maclint: note: O1.txt: this is not linted.", where what goes to standard error went into the file, too.
[[nodiscard]] bool is_message(std::string_view line);

/// "no findings (3 checked)", "1 error, 2 notes in 1 file (3 checked, 1 allowed by comments)"
[[nodiscard]] bool is_summary(std::string_view line);

/// "12 known findings of baseline.json not shown", "3 steps of paths not shown; --path full shows them"
[[nodiscard]] bool is_not_shown(std::string_view line);

/// "timing: reading             0.012 s"
[[nodiscard]] bool is_timing(std::string_view line);

/// The number of "  12  MAC303 jump-into-loop (error)".
[[nodiscard]] std::optional<std::uint64_t> count_of_rule(std::string_view line);

/// The number of "  3  O1.nc".
[[nodiscard]] std::optional<std::uint64_t> count_of_file(std::string_view line);

/// "  and 5 more files"
[[nodiscard]] bool is_count_of_more_files(std::string_view line);

/// "  --> O1.nc:4:1" behind its arrow; the columns before the arrow, 0 for other lines.
[[nodiscard]] std::size_t margin_of_place(std::string_view line, std::string_view arrow);

/// " 12 | GOTO 99", "    | ^^^^^^", with the frame behind so many columns.
[[nodiscard]] bool is_row(std::string_view line, std::size_t margin);

/// "more: maclint explain MAC303"
[[nodiscard]] bool is_reference(std::string_view text);

/// Whether the line begins or ends with what could be a tape mark, before which a control reads nothing, or
/// holds the end of a block, ';', and more behind it that is no prose. A text that quotes such blocks is
/// rather linted than a program passed over.
[[nodiscard]] bool is_like_blocks(std::string_view line);
/// Whether a line has a tape mark at the head of a block, and more behind it: `;%;O1`. In what a row quotes
/// others are harmless.
[[nodiscard]] bool holds_tape_mark_as_block(std::string_view line);

/// The line without what colours it.
[[nodiscard]] std::string without_colours(std::string_view line);

} // namespace maclint::cli
