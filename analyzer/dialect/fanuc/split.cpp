//! The splitter. Every function looks at each byte a bounded number of times.
#include "analyzer/dialect/fanuc/split.hpp"

#include "analyzer/dialect/fanuc/lexer.hpp"
#include "analyzer/dialect/fanuc/remarks.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/source/encoding.hpp"

#include <algorithm>
#include <span>

namespace maclint::fanuc {
namespace {

Offset size_of(std::string_view text) { return static_cast<Offset>(text.size()); }

/// After blanks, line ends and comments.
Offset skip_to_code(std::string_view text, Offset at) {
    while (at < text.size()) {
        if (is_blank(text[at]) || ends_block(text[at]))
            ++at;
        else if (text[at] == '(')
            at = after_comment(text, at);
        else
            break;
    }
    return at;
}

bool ends_line(std::string_view text, Offset mark) {
    const Offset after = skip_blanks(text, mark + 1);
    return after == text.size() || ends_block(text[after]);
}

/// The first tape mark between `from` and the end of its line; `from` is the head of a line or after a mark.
std::optional<Offset> find_mark_in_line(std::string_view text, Offset from) {
    bool heads_block = true;
    Offset at = from;
    while (at < text.size() && !is_line_break(text[at])) {
        if (text[at] == '(') {
            at = after_comment(text, at);
            continue;
        }
        if (text[at] == '%' && (heads_block || ends_line(text, at))) return at;
        if (text[at] == ';')
            heads_block = true;
        else if (!is_blank(text[at]))
            heads_block = false;
        ++at;
    }
    return std::nullopt;
}

Offset line_end(std::string_view text, Offset at) {
    while (at < text.size() && !is_line_break(text[at])) ++at;
    return at;
}

/// Whether a block like those of a program begins at `at`.
bool begins_block(std::string_view text, Offset at) {
    if (at >= text.size()) return false;
    const char letter = to_capital(text[at]);
    if (letter == '<' || letter == '#') return true;
    if (letter != 'O' && letter != ':' && letter != 'N' && letter != 'G' && letter != 'M') return false;
    const Offset value = skip_blanks(text, at + 1);
    return value < text.size() && (is_digit(text[value]) || (letter == 'O' && text[value] == '<'));
}

bool begins_program(std::string_view text, Offset at) {
    return find_program_head(text, {at, size_of(text)}).has_value();
}

/// Takes the blanks off the end.
void trim_end(std::string_view& text) {
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
}

/// Takes the number off the end, and the letter before it: empty where another or none stands there.
std::optional<std::string_view> take_word(std::string_view& text, char letter) {
    std::string_view rest = text;
    while (!rest.empty() && is_digit(rest.back())) rest.remove_suffix(1);
    const std::string_view number = text.substr(rest.size());
    trim_end(rest);
    if (number.empty() || rest.empty() || to_capital(rest.back()) != letter) return std::nullopt;
    rest.remove_suffix(1);
    text = rest;
    return number;
}

/// Whether `code` ends in M02, M30 or M99, with or without the block that M99 returns to.
bool ends_program(std::string_view code) {
    if (take_word(code, 'P')) trim_end(code);
    const std::optional<std::string_view> number = take_word(code, 'M');
    const auto function = number ? read_integer(*number) : std::nullopt;
    return function == 2 || function == 30 || function == 99;
}

/// Whether a program number stands at `at`, in the block of the end of the program before it. Blanks and
/// `comments` in between mean nothing.
bool begins_behind_end(std::string_view text, Offset begin, Offset at, std::span<const Span> comments) {
    if (to_capital(text[at]) != 'O' || at == begin) return false;
    const Offset number = skip_blanks(text, at + 1);
    if (number == text.size() || !is_digit(text[number])) return false;
    std::string_view code = text.substr(begin, at - begin);
    trim_end(code);
    for (std::size_t i = comments.size(); i > 0 && comments[i - 1].end == begin + code.size(); --i) {
        code.remove_suffix(comments[i - 1].length());
        trim_end(code);
    }
    return ends_program(code);
}

/// The first line at or after `from` that holds a program number and nothing else but comments: what
/// follows is a program, even when noise left an odd number of marks before it.
std::optional<Offset> find_program_alone_in_line(std::string_view text, Offset from) {
    for (Offset at = skip_to_code(text, from); at < text.size();) {
        const Offset end = line_end(text, at);
        const std::optional<ProgramHead> head = find_program_head(text, {at, end});
        if (head && skip_to_code(text.substr(0, end), head->span.end) == end) return at;
        at = skip_to_code(text, end);
    }
    return std::nullopt;
}

/// Whether any line of `text` begins like a block.
bool holds_blocks(std::string_view text) {
    for (Offset at = skip_to_code(text, 0); at < text.size(); at = skip_to_code(text, line_end(text, at)))
        if (begins_block(text, at)) return true;
    return false;
}

/// Nobody writes a remark behind more than that.
constexpr Offset longest_line_of_people = 1024;

bool is_in_remark(std::string_view text, const RawBlock& block, Offset at) {
    return text[at] == ';' && !block.comments.empty() &&
           is_in_nested_remark(text, block.comments.back().begin, at);
}

/// Takes all up to the end of the line as code.
void take_line(std::string_view text, RawBlock& block) {
    block.span.end = block.next = line_end(text, block.span.begin);
    block.code = block.span.length();
}

} // namespace

Offset skip_blanks(std::string_view text, Offset at) {
    while (at < text.size() && is_blank(text[at])) ++at;
    return at;
}

void cut_block(std::string_view text, Offset begin, Reading program_behind_end, RawBlock& block) {
    block.comments.clear();
    block.open_comment = false;
    block.code = 0;
    const Offset first = skip_blanks(text, begin);
    block.span = {first, first};
    block.next = size_of(text);
    Lexer lexer(text, {first, block.next});
    while (true) {
        const Lexer::Passed passed = lexer.pass_ordinary();
        block.code += passed.length;
        if (passed.length != 0) block.span.end = passed.end;
        const std::optional<Token> token = lexer.next();
        if (!token) return;
        const Span span = token->span;
        if (token->kind == Token::Kind::end_of_block && !is_in_remark(text, block, span.begin)) {
            block.next = span.end;
            return;
        }
        if (token->kind == Token::Kind::sharp && block.code < longest_line_of_people &&
            begins_sharp_remark(text, span.begin)) {
            block.next = span.begin;
            if (span.begin == first) take_line(text, block);
            return;
        }
        if (token->kind == Token::Kind::comment) {
            block.comments.push_back(span);
            block.open_comment = !is_closed(text.substr(span.begin, span.length()));
        } else {
            const bool at_mark = text[span.begin] == '%' && span.begin > first && ends_line(text, span.begin);
            const bool may_begin = program_behind_end != Reading::stops;
            if (at_mark || (may_begin && begins_behind_end(text, first, span.begin, block.comments))) {
                block.next = span.begin;
                return;
            }
            block.code += span.length();
        }
        block.span.end = span.end;
    }
}

std::optional<Offset> find_tape_mark(std::string_view text, Offset from) {
    while (true) {
        const std::size_t percent = text.find('%', from);
        if (percent == std::string_view::npos) return std::nullopt;
        auto line = static_cast<Offset>(percent);
        while (line > from && !is_line_break(text[line - 1])) --line;
        if (const std::optional<Offset> mark = find_mark_in_line(text, line)) return mark;
        from = line_end(text, static_cast<Offset>(percent));
    }
}

TapeStart find_tape_start(std::string_view text) {
    const auto first = static_cast<Offset>(byte_order_mark_length(text));
    const std::optional<Offset> mark = find_tape_mark(text, first);
    if (!mark || holds_blocks(text.substr(first, *mark - first))) return {first, false};
    return {*mark, true};
}

Offset after_opening_mark(std::string_view text, Offset mark) {
    const Offset at = skip_blanks(text, mark + 1);
    if (at == text.size() || text[at] == '(' || text[at] == '%' || ends_block(text[at]) ||
        begins_block(text, at))
        return at;
    return line_end(text, at);
}

AfterMark after_mark(std::string_view text, Offset mark) {
    const std::optional<Offset> next = find_tape_mark(text, mark + 1);
    const std::string_view here = text.substr(0, next.value_or(size_of(text)));
    if (next && begins_program(here, skip_to_code(here, mark + 1))) return {mark + 1, false};
    if (const std::optional<Offset> program = find_program_alone_in_line(here, line_end(here, mark)))
        return {*program, false};
    return {size_of(here), next.has_value()};
}

std::optional<Span> code_behind_tape(std::string_view text, Offset mark, AfterMark after) {
    if (after.opens) return std::nullopt;
    if (after.begin < text.size()) {
        const Offset first = skip_to_code(text, after.begin);
        if (first == text.size()) return std::nullopt;
        return Span{first, line_end(text, first)};
    }
    for (Offset at = skip_to_code(text, mark + 1); at < text.size();
         at = skip_to_code(text, line_end(text, at)))
        if (begins_block(text, at)) return Span{at, line_end(text, at)};
    return std::nullopt;
}

std::vector<Span> comments_with_percent(std::string_view text) {
    std::vector<Span> comments;
    for (std::size_t percent = text.find('%'); percent != std::string_view::npos;) {
        auto at = static_cast<Offset>(percent);
        while (at > 0 && !is_line_break(text[at - 1])) --at;
        while (at < text.size() && !is_line_break(text[at])) {
            const Offset end = text[at] == '(' ? after_comment(text, at) : at + 1;
            const std::string_view part = text.substr(at, end - at);
            if (part.size() > 1 && part.find('%') != std::string_view::npos) comments.push_back({at, end});
            at = end;
        }
        percent = text.find('%', at);
    }
    return comments;
}

std::optional<std::string_view> folder_mark(std::string_view text, Span block) {
    std::string_view line = text.substr(block.begin, block.length());
    if (!line.starts_with("&F=") && !line.starts_with("&f=")) return std::nullopt;
    // T: no control has folders as deep as that
    constexpr std::size_t longest = 255;
    if (line.size() > longest) return std::nullopt;
    constexpr std::string_view around = "/ \t";
    const std::size_t first = line.find_first_not_of(around, 3);
    if (first == std::string_view::npos) return std::string_view{};
    return line.substr(first, line.find_last_not_of(around) + 1 - first);
}

std::optional<ProgramHead> find_program_head(std::string_view text, Span block) {
    text = text.substr(0, block.end);
    Offset at = skip_blanks(text, block.begin);
    if (at >= text.size()) return std::nullopt;
    const Offset begin = at;
    const char letter = to_capital(text[at]);
    if (letter == 'O' || letter == ':') {
        at = skip_blanks(text, at + 1);
        const Offset digits = at;
        while (at < text.size() && is_digit(text[at])) ++at;
        if (at > digits) {
            const std::string_view number = text.substr(digits, at - digits);
            return ProgramHead{{begin, at}, read_integer(number), "O" + std::string(number)};
        }
    }
    if (at >= text.size() || text[at] != '<' || letter == ':') return std::nullopt;
    const std::optional<Offset> end = after_name(text, at);
    if (!end) return std::nullopt;
    return ProgramHead{{begin, *end}, std::nullopt, std::string(text.substr(at, *end - at))};
}

} // namespace maclint::fanuc
