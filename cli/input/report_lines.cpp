//! Lines as the text, concise and GitHub reports, the tables of numbers and standard error have them.
#include "cli/input/report_lines.hpp"

#include "rules/rule.hpp"
#include "rules/words/rule_row.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>

namespace maclint::cli {
namespace {

constexpr std::array<std::string_view, 3> severities = {"error", "warning", "note"};
constexpr std::size_t code_length = 6; ///< of "MAC303", "DIN330"
constexpr std::string_view digits = "0123456789";
constexpr std::string_view blanks = " \t";

bool is_digit(char c) { return digits.find(c) != std::string_view::npos; }

/// Takes the key of a row off the front, with its slash, where the rule has such a row.
void take_key(std::string_view& text, std::string_view code) {
    const std::size_t end = std::min(text.size(), text.find_first_of("] :=,\t"));
    if (find_rule_row(std::string(code).append(text.substr(0, end))) != nullptr) text.remove_prefix(end);
}

/// Takes a code off the front, with the key of one of its rows where there is one; nullptr: no rule has it.
const Rule* take_code(std::string_view& text) {
    const std::string_view code = text.substr(0, code_length);
    const Rule* rule = find_rule(code);
    if (rule == nullptr || rule->code != code) return nullptr;
    text.remove_prefix(code_length);
    if (text.starts_with('/')) take_key(text, code);
    return rule;
}

/// Takes a number off the front; false: there is none.
bool take_number(std::string_view& text) {
    const std::size_t length = std::min(text.size(), text.find_first_not_of(digits));
    text.remove_prefix(length);
    return length > 0;
}

bool take(std::string_view& text, std::string_view word) {
    if (!text.starts_with(word)) return false;
    text.remove_prefix(word.size());
    return true;
}

/// "3 files", "1 file"
bool take_counted(std::string_view& text, std::string_view noun) {
    if (!take_number(text) || !take(text, " ") || !take(text, noun)) return false;
    take(text, "s");
    return true;
}

/// "1 link to elsewhere"
bool take_counted(std::string_view& text, std::string_view noun, std::string_view rest) {
    std::string_view known = text;
    if (!take_counted(known, noun) || !take(known, rest)) return false;
    text = known;
    return true;
}

/// "12.345" with so many digits behind the point
bool take_decimal(std::string_view& text, std::size_t places) {
    if (!take_number(text) || !take(text, ".")) return false;
    const std::string_view behind = text;
    return take_number(text) && behind.size() - text.size() == places;
}

bool take_severity(std::string_view& text) {
    return std::ranges::any_of(severities, [&](auto severity) { return take(text, severity); });
}

/// Takes "error[MAC303]" off the front; nullptr: no finding of a rule is there.
const Rule* take_rule(std::string_view& text) {
    if (!take_severity(text) || !take(text, "[")) return nullptr;
    const Rule* rule = take_code(text);
    return take(text, "]") ? rule : nullptr;
}

/// A report is wrapped at blanks, so they do not count.
std::string without_blanks(std::string_view text) {
    std::string words(text);
    std::erase(words, ' ');
    return words;
}

/// What a message begins with in every finding: the number of an alarm may follow its first sentence.
std::string_view fixed_beginning(std::string_view message) {
    return message.substr(0, std::min({message.find('{'), message.find(". "),
                                       message.size() - (message.ends_with('.') ? 1 : 0)}));
}

/// Takes "  12  " off the front.
std::optional<std::uint64_t> take_count(std::string_view& line) {
    if (!take(line, "  ")) return std::nullopt;
    line.remove_prefix(std::min(line.size(), line.find_first_not_of(' ')));
    std::uint64_t count = 0;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), count);
    if (error != std::errc{}) return std::nullopt;
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    return take(line, "  ") ? std::optional(count) : std::nullopt;
}

/// Words and a full stop: that of a number, as in X100., is none.
bool ends_like_sentence(std::string_view text) {
    return text.size() > 1 && text.ends_with('.') && !is_digit(text[text.size() - 2]) &&
           text.find(';') == std::string_view::npos;
}

/// "O1.nc:4:1"
bool is_place(std::string_view text) {
    for (int i = 0; i < 2; ++i) {
        const std::size_t colon = text.find_last_not_of(digits);
        if (colon == std::string_view::npos || colon == 0 || text[colon] != ':') return false;
        if (colon + 1 == text.size()) return false;
        text = text.substr(0, colon);
    }
    return true;
}

