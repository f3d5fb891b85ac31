//! Numbers of blocks first: they are digits of words that may mean something else, too.
#include "cli/lsp/features/references.hpp"

#include "cli/lsp/features/block_numbers.hpp"
#include "cli/lsp/features/contour_names.hpp"
#include "cli/lsp/mentions/sightings.hpp"

#include <iterator>
#include <map>
#include <utility>

namespace maclint::cli::lsp {
namespace {

using Role = Mention::Role;

/// DocumentHighlightKind of LSP.
constexpr int read_kind = 2, write_kind = 3;

bool is_of_program(const PointedName& name) {
    return std::holds_alternative<ProgramName>(name.mention.named);
}

void add_calls(Session& session, const ProgramMap& map, ProgramPlace program, Json& list) {
    std::map<std::size_t, std::shared_ptr<const ReadText>> texts; // a file calls many times
    for (const CallPlace& place : map.calls_of(program)) {
        const auto [entry, is_new] = texts.try_emplace(place.caller.file);
        if (is_new) entry->second = text_of(session, map.path_of(place.caller.file));
        const auto& text = entry->second;
        if (text == nullptr || place.caller.program >= text->programs().programs.size()) continue;
        const Program& caller = text->programs().programs[place.caller.program];
        const auto calls = calls_in(caller);
        if (place.call >= calls.size()) continue;
        if (const auto mention = mention_of_call(caller, calls[place.call]))
            list.push_back(location(*text, mention->span));
    }
}

Json of_programs(Session& session, const PointedName& name, bool with_declaration) {
    Json list = Json::array();
    const PointedPrograms meant = programs_of(session, name);
    for (const ProgramPlace& place : meant.places) {
        const auto text = with_declaration ? text_of(session, meant.map->path_of(place.file)) : nullptr;
        if (text != nullptr && place.program < text->programs().programs.size())
            if (const Program& program = text->programs().programs[place.program]; !program.name_span.empty())
                list.push_back(location(*text, program.name_span));
        add_calls(session, *meant.map, place, list);
    }
    return list;
}

} // namespace

Json references(Session& session, const Json& params) {
    if (Json blocks = block_references(session, params); !blocks.is_null()) return blocks;
    if (Json contours = contour_references(session, params); !contours.is_null()) return contours;
    Json list = Json::array();
    const auto name = name_pointed_at(session, params);
    if (!name) return list;
    const bool with_declaration = is_true(params, {"context", "includeDeclaration"});
    if (is_of_program(*name)) return of_programs(session, *name, with_declaration);
    std::vector<Sighting> all = sightings_in_text(*name);
    std::vector<Sighting> others = sightings_elsewhere(session, *name);
    std::ranges::move(others, std::back_inserter(all));
    for (const Sighting& each : all)
        if (with_declaration || each.mention.role != Role::declares)
            list.push_back(location(*each.text, each.mention.span));
    return list;
}

Json document_highlight(Session& session, const Json& params) {
    if (Json blocks = block_highlight(session, params); !blocks.is_null()) return blocks;
    if (Json contours = contour_highlight(session, params); !contours.is_null()) return contours;
    Json list = Json::array();
    const auto name = name_pointed_at(session, params);
    if (!name || is_of_program(*name)) return list;
    for (const Sighting& each : sightings_in_text(*name))
        list.push_back({{"range", each.text->lines.range(each.mention.span)},
                        {"kind", each.mention.role == Role::reads ? read_kind : write_kind}});
    return list;
}

} // namespace maclint::cli::lsp
