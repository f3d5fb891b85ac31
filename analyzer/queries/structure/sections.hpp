//! What the sections of a program say about it.
#pragma once

#include "analyzer/program/model.hpp"
#include "analyzer/program/section_kinds.hpp"

#include <vector>

namespace maclint::queries {

/// A program that an operator starts, that is divided into sections, and that is there from its beginning: it
/// names itself, has a head, or is closed. A fragment proves nothing by what it lacks, and the manual itself
/// writes short programs without any section but END.
[[nodiscard]] bool is_whole_main_program(const Program& program);

[[nodiscard]] bool has_section(const Program& program, const SectionKind& kind);
/// Whether one of the program's sections has the role; false for every role in a language without sections.
[[nodiscard]] bool has_section(const Program& program, SectionKind::Role role);

/// The words beside the section's name: "Z0" of `FACE_C Z0`. None where one of them is no address with a
/// number.
[[nodiscard]] std::vector<Word> heading_words(const Program& program, const Section& section);

/// The line that begins the first section; empty when there is none.
[[nodiscard]] Span first_heading(const Program& program);

} // namespace maclint::queries
