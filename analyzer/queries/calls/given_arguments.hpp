//! What calls give to parameters by their place.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <cstddef>
#include <functional>
#include <string_view>

namespace maclint::queries {

/// The argument at that place, from 0 on; nullptr where the call leaves it out.
[[nodiscard]] const Argument* argument_at(const Program& program, const Call& call, std::size_t place);

/// The type of what the argument gives, as the text spells it: that of a variable, of the program or of a
/// file of definitions, or what a text or number is. Empty where nobody knows.
[[nodiscard]] std::string_view type_given(const ProgramAnalysis& analysis, const Argument& argument);

/// The array that the argument names, of the program or of a file of definitions; nullptr: it names none.
[[nodiscard]] const ArrayDefinition* array_given(const ProgramAnalysis& analysis, const Argument& argument);

/// Each call by name of a program that is known, with that program.
void for_each_known_call(
    const ProgramAnalysis& analysis,
    const std::function<void(const CallSite& site, const Call& call, const ProgramAnalysis& called)>& visit);

} // namespace maclint::queries
