//! The shop's choice counts, not the options of the editor, which are about tabs and ends of lines.
#include "cli/lsp/features/formatting.hpp"

#include "analyzer/program/model.hpp"
#include "cli/format/spacing.hpp"
#include "cli/lsp/features/read_document.hpp"

namespace maclint::cli::lsp {
namespace {

constexpr std::size_t most_formatted = std::size_t{4} << 20U; ///< bytes, which take a second or two

Json blanks_in(const ReadText& text, Span part) {
    Json list = Json::array();
    const auto& configuration = text.file.settings.configuration;
    if (configuration == nullptr) return list;
    if (text.source().size() > most_formatted)
        throw ResponseError{ErrorCode::request_failed,
                            "Texts of more than 4 MB are not formatted. Split the program."};
    for (const Edit& edit : spacing_edits(text.programs(), text.dialect(), configuration->spacing, part))
        list.push_back({{"range", text.lines.range(edit.span)}, {"newText", edit.text}});
    return list;
}

} // namespace

Json formatting(Session& session, const Json& params) {
    const auto text = read_document(session, params);
    return text == nullptr ? Json::array() : blanks_in(*text, {0, text->source().size()});
}

Json range_formatting(Session& session, const Json& params) {
    const auto text = read_document(session, params);
    return text == nullptr ? Json::array() : blanks_in(*text, text->lines.span(member(params, "range")));
}

} // namespace maclint::cli::lsp
