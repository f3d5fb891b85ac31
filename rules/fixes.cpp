//! Edits are made in the bytes of the finding's file.
#include "rules/fixes.hpp"

#include "analyzer/source/line_index.hpp"

#include <string_view>
#include <utility>

namespace maclint::rules {
namespace {

constexpr bool is_blank(char c) { return c == ' ' || c == '\t'; }
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

void offer(Finding& finding, std::string title, Applicability applicability, Span span, std::string text) {
    finding.offer({std::move(title), applicability, {{finding.source, span, std::move(text)}}});
}

std::string in_quotes(std::string_view text) { return "'" + std::string(text) + "'"; }

Offset line_begin(std::string_view bytes, Offset at) {
    while (at > 0 && !is_line_end(bytes[at - 1])) --at;
    return at;
}

Offset after_blanks(std::string_view bytes, Offset at) {
    while (at < bytes.size() && is_blank(bytes[at])) ++at;
    return at;
}

/// Behind the number of the block that begins there: who jumps to it runs what is written behind it.
Offset after_number(std::string_view bytes, Offset at) {
    const Offset letter = after_blanks(bytes, at);
    if (letter == bytes.size() || (bytes[letter] != 'N' && bytes[letter] != 'n')) return at;
    Offset end = after_blanks(bytes, letter + 1);
    const Offset digits = end;
    while (end < bytes.size() && is_digit(bytes[end])) ++end;
    return end == digits ? at : after_blanks(bytes, end);
}

} // namespace

Span removal_of(const Source& source, Span part) {
    const std::string_view bytes = source.bytes();
    Offset begin = part.begin;
    while (begin > 0 && is_blank(bytes[begin - 1])) --begin;
    const Offset end = after_blanks(bytes, part.end);
    const bool line_begins = begin == 0 || is_line_end(bytes[begin - 1]);
    const bool line_ends = end == bytes.size() || is_line_end(bytes[end]);
    if (line_begins && line_ends) return {begin, end == bytes.size() ? end : after_line_end(bytes, end)};
    if (line_ends) return {begin, end};
    return {part.begin, line_begins ? end : part.end};
}

void offer_text(Finding& finding, Applicability applicability, Span span, std::string text) {
    std::string title = "Write " + in_quotes(text);
    offer(finding, std::move(title), applicability, span, std::move(text));
}

void offer_removal(Finding& finding, Applicability applicability, Span span) {
    offer(finding, "Remove " + in_quotes(finding.source->to_utf8(finding.source->bytes(span))), applicability,
          removal_of(*finding.source, span), "");
}

void offer_block_before(Finding& finding, Applicability applicability, Span place, const std::string& block) {
    const std::string_view bytes = finding.source->bytes();
    const Offset begin = line_begin(bytes, place.begin);
    // A block that is skipped, runs in one channel, or follows another on its line would change what the new
    // one is.
    const Offset first = after_blanks(bytes, begin);
    if (bytes[first] == '/' || bytes[first] == '$') return;
    if (bytes.substr(begin, place.begin - begin).find(';') != std::string_view::npos) return;
    const Offset at = after_number(bytes, begin);
    offer(finding, "Write " + in_quotes(block) + " before it", applicability, {at, at}, block + "\n");
}

void offer_block_after(Finding& finding, Applicability applicability, Span place, const std::string& block) {
    const std::string_view bytes = finding.source->bytes();
    const auto end = static_cast<Offset>(find_line_end(bytes, place.end));
    const bool ends_line = end < bytes.size();
    const Offset at = ends_line ? after_line_end(bytes, end) : end;
    offer(finding, "Write " + in_quotes(block) + " after it", applicability, {at, at},
          ends_line ? block + "\n" : "\n" + block);
}

} // namespace maclint::rules
