//! Programs that end as a main program does, and are macros all the same.
#pragma once

#include "analyzer/program/model.hpp"

namespace maclint {

/// Whether a program that does not return reads arguments as only a macro has them: it sets nothing of what
/// a letter of a call reaches, reads it, and asks whether it was passed, or bears a number of macros.
[[nodiscard]] bool is_written_as_macro(const Program& program);

} // namespace maclint
