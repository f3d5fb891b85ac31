//! One list a file.
#include "cli/lsp/features/workspace_edit.hpp"

#include "cli/report/uri.hpp"

#include <optional>
#include <utility>

namespace maclint::cli::lsp {
namespace {

struct FileEdits {
    Json version; ///< null: it is not open
    Json edits = Json::array();
    std::optional<LineTable> lines;
};

Json versioned(const std::map<std::string, FileEdits>& files) {
    Json changes = Json::array();
    for (const auto& [uri, file] : files)
        changes.push_back(
            {{"textDocument", {{"uri", uri}, {"version", file.version}}}, {"edits", file.edits}});
    return {{"documentChanges", std::move(changes)}};
}

Json by_uri(const std::map<std::string, FileEdits>& files) {
    Json changes = Json::object();
    for (const auto& [uri, file] : files) changes[uri] = file.edits;
    return {{"changes", std::move(changes)}};
}

} // namespace

Json workspace_edit(const Session& session, std::span<const Edit> edits) {
    std::map<std::string, FileEdits> files;
    for (const Edit& edit : edits) {
        const Document* document = session.documents.find_path(edit.source->path());
        FileEdits& file = files[document == nullptr ? file_uri(edit.source->path()) : document->uri];
        if (document != nullptr) file.version = document->version;
        if (!file.lines) file.lines.emplace(*edit.source, session.client.encoding);
        file.edits.push_back({{"range", file.lines->range(edit.span)}, {"newText", edit.text}});
    }
    return session.client.versioned_edits ? versioned(files) : by_uri(files);
}

} // namespace maclint::cli::lsp
