//! What is declared is there; else what is stored.
#include "cli/lsp/features/definition.hpp"

#include "analyzer/workspace/bind.hpp"
#include "cli/lsp/features/block_numbers.hpp"
#include "cli/lsp/features/contour_names.hpp"
#include "cli/lsp/mentions/sightings.hpp"

#include <algorithm>
#include <utility>

namespace maclint::cli::lsp {
namespace {

using Role = Mention::Role;

Json with_role(const std::vector<Sighting>& sightings, Role role) {
    Json list = Json::array();
    for (const Sighting& each : sightings)
        if (each.mention.role == role) list.push_back(location(*each.text, each.mention.span));
    return list;
}

/// Declarations; stores where there are none.
Json places_made(const std::vector<Sighting>& sightings) {
    Json declared = with_role(sightings, Role::declares);
    return declared.empty() ? with_role(sightings, Role::stores) : declared;
}

Span place_of(const Program& program) {
    return program.name_span.empty() ? Span{program.span.begin, program.span.begin} : program.name_span;
}

/// In the called program: the parameter, or the first place that names its variable.
Span place_of_argument(const PointedName& name, const Program& called) {
    const auto& argument = std::get<ArgumentName>(name.mention.named);
    const auto& call = std::get<Call>(name.of().effects[argument.call].what);
    const auto variable = bound_to(name.of().arguments_of(call)[argument.place], &called);
    if (!variable) return place_of(called);
    for (const Formal& formal : called.formals)
        if (formal.variable == *variable && !formal.span.empty()) return formal.span;
    Span first{};
    for_each_mention(called, [&](const Mention& mention) {
        const auto* named = std::get_if<Variable>(&mention.named);
        if (named != nullptr && *named == *variable && (first.empty() || mention.span.begin < first.begin))
            first = mention.span;
    });
    return first.empty() ? place_of(called) : first;
}

Json of_programs(Session& session, const PointedName& name) {
    const bool is_argument = std::holds_alternative<ArgumentName>(name.mention.named);
    const PointedPrograms meant = programs_of(session, name);
    Json list = Json::array();
    for (const ProgramPlace& place : meant.places) {
        const std::string& path = meant.map->path_of(place.file);
        const Document* document = session.documents.find_path(path);
        const auto text = !is_argument || document != nullptr
                              ? text_of(session, path)
                              : session.reader.read_file(path, session.client.encoding, Extent::whole);
        if (text == nullptr || place.program >= text->programs().programs.size()) continue;
        const Program& program = text->programs().programs[place.program];
        list.push_back(location(*text, is_argument ? place_of_argument(name, program) : place_of(program)));
    }
    return list;
}

} // namespace

Json definition(Session& session, const Json& params) {
    if (Json block = block_definition(session, params); !block.is_null()) return block;
    if (Json contour = contour_definition(session, params); !contour.is_null()) return contour;
    const auto name = name_pointed_at(session, params);
    if (!name) return nullptr;
    const Named& named = name->mention.named;
    const bool is_of_program =
        std::holds_alternative<ProgramName>(named) || std::holds_alternative<ArgumentName>(named);
    Json list = is_of_program ? of_programs(session, *name) : places_made(sightings_in_text(*name));
    if (list.empty() && !is_of_program) list = places_made(sightings_elsewhere(session, *name));
    return list.empty() ? Json(nullptr) : list;
}

} // namespace maclint::cli::lsp
