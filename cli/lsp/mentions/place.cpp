//! One look at one line; mentions are gone through once.
#include "cli/lsp/mentions/place.hpp"

#include "analyzer/program/item_at.hpp"
#include "cli/lsp/mentions/name_letters.hpp"

#include <algorithm>

namespace maclint::cli::lsp {
namespace {

bool holds(Span span, Offset at) { return span.begin <= at && at < span.end; }

/// P9100 is as good as its number.
Span with_address(const Program& program, const Mention& mention) {
    Span span = mention.span;
    const auto* name = std::get_if<ProgramName>(&mention.named);
    if (name != nullptr && name->call && span.begin > 0 && is_letter_of_name(program.text[span.begin - 1]))
        --span.begin;
    return span;
}

template<class IsOf>
Span run_at(std::string_view text, Offset at, const IsOf& is_of) {
    constexpr Offset longest = 200; // bytes of a name either way
    Span run{at, at};
    while (run.begin > 0 && at - run.begin < longest && is_of(text[run.begin - 1])) --run.begin;
    while (run.end < text.size() && run.end - at < longest && is_of(text[run.end])) ++run.end;
    return run;
}

} // namespace

std::optional<std::size_t> program_at(const ProgramFile& file, Offset at) {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < file.programs.size(); ++i) {
        const Program& program = file.programs[i];
        const Offset begin = program.name_span.empty()
                                 ? program.span.begin
                                 : std::min(program.span.begin, program.name_span.begin);
        if (begin <= at || file.programs.size() == 1) found = i;
    }
    return found;
}

std::optional<Mention> mention_at(const Program& program, Offset at) {
    std::optional<Mention> best;
    const auto is_better = [&](Span one, Span other) {
        if (holds(one, at) != holds(other, at)) return holds(one, at);
        return one.length() < other.length();
    };
    const auto consider = [&](const Mention& mention) {
        const Span whole = with_address(program, mention);
        if (touches(whole, at) && (!best || is_better(whole, with_address(program, *best)))) best = mention;
    };
    for_each_mention(program, consider);
    if (!best) for_each_tool(program, consider);
    return best;
}

std::vector<Word> words_at(const Program& program, const LineTable& lines, Offset at) {
    std::vector<Word> found;
    const Span line = lines.line(lines.line_of(at));
    const ItemId item = item_at(program, {0, static_cast<Id>(program.items.size())}, line.begin);
    if (item >= program.items.size()) return found;
    Span part = program.span_of(item);
    if (part.begin > at) return found;
    if (std::holds_alternative<PlainRun>(program.items[item]))
        part = {std::max(part.begin, line.begin), std::min(part.end, line.end)};
    if (part.end < part.begin) return found;
    for_each_block_with_words(program, Stretch{item, part},
                              [&](const BlockView& block, std::span<const Word> words) {
                                  if (touches(block.span, at)) found.assign(words.begin(), words.end());
                              });
    return found;
}

Span name_at(std::string_view text, Offset at) { return run_at(text, at, is_of_name); }
Span letters_at(std::string_view text, Offset at) { return run_at(text, at, is_letter_of_name); }

namespace {

/// MSG("row; column"): what stands between quotation marks opens no comment.
bool opens_outside_text(std::string_view line, std::string_view opening) {
    bool in_text = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') in_text = !in_text;
        if (!in_text && line.substr(i).starts_with(opening)) return true;
    }
    return false;
}

} // namespace

bool is_in_comment(const ReadText& text, Offset at) {
    const Span line = text.lines.line(text.lines.line_of(at));
    const std::string_view before = text.source().bytes({line.begin, std::clamp(at, line.begin, line.end)});
    const Dialect& dialect = text.dialect();
    if (dialect.comment_close.empty()) return opens_outside_text(before, dialect.comment_open);
    const std::size_t open = before.rfind(dialect.comment_open);
    return open != std::string_view::npos &&
           before.find(dialect.comment_close, open) == std::string_view::npos;
}

} // namespace maclint::cli::lsp
