//! Each block is parsed with its new blanks, and at last the whole file is read with them.
#include "cli/format/spacing.hpp"

#include "analyzer/dialect/spacing.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/dump.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <utility>

namespace maclint::cli {
namespace {

constexpr Offset longest_spaced = 4096; ///< longer ones the reader does not parse either

Blanks chosen(const SpacingChoice& choice, GapKind kind) {
    switch (kind) {
    case GapKind::words: return choice.words;
    case GapKind::operators: return choice.operators;
    case GapKind::brackets: return choice.brackets;
    }
    return Blanks::as_written;
}

class Spacer {
  public:
    Spacer(const ProgramFile& file, const Dialect& dialect, const SpacingChoice& choice)
        : file_(file)
        , choice_(choice)
        , reader_(spacing_of(dialect)) {}

    [[nodiscard]] std::vector<Edit> edits_in(Span block) {
        std::vector<Edit> edits;
        if (block.length() > longest_spaced) return edits;
        std::string after;
        Offset copied = block.begin;
        for (const Gap& gap : reader_.gaps_in(text(), block)) {
            const Blanks wanted = chosen(choice_, gap.kind);
            if (wanted == Blanks::as_written || (wanted == Blanks::none && !gap.may_close)) continue;
            const std::string_view blanks = wanted == Blanks::one ? " " : "";
            if (text().substr(gap.span.begin, gap.span.length()) == blanks) continue;
            edits.push_back({file_.source, gap.span, std::string(blanks)});
            after.append(text().substr(copied, gap.span.begin - copied)).append(blanks);
            copied = gap.span.end;
        }
        if (edits.empty()) return edits;
        after.append(text().substr(copied, block.end - copied));
        if (!reader_.read_the_same(text().substr(block.begin, block.length()), after)) edits.clear();
        return edits;
    }

  private:
    [[nodiscard]] std::string_view text() const { return file_.source->bytes(); }

    const ProgramFile& file_;
    const SpacingChoice& choice_;
    SpacingReader reader_;
};

/// The text with the edits, which are in its order.
std::string with_edits(std::string_view text, const std::vector<Edit>& edits) {
    std::string out;
    Offset copied = 0;
    for (const Edit& edit : edits) {
        out.append(text.substr(copied, edit.span.begin - copied)).append(edit.text);
        copied = edit.span.end;
    }
    return out.append(text.substr(copied));
}

bool means_the_same(const ProgramFile& file, const Dialect& dialect, const std::vector<Edit>& edits) {
    auto source = std::make_shared<const Source>(
        Source::from_bytes(file.source->path(), with_edits(file.source->bytes(), edits))
            .read_as(file.source->encoding()));
    return describe(dialect.read(source, *file.control, Extent::whole)) == describe(file);
}

} // namespace

std::vector<Edit> spacing_edits(const ProgramFile& file, const Dialect& dialect, const SpacingChoice& choice,
                                Span part) {
    std::vector<Edit> edits;
    if (choice == SpacingChoice()) return edits;
    Spacer spacer(file, dialect, choice);
    for (const Program& program : file.programs)
        for_each_block(program, [&](const BlockView& block) {
            if (block.span.end <= part.begin || part.end <= block.span.begin) return;
            std::ranges::move(spacer.edits_in(block.span), std::back_inserter(edits));
        });
    std::ranges::sort(edits, {}, [](const Edit& edit) { return edit.span.begin; });
    if (!edits.empty() && !means_the_same(file, dialect, edits)) edits.clear();
    return edits;
}

} // namespace maclint::cli
