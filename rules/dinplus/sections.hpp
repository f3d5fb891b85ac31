//! What the sections of a program say about it.
#pragma once

#include "analyzer/program/model.hpp"

namespace maclint::rules {

/// A program that an operator starts and that is there from its beginning: it names itself, has a head, or is
/// closed. The blocks of a fragment prove nothing by what they lack.
[[nodiscard]] bool is_whole_main_program(const Program& program);

[[nodiscard]] bool has_section(const Program& program, const SectionKind& kind);

/// The line that begins the first section; empty when there is none.
[[nodiscard]] Span first_heading(const Program& program);

} // namespace maclint::rules
