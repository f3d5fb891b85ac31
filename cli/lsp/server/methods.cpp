//! A row for each method.
#include "cli/lsp/server/methods.hpp"

#include "cli/lsp/features/features.hpp"
#include "cli/lsp/server/lifecycle.hpp"
#include "cli/lsp/server/synchronisation.hpp"

#include <algorithm>
#include <array>

namespace maclint::cli::lsp {
namespace {

constexpr std::array<Method, 8> notifications{{
    {"initialized", initialized},
    {"textDocument/didOpen", did_open},
    {"textDocument/didChange", did_change},
    {"textDocument/didSave", did_save},
    {"textDocument/didClose", did_close},
    {"workspace/didChangeWatchedFiles", did_change_watched_files},
    {"workspace/didChangeWorkspaceFolders", did_change_folders},
    {"window/workDoneProgress/cancel", cancel_progress},
}};

template<class Rows>
Handler handler_in(const Rows& rows, std::string_view method) {
    const auto found = std::ranges::find(rows, method, &Method::name);
    return found == rows.end() ? nullptr : found->handle;
}

} // namespace

Handler request_handler(std::string_view method) { return handler_in(feature_methods(), method); }
Handler notification_handler(std::string_view method) { return handler_in(notifications, method); }

} // namespace maclint::cli::lsp
