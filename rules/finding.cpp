//! Fills the arguments of a finding into its message.
#include "rules/finding.hpp"

#include "rules/listed.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <tuple>
#include <utility>

namespace maclint {

std::string fill(std::string_view text, const std::vector<std::string>& arguments) {
    std::string filled;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool placeholder = text[i] == '{' && i + 2 < text.size() && text[i + 2] == '}' &&
                                 text[i + 1] >= '0' && text[i + 1] <= '9';
        if (!placeholder) {
            filled += text[i];
            continue;
        }
        const auto index = static_cast<std::size_t>(text[i + 1] - '0');
        assert(index < arguments.size());
        if (index < arguments.size()) filled += arguments[index];
        i += 2;
    }
    return filled;
}

namespace {

/// " The same in 3 more places: lines 67, 87 and 95."
std::string repeated_in(const std::vector<RelatedLocation>& repeats) {
    if (repeats.empty()) return {};
    constexpr std::size_t most_lines = 6;
    std::vector<std::uint32_t> lines;
    for (const RelatedLocation& place : repeats) {
        const std::uint32_t line = place.source->position(place.span.begin).line;
        if (lines.empty() || lines.back() != line) lines.push_back(line);
    }
    const std::size_t named = std::min(lines.size(), most_lines);
    const bool all = named == lines.size();
    std::string text = " The same in " + std::to_string(repeats.size()) + " more place";
    text += repeats.size() == 1 ? ": line " : lines.size() == 1 ? "s: line " : "s: lines ";
    std::vector<std::string> words;
    for (std::size_t i = 0; i < named; ++i) words.push_back(std::to_string(lines[i]));
    return text + rules::listed(words, all ? " and " : ", ") + (all ? "." : " …");
}

const Message* text_of(const Finding& finding) {
    const auto found = std::ranges::find(finding.rule->messages, finding.message_id, &Message::id);
    assert(found != finding.rule->messages.end());
    return found == finding.rule->messages.end() ? nullptr : &*found;
}

/// The text with the number of the alarm before the full stop of its first sentence.
std::string with_alarm(std::string_view text, std::string_view alarm) {
    std::string out(text);
    if (alarm.empty()) return out;
    const std::size_t end = std::min(text.find(". "), text.size() - (text.ends_with('.') ? 1 : 0));
    return out.insert(end, " (alarm " + std::string(alarm) + ")");
}

} // namespace

bool is_on_request(const Finding& finding) {
    const Message* message = text_of(finding);
    return message != nullptr && message->on_request;
}

std::string Finding::statement() const {
    const Message* message = text_of(*this);
    return fill(with_alarm(message == nullptr ? rule->summary : message->text, alarm), arguments) +
           repeated_in(repeats);
}

std::string Finding::cure() const {
    const Message* message = text_of(*this);
    return message == nullptr ? std::string() : fill(message->cure, arguments);
}

std::string Finding::message() const {
    std::string text = statement();
    if (const std::string mending = cure(); !mending.empty()) text += " " + mending;
    return text;
}

std::vector<RelatedLocation> Finding::further_places() const {
    std::vector<RelatedLocation> places = related;
    places.insert(places.end(), repeats.begin(), repeats.end());
    return places;
}

// Position before everything else: the order does not depend on who found what first.
bool comes_before(const Finding& a, const Finding& b) {
    const auto key = [](const Finding& f) {
        return std::tie(f.source->path(), f.span.begin, f.rule->code, f.span.end);
    };
    if (key(a) != key(b)) return key(a) < key(b);
    return a.arguments < b.arguments;
}

} // namespace maclint
