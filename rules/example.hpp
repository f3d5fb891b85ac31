//! A program that the records of rules show.
#pragma once

#include <string_view>

namespace maclint {

/// A program that shows the rule.
struct Example {
    static constexpr std::string_view usual_file = "example.nc";

    /// A line end at the very beginning of the text is left out, so that it can stand as it looks in a raw
    /// string.
    Example(std::string_view dialect_name, std::string_view program, bool in_complete_folder = false,
            std::string_view file_name = usual_file)
        : dialect(dialect_name)
        , text(program.starts_with('\n') ? program.substr(1) : program)
        , complete(in_complete_folder)
        , file(file_name) {}

    /// The same program where the control's entry of the configuration holds these keys.
    [[nodiscard]] Example on_control_with(std::string_view keys) const {
        Example other = *this;
        other.control = keys;
        return other;
    }

    std::string_view dialect; ///< as --dialect takes it
    std::string_view text;
    bool complete;                 ///< shown in a folder that the configuration declares complete
    std::string_view file;         ///< its name
    std::string_view control = {}; ///< keys of the control's entry in the configuration: `"at-end": ["M9"]`
};

} // namespace maclint
