//! What the client says of its texts, files and folders.
#pragma once

#include "cli/lsp/server/session.hpp"

namespace maclint::cli::lsp {

Json did_open(Session& session, const Json& params);
Json did_change(Session& session, const Json& params);
Json did_save(Session& session, const Json& params);
Json did_close(Session& session, const Json& params);
Json did_change_watched_files(Session& session, const Json& params);
Json did_change_folders(Session& session, const Json& params);
/// `window/workDoneProgress/cancel`.
Json cancel_progress(Session& session, const Json& params);

} // namespace maclint::cli::lsp
