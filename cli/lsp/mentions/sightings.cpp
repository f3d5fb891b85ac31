//! Texts in which the name's letters do not stand are not read.
#include "cli/lsp/mentions/sightings.hpp"

#include "analyzer/program/tables.hpp"
#include "cli/lsp/features/read_document.hpp"
#include "cli/renumber/connected_programs.hpp"
#include "cli/report/uri.hpp"
#include "cli/text/letters.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace maclint::cli::lsp {
namespace {

constexpr std::size_t most_searched = std::size_t{256} << 20U; ///< bytes of files that are opened
constexpr std::size_t most_read = std::size_t{32} << 20U;      ///< bytes of texts that are read as programs

/// What a text that mentions the thing must hold: the figures of a number, the letters of a name.
std::string letters_of(const PointedName& name) {
    const std::string_view written = name.of().slice(name.mention.span);
    constexpr std::string_view figures = "0123456789";
    const std::size_t first = written.find_first_of(figures);
    if (first != std::string_view::npos &&
        written.find_first_not_of(figures, first) == std::string_view::npos)
        return std::string(written.substr(first));
    return std::string(written.substr(0, written.find('[')));
}

bool holds(std::string_view text, std::string_view letters) {
    const auto same = [](char a, char b) { return a == b || (a ^ b) == ' '; };
    if (letters.find_first_not_of("0123456789") == std::string_view::npos)
        return text.find(letters) != std::string_view::npos;
    return !std::ranges::search(text, letters, same).empty();
}

void add_all(const PointedName& name, const std::shared_ptr<const ReadText>& text,
             std::vector<Sighting>& found) {
    for (const Program& program : text->programs().programs)
        for (Mention& mention : mentions_of(name, program)) found.push_back({text, std::move(mention)});
}

} // namespace

std::optional<PointedName> name_pointed_at(Session& session, const Json& params) {
    auto text = read_document(session, params);
    if (text == nullptr) return std::nullopt;
    const Offset at = text->lines.offset(member(params, "position"));
    const auto program = program_at(text->programs(), at);
    if (!program || is_in_comment(*text, at)) return std::nullopt;
    auto mention = mention_at(text->programs().programs[*program], at);
    if (!mention) return std::nullopt;
    return PointedName{std::move(text), *program, *std::move(mention)};
}

std::vector<Mention> mentions_of(const PointedName& name, const Program& program) {
    std::vector<Mention> found;
    const Named& named = name.mention.named;
    const auto take = [&](const Mention& mention) {
        if (name_the_same(name.of(), named, program, mention.named)) found.push_back(mention);
    };
    if (std::holds_alternative<ToolName>(named))
        for_each_tool(program, take);
    else
        for_each_mention(program, take);
    const auto begin_of = [](const Mention& mention) { return mention.span.begin; };
    std::ranges::stable_sort(found, {}, begin_of);
    const auto again = std::ranges::unique(found, {}, begin_of); // a parameter is declared, too
    found.erase(again.begin(), again.end());
    return found;
}

std::vector<Sighting> sightings_in_text(const PointedName& name) {
    std::vector<Sighting> found;
    add_all(name, name.text, found);
    return found;
}

std::vector<Sighting> sightings_elsewhere(Session& session, const PointedName& name) {
    std::vector<Sighting> found;
    if (!is_shared(name.of(), name.mention.named)) return found;
    const std::string letters = letters_of(name);
    const Snapshot around = session.files.snapshot(session.documents.all(), Asked::documents);
    std::size_t searched = 0, read = 0;
    for (const SnapshotFile& file : around.files) {
        if (file.input.path == name.text->source().path()) continue;
        if (searched > most_searched || read > most_read) {
            session.outbox.log("maclint: the folders hold more than is searched at once; uses of '" +
                               letters + "' from " + file.input.path + " on are not shown.");
            break;
        }
        const auto opened = open_file(file);
        const auto* source = std::get_if<Source>(&opened);
        if (source == nullptr) continue;
        searched += source->size();
        if (!holds(source->bytes(), letters)) continue;
        read += source->size();
        const Document* document = session.documents.find_path(file.input.path);
        const auto text =
            document != nullptr
                ? session.reader.read(*document, session.client.encoding)
                : session.reader.read_file(file.input.path, session.client.encoding, Extent::whole);
        if (text != nullptr) add_all(name, text, found);
    }
    return found;
}

std::vector<EffectId> calls_in(const Program& program) {
    std::vector<EffectId> calls;
    for_each_effect(program, [&](EffectId id) {
        if (std::holds_alternative<Call>(program.effects[id].what)) calls.push_back(id);
    });
    return calls;
}

std::optional<Mention> mention_of_call(const Program& program, EffectId call) {
    const auto& what = std::get<Call>(program.effects[call].what).program;
    Span span{};
    if (const auto* text = std::get_if<Text>(&what)) span = text->characters;
    if (const auto* expression = std::get_if<ExpressionId>(&what))
        span = program.expressions[*expression].span;
    if (span.empty()) return std::nullopt;
    return Mention{Mention::Role::reads, span, ProgramName{call}};
}

std::shared_ptr<const ReadText> text_of(Session& session, const std::string& path) {
    if (const Document* document = session.documents.find_path(path))
        return session.reader.read(*document, session.client.encoding);
    return session.reader.read_file(path, session.client.encoding, Extent::names_and_calls);
}

PointedPrograms programs_of(Session& session, const PointedName& name) {
    PointedPrograms found{session.programs.map(session.documents.all()), {}};
    const auto file = found.map->file_at(name.text->source().path());
    if (!file || name.program >= found.map->outlines()[*file].programs.size()) return found;
    const ProgramPlace here{*file, name.program};
    const auto* program = std::get_if<ProgramName>(&name.mention.named);
    const auto* argument = std::get_if<ArgumentName>(&name.mention.named);
    const std::optional<EffectId> call = argument != nullptr  ? std::optional(argument->call)
                                         : program != nullptr ? program->call
                                                              : std::nullopt;
    if (!call) {
        found.places = {here};
        return found;
    }
    const auto calls = calls_in(name.of());
    const auto number = static_cast<std::size_t>(std::ranges::find(calls, *call) - calls.begin());
    found.places = found.map->meant_by({here, number});
    return found;
}

Json location(const ReadText& text, Span span) {
    return {{"uri", text.uri}, {"range", text.lines.range(span)}};
}

} // namespace maclint::cli::lsp
