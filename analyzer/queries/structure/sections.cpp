//! Looks through the sections of a program.
#include "analyzer/queries/structure/sections.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/numbered_blocks.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

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

std::vector<Word> heading_words(const Program& program, const Section& section) {
    // The tables of descriptions: no word does anything there.
    const syntax::PlainTables* tables = program.plain_tables.back();
    const std::string_view text = program.text.substr(0, section.heading.end);
    std::vector<Word> words;
    const auto is_letter = [&](Offset at) { return std::isalpha(static_cast<unsigned char>(text[at])) != 0; };
    // The name has no digit behind its letters; a number may stand behind it (TURRET 1).
    Offset begin = section.heading.begin;
    for (Offset at = begin; at < text.size() && tables != nullptr;) {
        if (text[at] == '[' || text[at] == '"') break;
        if (!is_letter(at)) {
            begin = ++at;
            continue;
        }
        Offset end = at;
        while (end < text.size() && (is_letter(end) || text[end] == '_')) ++end;
        const bool is_block_number = begin == section.heading.begin && (text[at] == 'N' || text[at] == 'n');
        const bool has_number =
            end < text.size() && std::string_view("0123456789-+.").find(text[end]) != std::string_view::npos;
        if (has_number && !is_block_number) break;
        begin = at = end;
    }
    syntax::PlainBlock block;
    if (tables == nullptr || begin >= text.size() ||
        syntax::scan_block(text, begin, *tables, block) != syntax::Lane::plain)
        return words;
    syntax::scan_words(text, begin, *tables, block, [&](const syntax::PlainWord& word) {
        words.push_back({blocks::address_of(text, *tables, word), Literal{word.value, word.decimal_point},
                         word.incremental, word.span});
    });
    return words;
}

Span first_heading(const Program& program) {
    for (const Section& section : program.sections)
        if (section.heading.end > section.heading.begin) return section.heading;
    return {};
}

} // namespace maclint::queries
