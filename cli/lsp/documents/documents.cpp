//! Each change makes a new text; whoever analyses the old one keeps it.
#include "cli/lsp/documents/documents.hpp"

#include "cli/lsp/documents/uri_path.hpp"

#include <limits>
#include <utility>

namespace maclint::cli::lsp {
namespace {

Source text_from(const std::string& path, std::string text) {
    if (text.size() >= std::numeric_limits<Offset>::max())
        throw ResponseError{ErrorCode::invalid_params,
                            "A text of 4 GiB or more is not read. Split the program."};
    Source source = Source::from_bytes(path, std::move(text));
    return source.encoding() == Encoding::utf8 ? source : source.read_as(Encoding::utf8);
}

/// The text after one change: of a part, or the whole.
Source changed(const Document& document, const Json& change, PositionEncoding encoding) {
    const std::string& text = string_in(change, "text");
    const Json* range = find(change, {"range"});
    if (range == nullptr || range->is_null()) return text_from(document.path, text);
    const Span span = LineTable(document.text, encoding).span(*range);
    std::string whole(document.text.bytes());
    whole.replace(span.begin, span.length(), text);
    return text_from(document.path, std::move(whole));
}

} // namespace

const std::string& document_uri(const Json& params) {
    return string_in(member(params, "textDocument"), "uri");
}

const Document& Documents::open(const Json& item) {
    const std::string& uri = string_in(item, "uri");
    const auto path = path_of_uri(uri);
    const Json* language = lsp::find(item, {"languageId"});
    Document document{uri,
                      path.value_or(uri),
                      path.has_value(),
                      language != nullptr && language->is_string() ? language->get<std::string>() : "",
                      integer_in(item, "version"),
                      text_from(path.value_or(uri), string_in(item, "text"))};
    return by_uri_.insert_or_assign(uri, std::move(document)).first->second;
}

const Document& Documents::change(const Json& params, PositionEncoding encoding) {
    const auto found = by_uri_.find(document_uri(params));
    if (found == by_uri_.end()) (void)at(document_uri(params));
    Document document = found->second;
    document.version = integer_in(member(params, "textDocument"), "version");
    const Json& changes = member(params, "contentChanges");
    if (!changes.is_array())
        throw ResponseError{ErrorCode::invalid_params, "'contentChanges' is no list. Send one."};
    for (const Json& one : changes) document.text = changed(document, one, encoding);
    return found->second = std::move(document);
}

Document Documents::close(std::string_view uri) {
    Document closed = at(uri);
    by_uri_.erase(by_uri_.find(uri));
    return closed;
}

const Document* Documents::find(std::string_view uri) const {
    const auto found = by_uri_.find(uri);
    return found == by_uri_.end() ? nullptr : &found->second;
}

const Document* Documents::find_path(std::string_view path) const {
    for (const auto& [uri, document] : by_uri_)
        if (document.path == path) return &document;
    return nullptr;
}

const Document& Documents::at(std::string_view uri) const {
    if (const Document* found = find(uri)) return *found;
    throw ResponseError{ErrorCode::invalid_params,
                        "'" + std::string(uri) + "' is not open. Send textDocument/didOpen first."};
}

std::vector<Document> Documents::all() const {
    std::vector<Document> list;
    for (const auto& [uri, document] : by_uri_) list.push_back(document);
    return list;
}

} // namespace maclint::cli::lsp
