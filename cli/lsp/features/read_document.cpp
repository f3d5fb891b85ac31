//! Read once a version.
#include "cli/lsp/features/read_document.hpp"

namespace maclint::cli::lsp {

std::shared_ptr<const ReadText> read_document(Session& session, const Json& params) {
    return session.reader.read(session.documents.at(document_uri(params)), session.client.encoding);
}

} // namespace maclint::cli::lsp
