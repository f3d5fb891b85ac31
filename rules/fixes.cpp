//! Edits are made in the bytes of the finding's file.
#include "rules/fixes.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace maclint::rules {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }
bool is_line_end(char c) { return c == '\r' || c == '\n'; }

void offer(Finding& finding, std::string title, Applicability applicability, Span span, std::string text) {
    finding.offer({std::move(title), applicability, {{finding.source, span, std::move(text)}}});
}

std::string in_quotes(std::string_view text) { return "'" + std::string(text) + "'"; }

Offset line_begin(std::string_view text, Offset at) {
    while (at > 0 && text[at - 1] != '\n') --at;
    return at;
}

/// Behind its line feed; the end of the text where none follows.
Offset line_end(std::string_view text, Offset at) {
    const auto end = text.find('\n', at);
    return static_cast<Offset>(end == std::string_view::npos ? text.size() : end + 1);
}

} // namespace

void offer_text(Finding& finding, Applicability applicability, Span span, std::string text) {
    std::string title = "Write " + in_quotes(text);
    offer(finding, std::move(title), applicability, span, std::move(text));
}

void offer_removal(Finding& finding, Applicability applicability, Span span) {
    const std::string_view text = finding.source->bytes();
    std::string title =
        "Remove " + in_quotes(finding.source->to_utf8(text.substr(span.begin, span.length())));
    Span removed = span;
    while (removed.begin > 0 && is_blank(text[removed.begin - 1])) --removed.begin;
    Offset behind = span.end;
    while (behind < text.size() && is_blank(text[behind])) ++behind;
    const bool begins_line = removed.begin == 0 || is_line_end(text[removed.begin - 1]);
    const bool ends_line = behind == text.size() || is_line_end(text[behind]);
    if (begins_line && ends_line)
        removed = {line_begin(text, span.begin), line_end(text, span.end)};
    else if (begins_line)
        removed = {span.begin, behind};
    offer(finding, std::move(title), applicability, removed, "");
}

void offer_block_before(Finding& finding, Applicability applicability, Span place, const std::string& block) {
    const Offset at = line_begin(finding.source->bytes(), place.begin);
    offer(finding, "Write " + in_quotes(block) + " before it", applicability, {at, at}, block + "\n");
}

void offer_block_after(Finding& finding, Applicability applicability, Span place, const std::string& block) {
    const std::string_view text = finding.source->bytes();
    const Offset at = line_end(text, place.end);
    const bool ends_line = at > 0 && text[at - 1] == '\n';
    offer(finding, "Write " + in_quotes(block) + " after it", applicability, {at, at},
          ends_line ? block + "\n" : "\n" + block);
}

} // namespace maclint::rules
