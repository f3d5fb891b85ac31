//! Names that are so near that one was meant by the other. All are in capitals.
#pragma once

#include <string_view>

namespace maclint {

/// A letter is another one, lost or added. Names that differ in a figure alone are two variables of a row.
[[nodiscard]] bool is_one_letter_off(std::string_view written, std::string_view known);

/// An exchange of neighbours, a letter lost or doubled. Where the name can be no program, it may be as short
/// as SUPA and MCALL.
[[nodiscard]] bool is_typing_slip(std::string_view written, std::string_view meant,
                                  bool may_be_program = true);

} // namespace maclint
