//! The texts that the editor holds.
#pragma once

#include "analyzer/source/source.hpp"
#include "cli/lsp/documents/line_table.hpp"
#include "cli/lsp/protocol/json.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli::lsp {

/// Cheap to copy.
struct Document {
    std::string uri;      ///< as the client writes it
    std::string path;     ///< absolute; of what is no file the URI
    bool is_file = true;  ///< that lies, or may lie, on a disk
    std::string language; ///< id of the language in the editor
    std::int64_t version = 0;
    Source text; ///< in UTF-8
};

class Documents {
  public:
    /// Opened again, it is the new one.
    const Document& open(const Json& item);
    /// Full and incremental changes in their order; `encoding` of the positions.
    const Document& change(const Json& params, PositionEncoding encoding);
    /// Gives what was closed.
    Document close(std::string_view uri);
    /// ResponseError where it is not open.
    [[nodiscard]] const Document& at(std::string_view uri) const;
    [[nodiscard]] const Document* find(std::string_view uri) const;
    [[nodiscard]] const Document* find_path(std::string_view path) const;
    [[nodiscard]] std::vector<Document> all() const;

  private:
    std::map<std::string, Document, std::less<>> by_uri_;
};

/// The document that the parameters of a message name.
[[nodiscard]] const std::string& document_uri(const Json& params);

} // namespace maclint::cli::lsp
