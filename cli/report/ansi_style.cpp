//! Escape sequences (ECMA-48 SGR) for what a report stresses.
#include "cli/report/ansi_style.hpp"

namespace maclint::cli {

std::string AnsiStyle::severity(Severity severity, std::string_view text) const {
    switch (severity) {
    case Severity::error: return with("1;31", text);
    case Severity::warning: return with("1;33", text);
    case Severity::note: return note(text);
    }
    return std::string(text);
}

std::string AnsiStyle::with(std::string_view code, std::string_view text) const {
    if (colour_ == Colour::plain || text.empty()) return std::string(text);
    return "\x1B[" + std::string(code) + "m" + std::string(text) + "\x1B[0m";
}

} // namespace maclint::cli