/// A program could hide what it does in front of a comment: `G0 X1. (O1.nc:4:1: error[MAC301] …)`.
bool has_open_bracket(std::string_view text) {
    const auto opens = [&](char open, char close) {
        const std::size_t last = text.rfind(open);
        return last != std::string_view::npos && text.find(close, last) == std::string_view::npos;
    };
    return opens('(', ')') || opens('[', ']');
}

/// ", 1 allowed by comments", and what else a summary says of what was not checked or shown.
bool take_further_number(std::string_view& text) {
    return take(text, ", ") && (take_counted(text, "file", " with another name passed over") ||
                                take_counted(text, "file", " with other names passed over") ||
                                take_counted(text, "program", " ignored by git") ||
                                take_counted(text, "link", " to elsewhere not followed") ||
                                (take_number(text) && (take(text, " allowed by comments") ||
                                                       take(text, " not shown: see --max-findings"))));
}

/// ",line=4,endLine=4,col=1,endColumn=7"
bool take_properties(std::string_view& text) {
    const auto take_property = [&](std::string_view name) { return take(text, name) && take_number(text); };
    if (!take_property(",line=") || !take_property(",endLine=")) return false;
    return !text.starts_with(",col=") || (take_property(",col=") && take_property(",endColumn="));
}

/// A value of a property of a workflow command, in which ',' and ':' are escaped.
void take_value(std::string_view& text) {
    text.remove_prefix(std::min(text.size(), text.find_first_of(",:")));
}

/// What a run took its time for, behind "timing: ".
bool is_part_with_time(std::string_view line, std::string_view part, std::string_view& rest) {
    if (!take(line, part) || !take(line, " ")) return false;
    line.remove_prefix(std::min(line.size(), line.find_first_not_of(' ')));
    if (!take_decimal(line, 3) || !take(line, " s")) return false;
    rest = line;
    return true;
}

} // namespace

bool are_words_of(const Rule& rule, std::string_view text) {
    const std::string words = without_blanks(text);
    const auto begins = [&](std::string_view message) {
        return words.starts_with(without_blanks(fixed_beginning(message)));
    };
    return std::ranges::any_of(rule.messages, begins, &Message::text) ||
           (rule.messages.empty() && begins(rule.summary));
}

const Rule* rule_of_headline(std::string_view line) {
    const Rule* rule = take_rule(line);
    return line.starts_with(": ") ? rule : nullptr;
}

bool is_concise_finding(std::string_view line) {
    for (std::size_t at = line.find(": "); at != std::string_view::npos; at = line.find(": ", at + 1)) {
        std::string_view rest = line.substr(at + 2);
        const std::string_view place = line.substr(0, at);
        const Rule* rule = take_rule(rest);
        if (rule != nullptr && take(rest, " ") && is_place(place))
            return !has_open_bracket(place) && are_words_of(*rule, rest);
    }
    return false;
}

bool is_workflow_command(std::string_view line) {
    if (take(line, "::error title=maclint")) {
        if (take(line, ",file=")) take_value(line);
        return take(line, "::") && ends_like_sentence(line);
    }
    if (!take(line, "::error") && !take(line, "::warning") && !take(line, "::notice")) return false;
    if (!take(line, " file=")) return false;
    take_value(line);
    if (!take_properties(line) || !take(line, ",title=")) return false;
    const Rule* rule = take_code(line);
    return rule != nullptr && take(line, " ") && take(line, rule->name) && take(line, "::");
}

bool is_message(std::string_view line) {
    return (take(line, "maclint: error: ") || take(line, "maclint: note: ")) && ends_like_sentence(line);
}

bool is_summary(std::string_view line) {
    if (!take(line, "no findings") && !take(line, "no new findings")) {
        do
            if (!take_number(line) || !take(line, " ") || !take_severity(line)) return false;
        while ((take(line, "s"), take(line, ", ")));
        if (!take(line, " in ") || !take_counted(line, "file")) return false;
    }
    if (!take(line, " (") || !take_number(line) || !take(line, " checked")) return false;
    while (line.starts_with(", "))
        if (!take_further_number(line)) return false;
    return line == ")";
}

