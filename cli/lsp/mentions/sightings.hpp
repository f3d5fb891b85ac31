//! All places that mean the same as one: in its text, in the texts of the folders.
#pragma once

#include "cli/lsp/mentions/place.hpp"
#include "cli/lsp/server/session.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace maclint::cli::lsp {

/// A mention with the text that it stands in.
struct Sighting {
    std::shared_ptr<const ReadText> text;
    Mention mention;
};

/// A name that was pointed at.
struct PointedName {
    std::shared_ptr<const ReadText> text;
    std::size_t program; ///< place in the text's programs
    Mention mention;

    [[nodiscard]] const Program& of() const { return text->programs().programs[program]; }
};

/// Nothing where the document is no program, or names nothing there.
[[nodiscard]] std::optional<PointedName> name_pointed_at(Session& session, const Json& params);

/// Mentions of the same in one program of the text, in the order of the text; not of programs.
[[nodiscard]] std::vector<Mention> mentions_of(const PointedName& name, const Program& program);
/// In all programs of the text that may mean the same.
[[nodiscard]] std::vector<Sighting> sightings_in_text(const PointedName& name);
/// In the other files of the folders, where programs share the thing. Looks through so many bytes at most as
/// a user waits for, and writes into the client's log where that was not all.
[[nodiscard]] std::vector<Sighting> sightings_elsewhere(Session& session, const PointedName& name);

/// The calls of a program in the order of its outline.
[[nodiscard]] std::vector<EffectId> calls_in(const Program& program);
/// The mention of the program that the call names; nothing where the text names none.
[[nodiscard]] std::optional<Mention> mention_of_call(const Program& program, EffectId call);

/// The text of a file of the map: that of the editor, or its names and calls from the disk.
[[nodiscard]] std::shared_ptr<const ReadText> text_of(Session& session, const std::string& path);
/// The map, and where the pointed program, or what the pointed call means, lies in it.
struct PointedPrograms {
    std::shared_ptr<const ProgramMap> map;
    std::vector<ProgramPlace> places;
};
[[nodiscard]] PointedPrograms programs_of(Session& session, const PointedName& name);

/// `{"uri": …, "range": …}`
[[nodiscard]] Json location(const ReadText& text, Span span);

} // namespace maclint::cli::lsp
