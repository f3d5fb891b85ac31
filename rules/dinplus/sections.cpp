//! Looks through the sections of a program.
#include "rules/dinplus/sections.hpp"

#include "analyzer/program/numbered_blocks.hpp"

#include <algorithm>

namespace maclint::rules {

bool is_whole_main_program(const Program& program) {
    if (program.started == Program::Started::by_call || program.control->sections.empty()) return false;
    const SectionKind& head = program.control->sections.front();
    const bool closed = std::ranges::any_of(program.sections, [&](const Section& section) {
        const SectionKind* kind = kind_of(*program.control, section);
        return kind != nullptr && kind->role == SectionKind::Role::end;
    });
    const bool named = program.name_span.end > program.name_span.begin;
    return first_heading(program).end != 0 && (closed || named || has_section(program, head));
}

bool has_section(const Program& program, const SectionKind& kind) {
    return std::ranges::any_of(program.sections,
                               [&](const Section& section) { return section.kind == kind.name; });
}

Span first_heading(const Program& program) {
    for (const Section& section : program.sections)
        if (section.heading.end > section.heading.begin) return section.heading;
    return {};
}

} // namespace maclint::rules
