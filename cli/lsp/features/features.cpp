//! A row for each request.
#include "cli/lsp/features/features.hpp"

#include "cli/lsp/features/call_hierarchy.hpp"
#include "cli/lsp/features/code_actions.hpp"
#include "cli/lsp/features/commands.hpp"
#include "cli/lsp/features/completion.hpp"
#include "cli/lsp/features/definition.hpp"
#include "cli/lsp/features/document_symbols.hpp"
#include "cli/lsp/features/folding.hpp"
#include "cli/lsp/features/formatting.hpp"
#include "cli/lsp/features/hover.hpp"
#include "cli/lsp/features/inlay_hints.hpp"
#include "cli/lsp/features/references.hpp"
#include "cli/lsp/features/rename.hpp"
#include "cli/lsp/features/semantic_tokens.hpp"

#include <array>

namespace maclint::cli::lsp {
namespace {

constexpr std::array<Method, 20> methods{{
    {"callHierarchy/incomingCalls", incoming_calls},
    {"callHierarchy/outgoingCalls", outgoing_calls},
    {"completionItem/resolve", resolve_completion},
    {"textDocument/codeAction", code_actions},
    {"textDocument/completion", completion},
    {"textDocument/definition", definition},
    {"textDocument/documentHighlight", document_highlight},
    {"textDocument/documentSymbol", document_symbols},
    {"textDocument/foldingRange", folding_ranges},
    {"textDocument/formatting", formatting},
    {"textDocument/hover", hover},
    {"textDocument/inlayHint", inlay_hints},
    {"textDocument/prepareCallHierarchy", prepare_call_hierarchy},
    {"textDocument/prepareRename", prepare_rename},
    {"textDocument/rangeFormatting", range_formatting},
    {"textDocument/references", references},
    {"textDocument/rename", rename},
    {"textDocument/semanticTokens/full", semantic_tokens},
    {"textDocument/semanticTokens/range", semantic_tokens_in_range},
    {"workspace/executeCommand", execute_command},
}};

} // namespace

std::span<const Method> feature_methods() { return methods; }

Json feature_capabilities() {
    return {{"callHierarchyProvider", true},
            {"codeActionProvider", {{"codeActionKinds", {"quickfix", "source.fixAll.maclint"}}}},
            {"completionProvider", {{"triggerCharacters", {"#", "\""}}, {"resolveProvider", true}}},
            {"definitionProvider", true},
            {"documentHighlightProvider", true},
            {"documentFormattingProvider", true},
            {"documentRangeFormattingProvider", true},
            {"documentSymbolProvider", true},
            {"foldingRangeProvider", true},
            {"hoverProvider", true},
            {"inlayHintProvider", true},
            {"referencesProvider", true},
            {"semanticTokensProvider", semantic_tokens_options()},
            {"renameProvider", {{"prepareProvider", true}}},
            {"executeCommandProvider", {{"commands", command_names_of_server()}}}};
}

} // namespace maclint::cli::lsp
