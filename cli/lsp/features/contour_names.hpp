//! Named contours of a text: where they are described, which blocks ask for them, another name. Null where no
//! such name is pointed at.
#pragma once

#include "cli/lsp/server/session.hpp"

namespace maclint::cli::lsp {

[[nodiscard]] Json contour_definition(Session& session, const Json& params);
/// Those that ask for it; with `context.includeDeclaration` also where it is described.
[[nodiscard]] Json contour_references(Session& session, const Json& params);
[[nodiscard]] Json contour_highlight(Session& session, const Json& params);
/// The range of the name.
[[nodiscard]] Json contour_name(Session& session, const Json& params);
/// Edits for `newName`; ResponseError where it cannot be another's name.
[[nodiscard]] Json rename_contour(Session& session, const Json& params);

} // namespace maclint::cli::lsp
