//! Items carry the file and the place of their program; both are looked up anew for each question.
#include "cli/lsp/features/call_hierarchy.hpp"

#include "cli/lsp/features/read_document.hpp"
#include "cli/lsp/mentions/sightings.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace maclint::cli::lsp {
namespace {

constexpr int function_kind = 12; ///< SymbolKind of LSP

/// Programs of one moment, and the texts that were read of them.
class Calls {
  public:
    explicit Calls(Session& session)
        : session_(session)
        , map_(session.programs.map(session.documents.all())) {}

    [[nodiscard]] const ProgramMap& map() const { return *map_; }

    /// Null where the file cannot be read any more.
    [[nodiscard]] Json item(ProgramPlace place) {
        const auto text = text_at(place.file);
        const Program* program = program_in(text, place.program);
        if (program == nullptr) return nullptr;
        const Span name =
            program->name_span.empty() ? Span{program->span.begin, program->span.begin} : program->name_span;
        return {{"name", program->name},
                {"kind", function_kind},
                {"detail", map_->path_of(place.file).substr(map_->path_of(place.file).rfind('/') + 1)},
                {"uri", text->uri},
                {"range", text->lines.range(join(program->span, name))},
                {"selectionRange", text->lines.range(name)},
                {"data", {{"path", map_->path_of(place.file)}, {"program", place.program}}}};
    }

    /// The program of an item that the client gives back; nothing where it is gone.
    [[nodiscard]] std::optional<ProgramPlace> place_of(const Json& params) const {
        const Json& data = member(member(params, "item"), "data");
        const auto file = map_->file_at(string_in(data, "path"));
        const auto program = integer_in(data, "program");
        if (!file || program < 0 ||
            static_cast<std::size_t>(program) >= map_->outlines()[*file].programs.size())
            return std::nullopt;
        return ProgramPlace{*file, static_cast<std::size_t>(program)};
    }

    /// Where the call stands; nothing where it cannot be read any more.
    [[nodiscard]] std::optional<Json> range_of(const CallPlace& place) {
        const auto text = text_at(place.caller.file);
        const Program* program = program_in(text, place.caller.program);
        if (program == nullptr) return std::nullopt;
        const auto calls = calls_in(*program);
        if (place.call >= calls.size()) return std::nullopt;
        const auto mention = mention_of_call(*program, calls[place.call]);
        return text->lines.range(mention ? mention->span : program->effects[calls[place.call]].span);
    }

    /// A list of `{"from" or "to": item, "fromRanges": […]}`.
    [[nodiscard]] Json listed(const std::map<ProgramPlace, std::vector<CallPlace>>& calls,
                              const char* which) {
        Json list = Json::array();
        for (const auto& [program, places] : calls) {
            Json item_of_program = item(program);
            if (item_of_program.is_null()) continue;
            Json ranges = Json::array();
            for (const CallPlace& place : places)
                if (auto range = range_of(place)) ranges.push_back(*std::move(range));
            list.push_back({{which, std::move(item_of_program)}, {"fromRanges", std::move(ranges)}});
        }
        return list;
    }

  private:
    using Text = std::shared_ptr<const ReadText>;

    const Text& text_at(std::size_t file) {
        const auto [entry, is_new] = texts_.try_emplace(file);
        if (is_new) entry->second = text_of(session_, map_->path_of(file));
        return entry->second;
    }
    static const Program* program_in(const Text& text, std::size_t place) {
        if (text == nullptr || place >= text->programs().programs.size()) return nullptr;
        return &text->programs().programs[place];
    }

    Session& session_;
    std::shared_ptr<const ProgramMap> map_;
    std::map<std::size_t, Text> texts_;
};

} // namespace

Json prepare_call_hierarchy(Session& session, const Json& params) {
    const auto text = read_document(session, params);
    if (text == nullptr) return nullptr;
    const auto here = program_at(text->programs(), text->lines.offset(member(params, "position")));
    if (!here) return nullptr;
    Calls calls(session);
    std::vector<ProgramPlace> places;
    if (const auto name = name_pointed_at(session, params);
        name && std::holds_alternative<ProgramName>(name->mention.named))
        places = programs_of(session, *name).places;
    else if (const auto file = calls.map().file_at(text->source().path()))
        places = {{*file, *here}};
    Json items = Json::array();
    for (const ProgramPlace& place : places)
        if (Json item = calls.item(place); !item.is_null()) items.push_back(std::move(item));
    return items.empty() ? Json(nullptr) : items;
}

Json incoming_calls(Session& session, const Json& params) {
    Calls calls(session);
    const auto program = calls.place_of(params);
    std::map<ProgramPlace, std::vector<CallPlace>> callers;
    if (program)
        for (const CallPlace& call : calls.map().calls_of(*program)) callers[call.caller].push_back(call);
    return calls.listed(callers, "from");
}

Json outgoing_calls(Session& session, const Json& params) {
    Calls calls(session);
    const auto program = calls.place_of(params);
    std::map<ProgramPlace, std::vector<CallPlace>> called;
    if (program)
        for (std::size_t i = 0; i < calls.map().outline(*program).calls.size(); ++i)
            for (const ProgramPlace& place : calls.map().meant_by({*program, i}))
                called[place].push_back({*program, i});
    return calls.listed(called, "to");
}

} // namespace maclint::cli::lsp
