//! The text with the new name is read, and has to say the same with it.
#include "cli/lsp/features/rename.hpp"

#include "analyzer/program/language_words.hpp"
#include "analyzer/program/tables.hpp"
#include "cli/lsp/features/block_numbers.hpp"
#include "cli/lsp/features/contour_names.hpp"
#include "cli/lsp/features/workspace_edit.hpp"
#include "cli/lsp/mentions/name_letters.hpp"
#include "cli/lsp/mentions/sightings.hpp"
#include "cli/text/letters.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace maclint::cli::lsp {
namespace {

[[noreturn]] void refuse(const std::string& why) { throw ResponseError{ErrorCode::request_failed, why}; }

/// The name in what is written: `_la` of `#_la`.
Span name_in(const Program& program, Span written) {
    while (!written.empty() && !is_letter_of_name(program.text[written.begin])) ++written.begin;
    Span name{written.begin, written.begin};
    while (name.end < written.end && is_of_name(program.text[name.end])) ++name.end;
    return name;
}

/// Why the thing keeps its name; nothing: it may have another.
std::optional<std::string> objection(const PointedName& name) {
    const Program& program = name.of();
    if (std::holds_alternative<BlockName>(name.mention.named)) return std::nullopt;
    const auto* variable = std::get_if<Variable>(&name.mention.named);
    if (variable == nullptr) return "Only blocks and variables that the program declares get another name.";
    if (!program.control->spaces[variable->space].named)
        return "'" + program.spell(*variable) + "' is a number that the control or other programs know.";
    if (is_shared(program, *variable)) return "Other programs know the variable by this name.";
    if (program.declaration_of(*variable) == nullptr) return "The program does not declare the variable.";
    if (std::ranges::find(program.handed_down, *variable) != program.handed_down.end())
        return "Called programs know the variable by this name.";
    return std::nullopt;
}

/// Places of the name in the program's text outside of comments, mentioned or not.
std::vector<Span> places_written(const ReadText& text, const Program& program, std::string_view name) {
    std::vector<Span> places;
    const std::string wanted = in_upper_case(name);
    const std::string whole = in_upper_case(program.slice(program.span));
    for (std::size_t at = whole.find(wanted); at != std::string::npos; at = whole.find(wanted, at + 1)) {
        const std::size_t end = at + wanted.size();
        if ((at > 0 && is_of_name(whole[at - 1])) || (end < whole.size() && is_of_name(whole[end]))) continue;
        const Span span{program.span.begin + static_cast<Offset>(at),
                        program.span.begin + static_cast<Offset>(end)};
        if (!is_in_comment(text, span.begin)) places.push_back(span);
    }
    return places;
}

void check_new_name(const ReadText& text, const Program& program, const std::string& name) {
    constexpr std::size_t longest = 32; // NCP19: names of SINUMERIK have 31 letters
    if (name.size() < 2 || name.size() >= longest || !is_letter_of_name(name.front()) ||
        name.find('$') != std::string::npos || !std::ranges::all_of(name, is_of_name))
        refuse("'" + name + "' is no name. Write letters, figures and _, a letter at first.");
    const std::string capitals = in_upper_case(name);
    const auto words = text.dialect().words().words;
    if (std::ranges::find(words, capitals, &LanguageWord::word) != words.end())
        refuse("'" + name + "' is a word of the language. Take another.");
    if (!places_written(text, program, name).empty())
        refuse("'" + name + "' stands in the program already. Take another.");
}

/// What the program says of names, and what cannot be read in the file: the same before and after.
struct Sense {
    std::size_t errors, mentions, renamed;
    friend bool operator==(const Sense&, const Sense&) = default;
};

Sense sense_of(const ProgramFile& file, std::size_t place, const std::vector<Span>& names) {
    Sense sense{file.syntax_errors.size(), 0, 0};
    if (place >= file.programs.size()) return sense;
    for_each_mention(file.programs[place], [&](const Mention& mention) {
        ++sense.mentions;
        if (std::ranges::any_of(names, [&](Span name) { return touches(mention.span, name.begin); }))
            ++sense.renamed;
    });
    return sense;
}

void check_sense(const PointedName& name, const std::vector<Span>& names, const std::string& new_name) {
    std::string bytes(name.text->source().bytes());
    std::vector<Span> after;
    std::int64_t shift = 0;
    for (const Span old : names) {
        const auto begin = static_cast<Offset>(old.begin + shift);
        bytes.replace(begin, old.length(), new_name);
        after.push_back({begin, begin + static_cast<Offset>(new_name.size())});
        shift += static_cast<std::int64_t>(new_name.size()) - old.length();
    }
    const Source& before = name.text->source();
    auto source = std::make_shared<const Source>(
        Source::from_bytes(before.path(), std::move(bytes)).read_as(before.encoding()));
    const ProgramFile file = name.text->dialect().read(source, *name.text->programs().control, Extent::whole);
    if (sense_of(file, name.program, after) != sense_of(name.text->programs(), name.program, names))
        refuse("With '" + new_name + "' the program would be read in another way. Take another.");
}

} // namespace

Json prepare_rename(Session& session, const Json& params) {
    if (Json digits = block_digits(session, params); !digits.is_null()) return digits;
    if (Json contour = contour_name(session, params); !contour.is_null()) return contour;
    const auto name = name_pointed_at(session, params);
    if (!name) return nullptr;
    if (const auto why = objection(*name)) refuse(*why);
    return name->text->lines.range(name_in(name->of(), name->mention.span));
}

Json rename(Session& session, const Json& params) {
    const std::string& new_name = string_in(params, "newName");
    if (!block_digits(session, params).is_null()) return rename_block(session, params);
    if (Json edits = rename_contour(session, params); !edits.is_null()) return edits;
    const auto name = name_pointed_at(session, params);
    if (!name) refuse("Nothing that could get another name is here.");
    if (const auto why = objection(*name)) refuse(*why);
    const Program& program = name->of();
    check_new_name(*name->text, program, new_name);
    std::vector<Span> names;
    for (const Mention& mention : mentions_of(*name, program))
        names.push_back(name_in(program, mention.span));
    const std::string_view old = program.slice(name_in(program, name->mention.span));
    for (const Span place : places_written(*name->text, program, old))
        if (std::ranges::find(names, place) == names.end())
            refuse("'" + std::string(old) + "' stands in line " +
                   std::to_string(name->text->lines.line_of(place.begin) + 1) +
                   ", too, where nobody can tell what is meant. Change it by hand.");
    check_sense(*name, names, new_name);
    std::vector<Edit> edits;
    for (const Span span : names) edits.push_back({name->text->programs().source, span, new_name});
    return workspace_edit(session, edits);
}

} // namespace maclint::cli::lsp
