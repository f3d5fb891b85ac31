//! What the command says about the run itself rather than about a program: errors and notes on stderr.
#pragma once

#include <cstdint>
#include <string>

namespace maclint::cli {

enum class NoticeKind : std::uint8_t {
    unreadable,      ///< a file, a folder or the output could not be read or written
    configuration,   ///< a configuration file is wrong
    foreign,         ///< a file in a language that maclint does not lint
    left_out,        ///< something was not looked at, on purpose
    nothing_checked, ///< there was no program, and --error-on-empty wants one
    baseline,        ///< how the findings differ from those known, or what became of the file
    vendor,          ///< what is found in a maker's programs was left out
    idle_setting,    ///< something in a configuration, or a file that was meant for one, has no effect
    origin,          ///< a configuration that holds is of another user, or from above the repository
};

/// Text is UTF-8 and may hold anything: reports escape it.
struct Notice {
    NoticeKind kind;
    std::string path;      ///< of the file concerned; may be empty
    std::string message;   ///< "what. Cure."
    std::string what = {}; ///< of a file that is not linted: "SINUMERIK"; those of one kind share a note
    bool named = false;    ///< the user named the file

    /// Errors end the run with status 2, notes do not.
    [[nodiscard]] bool is_error() const {
        return kind == NoticeKind::unreadable || kind == NoticeKind::configuration ||
               kind == NoticeKind::nothing_checked;
    }
};

} // namespace maclint::cli
