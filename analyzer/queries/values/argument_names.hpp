//! How a variable is named for somebody who knows the letters of a call.
#pragma once

#include "analyzer/program/model.hpp"

#include <string>

namespace maclint::queries {

/// "#26 (Z)" of a variable that a letter of a call reaches, else its spelling.
[[nodiscard]] std::string with_letter(const Program& program, Variable variable);

} // namespace maclint::queries
