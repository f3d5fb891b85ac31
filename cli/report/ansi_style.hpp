//! Colours of a terminal, or none.
#pragma once

#include "cli/report/report.hpp"

#include <string>
#include <string_view>

namespace maclint::cli {

class AnsiStyle {
  public:
    explicit AnsiStyle(Colour colour)
        : colour_(colour) {}

    [[nodiscard]] std::string severity(Severity severity, std::string_view text) const;
    [[nodiscard]] std::string bold(std::string_view text) const { return with("1", text); }
    /// Line numbers, arrows and what else frames the text.
    [[nodiscard]] std::string frame(std::string_view text) const { return with("34", text); }
    [[nodiscard]] std::string note(std::string_view text) const { return with("1;36", text); }

  private:
    [[nodiscard]] std::string with(std::string_view code, std::string_view text) const;
    Colour colour_;
};

} // namespace maclint::cli
