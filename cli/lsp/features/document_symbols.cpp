//! Plain blocks are only read again in runs that hold a T word: an outline of 50 MB takes no longer than
//! that.
#include "cli/lsp/features/document_symbols.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/model.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/contours/contour_names.hpp"
#include "cli/lsp/features/read_document.hpp"

#include <algorithm>
#include <utility>

namespace maclint::cli::lsp {
namespace {

/// SymbolKind of LSP.
enum class SymbolKind : std::uint8_t { module = 2, section = 3, function = 12, label = 20, tool = 24 };

struct Symbol {
    std::string name;
    SymbolKind kind;
    Span whole, shown;
    std::string detail = {};
};

/// What a comment in the line says, without its brackets; empty: there is none.
std::string comment_in(std::string_view line, const Dialect& dialect) {
    const std::size_t begin = line.find(dialect.comment_open);
    if (begin == std::string_view::npos) return {};
    std::string_view inside = line.substr(begin + dialect.comment_open.size());
    if (!dialect.comment_close.empty()) inside = inside.substr(0, inside.find(dialect.comment_close));
    const std::size_t first = inside.find_first_not_of(' ');
    if (first == std::string_view::npos) return {};
    return std::string(inside.substr(first, inside.find_last_not_of(' ') + 1 - first));
}

class Outline {
  public:
    Outline(const ReadText& text, const Program& program, const queries::ContourNames& contours)
        : text_(text)
        , program_(program) {
        add_sections();
        add_contours(contours);
        add_tools();
        add_names();
        std::ranges::stable_sort(symbols_, {}, [](const Symbol& symbol) { return symbol.shown.begin; });
    }

    [[nodiscard]] Symbol of_program() const {
        const Span shown =
            program_.name_span.empty() ? Span{program_.span.begin, program_.span.begin} : program_.name_span;
        return {program_.name, SymbolKind::function, join(program_.span, shown), shown,
                comment_at(shown.begin)};
    }
    [[nodiscard]] const std::vector<Symbol>& inside() const { return symbols_; }

  private:
    [[nodiscard]] std::string comment_at(Offset offset) const {
        const std::string_view line = text_.source().bytes(text_.lines.line(text_.lines.line_of(offset)));
        return text_.source().to_utf8(comment_in(line, text_.dialect()));
    }

    void add_sections() {
        for (const Section& section : program_.sections) {
            if (section.heading.empty()) continue;
            Span whole = section.heading;
            if (section.items.count != 0)
                whole = join(whole, program_.span_of(section.items.first + section.items.count - 1));
            symbols_.push_back({std::string(section.kind), SymbolKind::section, whole, section.heading});
        }
    }

    void add_contours(const queries::ContourNames& contours) {
        Span whole = program_.span; // headings before the first block are not in it
        for (const Section& section : program_.sections)
            if (!section.heading.empty()) whole = join(whole, section.heading);
        for (const queries::ContourName& contour : contours.described)
            if (whole.begin <= contour.span.begin && contour.span.end <= whole.end)
                symbols_.push_back(
                    {text_.source().to_utf8(contour.name), SymbolKind::label, contour.span, contour.span});
    }

    void add_tools() {
        const auto tool = addresses_named(program_, "T");
        const auto holds_tool = [&](const WordSummary& words) { return words.addresses.meets(tool); };
        for_each_block_with_words(
            program_, holds_tool,
            [&](const BlockView& block, std::span<const Word> words, const auto& /*summary*/) {
                for (const Word& word : words)
                    if (word.address == "T" && word.has_value()) add_tool(block, word);
            });
    }

    void add_tool(const BlockView& block, const Word& word) {
        symbols_.push_back({text_.source().to_utf8(program_.slice(word.span)), SymbolKind::tool, block.span,
                            word.span, comment_at(block.span.begin)});
    }

    void add_names() {
        for (const Item& item : program_.items)
            if (const auto* block = std::get_if<Block>(&item); block != nullptr && block->name)
                symbols_.push_back(
                    {program_.spell(Label(*block->name)), SymbolKind::label, block->span, block->name_span});
    }

    const ReadText& text_;
    const Program& program_;
    std::vector<Symbol> symbols_;
};

Json nested(const Symbol& symbol, const LineTable& lines) {
    Json json = {{"name", symbol.name},
                 {"kind", static_cast<int>(symbol.kind)},
                 {"range", lines.range(symbol.whole)},
                 {"selectionRange", lines.range(symbol.shown)}};
    if (!symbol.detail.empty()) json["detail"] = symbol.detail;
    return json;
}

/// SymbolInformation, for clients that know no trees.
Json flat(const Symbol& symbol, const ReadText& text, const std::string& within) {
    Json json = {{"name", symbol.name},
                 {"kind", static_cast<int>(symbol.kind)},
                 {"location", {{"uri", text.uri}, {"range", text.lines.range(symbol.whole)}}}};
    if (!within.empty()) json["containerName"] = within;
    return json;
}

} // namespace

Json document_symbols(Session& session, const Json& params) {
    const auto text = read_document(session, params);
    Json list = Json::array();
    if (text == nullptr) return list;
    const queries::ContourNames contours = queries::contour_names(text->programs());
    for (const Program& program : text->programs().programs) {
        const Outline outline(*text, program, contours);
        const Symbol whole = outline.of_program();
        if (!session.client.nested_symbols) {
            list.push_back(flat(whole, *text, ""));
            for (const Symbol& symbol : outline.inside()) list.push_back(flat(symbol, *text, whole.name));
            continue;
        }
        Json json = nested(whole, text->lines);
        json["children"] = Json::array();
        for (const Symbol& symbol : outline.inside()) json["children"].push_back(nested(symbol, text->lines));
        list.push_back(std::move(json));
    }
    return list;
}

} // namespace maclint::cli::lsp
