//! The commands and their options as the command line declares them: for the manual page and for shells.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace maclint::cli {

/// What a shell offers for a value.
enum class ValueKind : std::uint8_t {
    none,  ///< there is no value
    words, ///< one of a few
    lists, ///< several of them, with commas between
    path,
    free, ///< a number, or what only its user knows
};

struct OptionText {
    std::vector<std::string> names; ///< "--help", "-h"; none: written without a name
    std::string value;              ///< "FORMAT"; empty for one without a value
    std::string text;
    ValueKind kind = ValueKind::none;
    std::vector<std::string> words; ///< of `words` and `lists`
    bool repeatable = false;
};

struct CommandText {
    std::string name;
    std::string text;
    std::vector<OptionText> options;
};

/// All that read_command_line takes, made from the same declarations.
[[nodiscard]] std::vector<CommandText> command_list();

} // namespace maclint::cli
