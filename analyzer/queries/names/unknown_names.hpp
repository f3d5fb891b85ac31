//! Names that a program uses and does not define, held against what else defines names.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <string>
#include <string_view>

namespace maclint::queries {

/// What the name is one letter off, of the program, of the language or of a file of definitions, where
/// nothing else has the name; empty: nothing.
[[nodiscard]] std::string meant_by(const ProgramAnalysis& analysis, const UnknownName& name);
/// Nothing has the name, as far as all names are known; not what meant_by() tells.
[[nodiscard]] bool is_undefined(const ProgramAnalysis& analysis, const UnknownName& name);
/// Whether it is a G code, as G43.
[[nodiscard]] bool is_g_code(const UnknownName& name);
/// Whether the code is one of other controls, which this one lacks.
[[nodiscard]] bool is_of_another_control(const ControlModel& control, std::string_view code);
/// Whether the name that stands there is one that meant_by() tells.
[[nodiscard]] bool is_misspelt_at(const ProgramAnalysis& analysis, Span span);

/// Whether the control brings a program of that name, one of its cycles: CYCLE81, and so CYCLE89, which
/// differs in its number alone.
[[nodiscard]] bool is_brought_by_control(const ControlModel& control, std::string_view name);

} // namespace maclint::queries
