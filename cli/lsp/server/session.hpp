//! What lasts from the first message to the last, for all features.
#pragma once

#include "cli/lsp/diagnostics/analyst.hpp"
#include "cli/lsp/diagnostics/finding_store.hpp"
#include "cli/lsp/documents/documents.hpp"
#include "cli/lsp/documents/program_finder.hpp"
#include "cli/lsp/documents/text_reader.hpp"
#include "cli/lsp/documents/workspace_files.hpp"
#include "cli/lsp/protocol/outbox.hpp"

namespace maclint::cli::lsp {

/// What the client said of itself.
struct Client {
    PositionEncoding encoding = PositionEncoding::utf16;
    bool versioned_edits = false;    ///< workspace.workspaceEdit.documentChanges
    bool progress = false;           ///< window.workDoneProgress
    bool registers_watchers = false; ///< workspace.didChangeWatchedFiles.dynamicRegistration
    bool nested_symbols = false;     ///< textDocument.documentSymbol.hierarchicalDocumentSymbolSupport
};

/// For the thread that reads messages, but for what says that it is for several.
struct Session {
    Session(Outbox::Write write, AnalystOptions options)
        : outbox(std::move(write))
        , reader(files)
        , analyst(files, findings, outbox, options)
        , programs(files, analyst.outlines()) {}

    Outbox outbox;
    Client client = {};
    Documents documents;
    WorkspaceFiles files;
    FindingStore findings;
    TextReader reader;
    Analyst analyst; ///< its thread uses the others
    ProgramFinder programs;
};

/// The answer to a request; of a notification it is dropped. Throws ResponseError.
using Handler = Json (*)(Session& session, const Json& params);

} // namespace maclint::cli::lsp
