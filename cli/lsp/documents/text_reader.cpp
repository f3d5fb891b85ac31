//! Files are read as the engine reads them.
#include "cli/lsp/documents/text_reader.hpp"

#include "analyzer/program/model.hpp"
#include "cli/report/uri.hpp"

#include <utility>

namespace maclint::cli::lsp {

std::shared_ptr<const ReadText> TextReader::read(const std::string& uri, SnapshotFile file,
                                                 PositionEncoding encoding, Extent extent) {
    auto opened = open_file(file);
    auto* source = std::get_if<Source>(&opened);
    if (source == nullptr) return nullptr;
    ReadFile read = read_source(file, std::make_shared<const Source>(std::move(*source)), extent, store_);
    if (read.file == nullptr || read.not_nc || read.dialect == nullptr) return nullptr;
    LineTable lines(*read.file->source, encoding);
    return std::make_shared<const ReadText>(
        ReadText{uri, std::move(file), std::move(read), std::move(lines), {}});
}

std::shared_ptr<const ReadText> TextReader::read(const Document& document, PositionEncoding encoding) {
    const auto kept = by_uri_.find(document.uri);
    if (kept != by_uri_.end() && kept->second.document.text.bytes().data() == document.text.bytes().data() &&
        kept->second.document.language == document.language)
        return kept->second.text;
    auto file = files_.file(document);
    auto text = file ? read(document.uri, *std::move(file), encoding, Extent::whole) : nullptr;
    by_uri_.insert_or_assign(document.uri, Kept{document, text});
    return text;
}

std::shared_ptr<const ReadText> TextReader::read_file(const std::string& path, PositionEncoding encoding,
                                                      Extent extent) {
    auto file = files_.file(path);
    return file ? read(file_uri(path), *std::move(file), encoding, extent) : nullptr;
}

void TextReader::forget() {
    by_uri_.clear();
    store_.drop_unused();
}

} // namespace maclint::cli::lsp
