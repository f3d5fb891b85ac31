//! Slides: which channels run the blocks of a program.
#pragma once

#include "analyzer/program/builder.hpp"
#include "analyzer/program/syntax_error.hpp"

#include <string_view>
#include <vector>

namespace maclint::dinplus {

/// The slides that a text names: `$1$3`, a digit each.
[[nodiscard]] Channels channels_in(std::string_view text);

/// Gives each section the slides of the blocks in it that name none, and the program all that it names:
/// `#SLIDE $1$2` of its head, ASSIGNMENT until the next one, and the marks of its blocks
/// [dinplus.md 2.2 and the heading ASSIGNMENT; l.2999-3015, l.10148]. The program must be complete.
void assign_channels(ProgramBuilder& builder);

/// Adds blocks that name a slide which the program head does not.
void check_slides(const Program& program, std::vector<SyntaxError>& syntax_errors);

} // namespace maclint::dinplus
