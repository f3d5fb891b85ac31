//! The splitter. Every function looks at each byte a bounded number of times.
#include "analyzer/dialect/dinplus/split.hpp"

#include "analyzer/dialect/dinplus/sections.hpp"
#include "analyzer/source/encoding.hpp"

#include <algorithm>

namespace maclint::dinplus {
namespace {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
/// Leader, form feeds and the end mark of old editors count as blanks.
constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\0' || c == '\f' || c == '\v' || c == '\x1A';
}
constexpr bool is_line_break(char c) { return c == '\n' || c == '\r'; }

Offset size_of(std::string_view text) { return static_cast<Offset>(text.size()); }

Offset line_end(std::string_view text, Offset at) {
    while (at < text.size() && !is_line_break(text[at])) ++at;
    return at;
}

/// Behind the text that opens at `open`, at most at its line's end.
Offset behind_text(std::string_view text, Offset open) {
    Offset at = open + 1;
    while (at < text.size() && text[at] != '"' && !is_line_break(text[at])) ++at;
    return at < text.size() && text[at] == '"' ? at + 1 : at;
}

/// `#UNIT METRIC`: quotes mean nothing there.
bool is_header_entry(std::string_view text, Offset at) {
    return at + 2 < text.size() && text[at] == '#' && is_capital(text[at + 1]) && is_capital(text[at + 2]);
}

struct CommentEnd {
    Offset at;
    bool closed;
};

/// Where the comment that opens at `open` ends. One that runs into the next comment behind a line that looks
/// like a block was never closed either: the ']' is the other one's.
CommentEnd find_comment_end(std::string_view text, Offset open) {
    Offset blocks_begin = 0; // line end before the first line that looks like a block
    for (Offset at = open + 1; at < text.size(); ++at) {
        if (text[at] == ']') return {at + 1, true};
        if (text[at] == '[' && blocks_begin != 0) break;
        if (is_line_break(text[at]) && blocks_begin == 0 && begins_block(text, at + 1)) blocks_begin = at;
    }
    Offset end = blocks_begin != 0 ? blocks_begin : size_of(text);
    while (end > open + 1 && (is_blank(text[end - 1]) || is_line_break(text[end - 1]))) --end;
    return {end, false};
}

} // namespace

Offset skip_blanks(std::string_view text, Offset at) {
    while (at < text.size()) {
        if (is_blank(text[at]))
            ++at;
        else if (const std::size_t mark = byte_order_mark_length(text.substr(at)); mark != 0)
            at += static_cast<Offset>(mark);
        else
            break;
    }
    return at;
}

Offset behind_marks(std::string_view text, Offset at) {
    at = skip_blanks(text, at);
    while (at < text.size() && (text[at] == '$' || text[at] == '/')) {
        do ++at;
        while (at < text.size() && is_digit(text[at]));
        at = skip_blanks(text, at);
    }
    return at;
}

Span words_at(std::string_view text, Offset at) {
    const auto is_part = [](char c) {
        return is_capital(c) || (c >= 'a' && c <= 'z') || c == '_' || static_cast<unsigned char>(c) >= 0x80;
    };
    constexpr Offset longest = 64;
    Span words{at, at};
    text = text.substr(0, std::min<std::size_t>(text.size(), at + longest));
    while (at < text.size() && is_part(text[at])) {
        const Offset begin = at;
        while (at < text.size() && is_part(text[at])) ++at;
        // `X118`, `ID"A"`, `N5`: words of a block, not of a name.
        if (at < text.size() && !is_blank(text[at]) && !is_line_break(text[at]) && text[at] != '[' &&
            text[at] != '"')
            break;
        if (at - begin < 3 && words.empty()) break;
        words.end = at;
        while (at < text.size() && is_blank(text[at])) ++at;
    }
    return words;
}

bool begins_block(std::string_view text, Offset at) {
    at = behind_marks(text, at);
    if (at >= text.size()) return false;
    if (text[at] == 'N') {
        const Offset digits = skip_blanks(text, at + 1);
        Offset behind = digits;
        while (behind < text.size() && is_digit(text[behind])) ++behind;
        const Offset next = skip_blanks(text, behind);
        return behind > digits && next < text.size() && !is_line_break(text[next]);
    }
    const Span words = words_at(text, at);
    if (words.empty()) return false;
    const auto section = find_section(text.substr(words.begin, words.length()));
    return section && section->capitals && section->word->use != SectionWord::Use::translated;
}

void cut_block(std::string_view text, Offset begin, RawBlock& block) {
    block.comments.clear();
    block.open_comment = false;
    block.code = 0;
    const Offset first = skip_blanks(text, begin);
    const bool has_texts = !is_header_entry(text, first);
    Offset at = first;
    Offset last = first;
    while (at < text.size() && !is_line_break(text[at])) {
        if (text[at] == '[') {
            const CommentEnd end = find_comment_end(text, at);
            block.comments.push_back({at, end.at});
            at = last = end.at;
            block.open_comment = !end.closed;
            if (!end.closed) break;
        } else if (text[at] == '"' && has_texts) {
            const Offset behind = behind_text(text, at);
            block.code += behind - at;
            at = last = behind;
        } else if (text[at] == ';') { // the comment of other languages, which may hold a quote
            while (at < text.size() && text[at] != '[' && !is_line_break(text[at])) ++at;
            block.code += at - last;
            last = at;
        } else {
            if (!is_blank(text[at])) {
                last = at + 1;
                ++block.code;
            }
            ++at;
        }
    }
    block.span = {first, last};
    const Offset end = line_end(text, at);
    block.next = std::min(end + 1, size_of(text));
}

} // namespace maclint::dinplus
