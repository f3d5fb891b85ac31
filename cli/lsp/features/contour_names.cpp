//! The names are those that rules compare.
#include "cli/lsp/features/contour_names.hpp"

#include "analyzer/queries/contours/contour_names.hpp"
#include "cli/lsp/features/read_document.hpp"
#include "cli/lsp/features/workspace_edit.hpp"
#include "cli/lsp/mentions/sightings.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace maclint::cli::lsp {
namespace {

using queries::ContourName;

struct ContourPlace {
    Span name;
    bool describes;
};

/// A name that was pointed at, and all places that mean the same.
struct PointedContour {
    std::shared_ptr<const ReadText> text;
    queries::ContourNames all;
    Span here{};
    std::vector<ContourPlace> places = {};
};

/// Within its quotation marks.
Span span_of_name(const ReadText& text, const ContourName& name) {
    const auto begin = static_cast<Offset>(name.name.data() - text.programs().source->bytes().data());
    return {begin, begin + static_cast<Offset>(name.name.size())};
}

std::optional<PointedContour> contour_at(Session& session, const Json& params) {
    auto text = read_document(session, params);
    if (text == nullptr) return std::nullopt;
    const Offset at = text->lines.offset(member(params, "position"));
    PointedContour pointed{text, queries::contour_names(text->programs())};
    const ContourName* here = nullptr;
    for (const auto* list : {&pointed.all.described, &pointed.all.wanted})
        for (const ContourName& name : *list)
            if (touches(span_of_name(*text, name), at)) here = &name;
    if (here == nullptr) return std::nullopt;
    pointed.here = span_of_name(*text, *here);
    const auto add = [&](const std::vector<ContourName>& list, bool describes) {
        for (const ContourName& name : list)
            if (name.is_blank == here->is_blank && name.name == here->name)
                pointed.places.push_back({span_of_name(*text, name), describes});
    };
    add(pointed.all.described, true);
    add(pointed.all.wanted, false);
    std::ranges::sort(pointed.places, {}, [](const ContourPlace& place) { return place.name.begin; });
    return pointed;
}

[[noreturn]] void refuse_name(const std::string& why) { throw ResponseError{ErrorCode::request_failed, why}; }

void check_contour_name(const PointedContour& pointed, const std::string& name) {
    if (queries::squeezed(name).empty() || name.find_first_of("\"\r\n[]") != std::string::npos)
        refuse_name("'" + name + "' is no name of a contour. Write letters and figures.");
    for (const auto* list : {&pointed.all.described, &pointed.all.wanted})
        for (const ContourName& other : *list)
            if (other.name == name)
                refuse_name("'" + name + "' is the name of a contour already. Take another.");
    if (!pointed.all.is_complete)
        refuse_name("Subprograms describe contours of this program, too, and may know this one by its name. "
                    "Change it by hand.");
}

} // namespace

Json contour_definition(Session& session, const Json& params) {
    const auto pointed = contour_at(session, params);
    if (!pointed) return nullptr;
    Json list = Json::array();
    for (const ContourPlace& place : pointed->places)
        if (place.describes) list.push_back(location(*pointed->text, place.name));
    return list;
}

Json contour_references(Session& session, const Json& params) {
    const auto pointed = contour_at(session, params);
    if (!pointed) return nullptr;
    const bool with_declaration = is_true(params, {"context", "includeDeclaration"});
    Json list = Json::array();
    for (const ContourPlace& place : pointed->places)
        if (with_declaration || !place.describes) list.push_back(location(*pointed->text, place.name));
    return list;
}

Json contour_highlight(Session& session, const Json& params) {
    constexpr int read_kind = 2, write_kind = 3; // DocumentHighlightKind of LSP
    const auto pointed = contour_at(session, params);
    if (!pointed) return nullptr;
    Json list = Json::array();
    for (const ContourPlace& place : pointed->places)
        list.push_back({{"range", pointed->text->lines.range(place.name)},
                        {"kind", place.describes ? write_kind : read_kind}});
    return list;
}

Json contour_name(Session& session, const Json& params) {
    const auto pointed = contour_at(session, params);
    return pointed ? pointed->text->lines.range(pointed->here) : Json(nullptr);
}

Json rename_contour(Session& session, const Json& params) {
    const auto pointed = contour_at(session, params);
    if (!pointed) return nullptr;
    const std::string& name = string_in(params, "newName");
    check_contour_name(*pointed, name);
    std::vector<Edit> edits;
    for (const ContourPlace& place : pointed->places)
        edits.push_back({pointed->text->programs().source, place.name, name});
    return workspace_edit(session, edits);
}

} // namespace maclint::cli::lsp
