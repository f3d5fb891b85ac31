//! Tells a program that was written for a control of another language from one with mistakes.
#pragma once

#include "analyzer/program/model.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint {

/// What speaks for another control in a file that was read as one of ours.
struct OtherControl {
    struct Mark {
        std::string text; ///< "'R_SKIP['"
        Span place;       ///< what could not be read there
    };
    std::string_view name;   ///< "LNC"; empty: nothing tells
    std::vector<Mark> marks; ///< of that control, in the order of the text; else the first unreadable places
    std::size_t unreadable = 0, blocks = 0;
};

/// Two different marks of one control in what could not be read, the habit of remarks after ';', or more than
/// a fifth of the blocks without any sense, and too many of them to be mistakes of typing. Nothing for all
/// other files.
[[nodiscard]] std::optional<OtherControl> find_other_control(const ProgramFile& file);

} // namespace maclint