bool is_not_shown(std::string_view line) {
    std::string_view known = line, fixed = line;
    return (take_counted(fixed, "finding") && fixed == " can be corrected by --fix; --diff shows how") ||
           (take_counted(line, "step") && line == " of paths not shown; --path full shows them") ||
           (take_counted(known, "known finding") && known.starts_with(" of ") &&
            known.ends_with(" not shown"));
}

bool is_timing(std::string_view line) {
    if (!take(line, "timing: ")) return false;
    std::string_view rest;
    for (const std::string_view part : {"finding files", "reports", "the whole run"})
        if (is_part_with_time(line, part, rest)) return rest.empty();
    if (is_part_with_time(line, "reading", rest))
        return take(rest, "  ") && take_counted(rest, "file") && take(rest, ", ") && take_decimal(rest, 2) &&
               rest == " MB";
    if (is_part_with_time(line, "analysis", rest))
        return take(rest, "  ") && take_counted(rest, "program") && rest.empty();
    return is_part_with_time(line, "rules", rest) && take(rest, "  ") && take_counted(rest, "path") &&
           take(rest, " looked for, ") && take_number(rest) && rest == " given up";
}

std::optional<std::uint64_t> count_of_rule(std::string_view line) {
    const auto findings = take_count(line);
    const Rule* rule = findings ? take_code(line) : nullptr;
    const bool whole = rule != nullptr && take(line, " ") && take(line, rule->name) && take(line, " (") &&
                       take_severity(line) && line == ")";
    return whole ? findings : std::nullopt;
}

std::optional<std::uint64_t> count_of_file(std::string_view line) {
    const auto findings = take_count(line);
    return line.empty() ? std::nullopt : findings;
}

bool is_count_of_more_files(std::string_view line) {
    return take(line, "  and ") && take_counted(line, "more file") && line.empty();
}

std::size_t margin_of_place(std::string_view line, std::string_view arrow) {
    const std::size_t margin = std::min(line.size(), line.find_first_not_of(' '));
    line.remove_prefix(margin);
    return take(line, arrow) && take(line, " ") && is_place(line) ? margin : 0;
}

bool is_row(std::string_view line, std::size_t margin) {
    if (line.size() < margin + 2 || line.substr(margin, 2) != " |") return false;
    std::string_view number = line.substr(0, margin);
    number.remove_prefix(std::min(number.size(), number.find_first_not_of(' ')));
    return std::ranges::all_of(number, is_digit) && (line.size() == margin + 2 || line[margin + 2] == ' ');
}

bool is_reference(std::string_view text) {
    return take(text, "more: maclint explain ") && take_code(text) != nullptr && text.empty();
}

bool is_like_blocks(std::string_view line) {
    const std::size_t first = line.find_first_not_of(blanks);
    if (first == std::string_view::npos) return false;
    if (line[first] == '%' || line[line.find_last_not_of(blanks)] == '%') return true;
    for (std::size_t at = line.find(';'); at != std::string_view::npos; at = line.find(';', at + 1)) {
        const std::size_t next = line.find_first_not_of(blanks, at + 1);
        if (next == std::string_view::npos) break;
        const bool ends_quote = line[next] == '\'' || line[next] == ')' || line[next] == ']';
        const bool goes_on = next > at + 1 && (line[next] == '-' || ('a' <= line[next] && line[next] <= 'z'));
        if (!ends_quote && !goes_on) return true;
    }
    return false;
}

bool holds_tape_mark_as_block(std::string_view line) {
    for (std::size_t at = line.find('%'); at != std::string_view::npos; at = line.find('%', at + 1)) {
        const std::size_t before = line.substr(0, at).find_last_not_of(blanks);
        const bool heads_block = before != std::string_view::npos && line[before] == ';';
        if (heads_block && line.find_first_not_of(blanks, at + 1) != std::string_view::npos) return true;
    }
    return false;
}

std::string without_colours(std::string_view line) {
    constexpr std::string_view begin = "\x1B[";
    std::string plain;
    for (std::size_t at = line.find(begin); at != std::string_view::npos; at = line.find(begin)) {
        plain += line.substr(0, at);
        line.remove_prefix(at + begin.size());
        const std::size_t end = line.find_first_not_of("0123456789;");
        if (end == std::string_view::npos || line[end] != 'm') return plain.append(begin).append(line);
        line.remove_prefix(end + 1);
    }
    return plain.append(line);
}

} // namespace maclint::cli
