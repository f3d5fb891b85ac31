//! Each word of the client becomes a state of the session and work for the analyst.
#include "cli/lsp/server/synchronisation.hpp"

#include "analyzer/dialect/dialect.hpp"
#include "cli/config/configuration.hpp"
#include "cli/lsp/documents/uri_path.hpp"

#include <algorithm>

namespace maclint::cli::lsp {
namespace {

/// Files whose change can change a finding or which files are looked at.
bool matters(std::string_view path) {
    const std::string_view name = path.substr(path.rfind('/') + 1);
    return name == configuration_name || name == ".gitignore" || has_nc_extension(path) ||
           name.find('.') == std::string_view::npos || name.ends_with(".json");
}

void forget_files(Session& session) {
    session.reader.forget();
    session.analyst.folders_changed();
}

std::vector<std::string> paths_in(const Json& folders) {
    std::vector<std::string> paths;
    if (folders.is_array())
        for (const Json& folder : folders)
            if (auto path = path_of_uri(string_in(folder, "uri"))) paths.push_back(*std::move(path));
    return paths;
}

} // namespace

Json did_open(Session& session, const Json& params) {
    session.documents.open(member(params, "textDocument"));
    session.analyst.documents_changed(session.documents.all());
    return nullptr;
}

Json did_change(Session& session, const Json& params) {
    session.documents.change(params, session.client.encoding);
    session.analyst.documents_changed(session.documents.all());
    return nullptr;
}

/// Others may call what was saved: all are looked at again.
Json did_save(Session& session, const Json& /*params*/) {
    forget_files(session);
    return nullptr;
}

Json did_close(Session& session, const Json& params) {
    const Document closed = session.documents.close(document_uri(params));
    session.reader.forget();
    session.analyst.document_closed(session.documents.all(), closed);
    return nullptr;
}

Json did_change_watched_files(Session& session, const Json& params) {
    const Json& changes = member(params, "changes");
    const bool any = changes.is_array() && std::ranges::any_of(changes, [](const Json& change) {
                         const auto path = path_of_uri(string_in(change, "uri"));
                         return path && matters(*path);
                     });
    if (any) forget_files(session);
    return nullptr;
}

Json did_change_folders(Session& session, const Json& params) {
    const Json& event = member(params, "event");
    std::vector<std::string> folders = session.files.folders();
    for (const std::string& gone : paths_in(member(event, "removed"))) std::erase(folders, gone);
    for (std::string& added : paths_in(member(event, "added"))) folders.push_back(std::move(added));
    session.files.set_folders(std::move(folders));
    forget_files(session);
    return nullptr;
}

Json cancel_progress(Session& session, const Json& params) {
    session.analyst.cancel_folders(member(params, "token"));
    return nullptr;
}

} // namespace maclint::cli::lsp
