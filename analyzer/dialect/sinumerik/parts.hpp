//! Parts of a program that REPEAT and CALL BLOCK run once more.
#pragma once

#include "analyzer/dialect/sinumerik/open_program.hpp"

namespace maclint::sinumerik {

/// Writes what the parts do that the blocks of the program repeat. All of its labels must be known: a part
/// may stand behind the block that repeats it.
void follow_parts(OpenProgram& program);

} // namespace maclint::sinumerik
