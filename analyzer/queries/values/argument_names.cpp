//! Asks the control's tables for the letter.
#include "analyzer/queries/values/argument_names.hpp"

#include "analyzer/program/tables.hpp"

namespace maclint::queries {

std::string with_letter(const Program& program, Variable variable) {
    const std::string name = program.spell(variable);
    const auto letter = program.control->letter_of(variable);
    return letter ? name + " (" + *letter + ")" : name;
}

} // namespace maclint::queries
