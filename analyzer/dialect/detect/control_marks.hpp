//! What gives away for which control of the Fanuc family a text was written.
#pragma once

#include "analyzer/dialect/detect/line.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace maclint::detect {

/// The evidence of a text: one mark that no other control of the family has, or two different ones that
/// others seldom have, name the control.
class ControlEvidence {
  public:
    void add(const Line& line, std::size_t number);

    /// The control's name; empty: nothing speaks for one.
    [[nodiscard]] std::string_view verdict() const;
    /// The marks and where they stand: "'#30003.036' on line 5".
    [[nodiscard]] std::string reason() const;

  private:
    [[nodiscard]] int points_of(std::string_view control) const;

    static constexpr std::size_t most_marks = 16;
    std::array<std::uint32_t, most_marks> lines_{}; ///< of the first sighting; 0: none
};

} // namespace maclint::detect
