//! Slides of heads, ASSIGNMENT and blocks.
#include "analyzer/dialect/dinplus/channels.hpp"

#include "analyzer/dialect/characters.hpp"

#include <algorithm>
#include <string>
#include <variant>

namespace maclint::dinplus {
namespace {

/// Of the entry `#SLIDE $1$2`, whatever language its name is in: no other entry has a slide as its value.
Channels channels_of_head(const Program& program) {
    Channels channels = 0;
    for (const Section& section : program.sections) {
        if (section.kind != "PROGRAM HEAD") continue;
        for (Id i = section.items.first; i < section.items.first + section.items.count; ++i) {
            const std::string_view entry = program.slice(program.span_of(i));
            const auto value = entry.find_first_of(" \t");
            if (!entry.starts_with('#') || value == std::string_view::npos) continue;
            const auto first = entry.find_first_not_of(" \t", value);
            if (first != std::string_view::npos && entry[first] == '$') channels |= channels_in(entry);
        }
    }
    return channels;
}

/// "$1, $2"
std::string spelled(Channels channels) {
    std::string list;
    for (unsigned channel = 0; channel < 10; ++channel)
        if ((channels & (1U << channel)) != 0) list += (list.empty() ? "$" : ", $") + std::to_string(channel);
    return list;
}

} // namespace

Channels channels_in(std::string_view text) {
    unsigned channels = 0;
    bool marked = false;
    for (const char c : text) {
        if (marked && is_digit(c)) channels |= 1U << static_cast<unsigned>(c - '0');
        marked = c == '$' || (marked && is_digit(c));
    }
    return static_cast<Channels>(channels);
}

void check_slides(const Program& program, std::vector<SyntaxError>& syntax_errors) {
    const Channels head = channels_of_head(program);
    if (head == 0) return;
    for (const Item& item : program.items) {
        const auto* block = std::get_if<Block>(&item);
        if (block == nullptr || (block->channels & ~head) == 0) continue;
        const auto unknown = static_cast<Channels>(block->channels & ~head);
        const std::string_view text = program.slice(block->span);
        const Offset length = static_cast<Offset>(text.find_first_not_of("$0123456789 \t/"));
        syntax_errors.push_back(
            {SyntaxErrorKind::slide_not_in_head,
             {block->span.begin,
              block->span.begin + std::max<Offset>(1, std::min(length, block->span.length()))},
             spelled(unknown),
             spelled(head)});
    }
}

void assign_channels(ProgramBuilder& builder) {
    const Program& program = builder.program();
    const Channels head = channels_of_head(program);
    builder.add_channels(head);
    Channels assigned = head;
    for (std::size_t i = 0; i < program.sections.size(); ++i) {
        const Section& section = program.sections[i];
        if (section.kind == "ASSIGNMENT") {
            const Channels named = channels_in(program.slice(section.heading));
            assigned = named != 0 ? named : head;
        }
        if (section.executed == Section::Executed::when_reached) builder.set_channels(i, assigned);
    }
}

} // namespace maclint::dinplus
