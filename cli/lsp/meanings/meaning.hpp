//! What words and variables mean, in a few lines of Markdown, from the tables.
#pragma once

#include "cli/lsp/documents/text_reader.hpp"
#include "cli/lsp/mentions/mention.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace maclint::cli::lsp {

/// Of a code or a section as the control has it, "G83", "DIAMON", "MACHINING"; empty where nothing is known
/// of it.
[[nodiscard]] std::string meaning_of_code(const ControlModel& control, std::string_view code);
/// Of a word of a block: its code's page, or what it is beside the code that takes it; empty where none does.
[[nodiscard]] std::string meaning_of_word(const ControlModel& control, std::span<const Word> block,
                                          const Word& word);
/// Of a keyword, a function, a cycle; empty where the language has no such word.
[[nodiscard]] std::string meaning_of_name(const Dialect& dialect, std::string_view name);
/// Of a variable or a value of the machine, written so; empty of anything else.
[[nodiscard]] std::string meaning_of_variable(const Program& program, const Named& named,
                                              std::string_view written);
/// Of the rules or rows that a word of a comment names, "MAC303"; empty where it names none.
[[nodiscard]] std::string meaning_of_rule(std::string_view word);
/// Of an alarm that a word names, "128", on the control's list; empty where that has none.
[[nodiscard]] std::string meaning_of_alarm(const ControlModel& control, std::string_view word);

/// What the shop calls a word, where the configuration of the text says it, or nullptr.
[[nodiscard]] const std::string* shop_meaning(const ReadText& text, std::string_view word);

} // namespace maclint::cli::lsp
