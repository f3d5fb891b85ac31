//! Looks through the sections of a program.
#include "analyzer/queries/sections.hpp"

#include "analyzer/program/numbered_blocks.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>

namespace maclint::queries {

bool is_whole_main_program(const Program& program) {
    if (program.started == Program::Started::by_call || program.control->sections.empty()) return false;
    bool closed = false;
    bool divided = false;
    for (const Section& section : program.sections) {
        const SectionKind* kind = kind_of(*program.control, section);
        const bool ends = kind != nullptr && kind->role == SectionKind::Role::end;
        closed |= ends;
        divided |= kind != nullptr && !ends;
    }
    const bool named = program.name_span.end > program.name_span.begin;
    return divided && (closed || named || has_section(program, program.control->sections.front()));
}

bool has_section(const Program& program, const SectionKind& kind) {
    return std::ranges::any_of(program.sections,
                               [&](const Section& section) { return section.kind == kind.name; });
}

bool has_section(const Program& program, SectionKind::Role role) {
    return std::ranges::any_of(program.sections, [&](const Section& section) {
        const SectionKind* kind = kind_of(*program.control, section);
        return kind != nullptr && kind->role == role;
    });
}

Span first_heading(const Program& program) {
    for (const Section& section : program.sections)
        if (section.heading.end > section.heading.begin) return section.heading;
    return {};
}

} // namespace maclint::queries
