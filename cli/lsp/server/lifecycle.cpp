//! Capabilities of both sides.
#include "cli/lsp/server/lifecycle.hpp"

#include "cli/lsp/documents/uri_path.hpp"
#include "cli/lsp/features/features.hpp"

#include <utility>

namespace maclint::cli::lsp {
namespace {

/// The first that the client names and the server knows; without any UTF-16.
PositionEncoding encoding_of(const Json& params) {
    const Json* names = find(params, {"capabilities", "general", "positionEncodings"});
    if (names == nullptr || !names->is_array()) return PositionEncoding::utf16;
    for (const Json& name : *names) {
        if (name == "utf-8") return PositionEncoding::utf8;
        if (name == "utf-16") return PositionEncoding::utf16;
    }
    return PositionEncoding::utf16;
}

Client client_of(const Json& params) {
    const Json* found = find(params, {"capabilities"});
    const Json capabilities = found == nullptr ? Json::object() : *found;
    return {.encoding = encoding_of(params),
            .versioned_edits = is_true(capabilities, {"workspace", "workspaceEdit", "documentChanges"}),
            .progress = is_true(capabilities, {"window", "workDoneProgress"}),
            .registers_watchers =
                is_true(capabilities, {"workspace", "didChangeWatchedFiles", "dynamicRegistration"}),
            .nested_symbols = is_true(
                capabilities, {"textDocument", "documentSymbol", "hierarchicalDocumentSymbolSupport"})};
}

void add_folder(const Json* uri, std::vector<std::string>& folders) {
    if (uri == nullptr || !uri->is_string()) return;
    if (auto path = path_of_uri(uri->get_ref<const std::string&>())) folders.push_back(*std::move(path));
}

/// Clients from before workspace folders name one root.
std::vector<std::string> folders_of(const Json& params) {
    std::vector<std::string> folders;
    if (const Json* list = find(params, {"workspaceFolders"}); list != nullptr && list->is_array())
        for (const Json& folder : *list) add_folder(find(folder, {"uri"}), folders);
    if (folders.empty()) add_folder(find(params, {"rootUri"}), folders);
    return folders;
}

} // namespace

Json initialize(Session& session, const Json& params) {
    session.client = client_of(params);
    session.files.set_folders(folders_of(params));
    session.analyst.start(session.client.encoding, session.client.progress);
    Json capabilities = feature_capabilities();
    capabilities["positionEncoding"] = session.client.encoding == PositionEncoding::utf8 ? "utf-8" : "utf-16";
    constexpr int incremental = 2;
    capabilities["textDocumentSync"] = {{"openClose", true}, {"change", incremental}, {"save", true}};
    capabilities["workspace"] = {{"workspaceFolders", {{"supported", true}, {"changeNotifications", true}}}};
    return {{"capabilities", std::move(capabilities)},
            {"serverInfo", {{"name", "maclint"}, {"version", MACLINT_VERSION}}}};
}

Json initialized(Session& session, const Json& /*params*/) {
    if (session.client.registers_watchers)
        session.outbox.request("client/registerCapability",
                               {{"registrations",
                                 {{{"id", "maclint/files"},
                                   {"method", "workspace/didChangeWatchedFiles"},
                                   {"registerOptions", {{"watchers", {{{"globPattern", "**/*"}}}}}}}}}});
    session.analyst.folders_changed();
    return nullptr;
}

} // namespace maclint::cli::lsp
