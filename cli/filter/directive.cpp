//! Reads a directive word by word. What a control's comment can hold is enough: letters, digits, blanks,
//! minus, and the slash and point of a row's key.
#include "cli/filter/directive.hpp"

#include "analyzer/program/model.hpp"
#include "cli/text/letters.hpp"

#include <algorithm>
#include <array>

namespace maclint::cli {
namespace {

struct VerbRow {
    std::string_view word;
    Verb verb;
};
constexpr std::array<VerbRow, 4> verbs{
    {{"ALLOW", Verb::allow}, {"ALLOW-FILE", Verb::allow_file}, {"OFF", Verb::off}, {"ON", Verb::on}}};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == ','; }

/// Words of a text with their places in the file.
class Words {
  public:
    Words(std::string_view text, Offset begin)
        : text_(text)
        , at_(begin) {}

    /// The next word; empty at the end.
    struct Word {
        std::string_view text;
        Span span;
    };
    Word next() {
        skip_blanks();
        std::size_t length = 0;
        while (length < text_.size() && !is_blank(text_[length])) ++length;
        const Word word{text_.substr(0, length), {at_, at_ + static_cast<Offset>(length)}};
        advance(length);
        return word;
    }
    [[nodiscard]] std::string_view rest() {
        skip_blanks();
        return text_;
    }

  private:
    void skip_blanks() {
        std::size_t length = 0;
        while (length < text_.size() && is_blank(text_[length])) ++length;
        advance(length);
    }
    void advance(std::size_t length) {
        text_.remove_prefix(length);
        at_ += static_cast<Offset>(length);
    }

    std::string_view text_;
    Offset at_;
};

std::string example(char open) {
    if (open == '[') return "[MACLINT ALLOW MAC301 - REASON]";
    if (open == ';') return ";MACLINT ALLOW MAC301 - REASON";
    return "(MACLINT ALLOW MAC301 - REASON)";
}

/// What stands behind "MACLINT" in one word with it, as ":ALLOW"; empty where that is another word.
std::string_view tied_to_name(std::string_view word) {
    constexpr std::string_view name = "MACLINT";
    if (in_upper_case(word.substr(0, name.size())) != name) return {};
    const std::string_view tied = word.substr(name.size());
    return tied.starts_with(':') || tied.starts_with('-') || tied.starts_with('=') ? tied
                                                                                   : std::string_view();
}

bool is_verb(std::string_view word) {
    return std::ranges::find(verbs, in_upper_case(word), &VerbRow::word) != verbs.end();
}

/// "MACLINT: ALLOW MAC301", "MACLINT-ALLOW MAC301": meant for maclint, and of no effect. Nothing where the
/// comment has no instruction: it speaks of maclint.
std::optional<DirectiveFault> tied_verb(const ProgramFile& file, std::string_view tied, Span span,
                                        Words words) {
    const std::size_t letter = std::min(tied.find_first_not_of(":-="), tied.size());
    std::string_view verb = tied.substr(letter);
    Span end = span;
    if (verb.empty()) {
        const auto next = words.next();
        verb = next.text;
        end = next.span;
    }
    if (!is_verb(verb)) return std::nullopt;
    const Span wrong{span.begin, end.end};
    return DirectiveFault{
        wrong, "tied", {file.source->to_utf8(file.source->bytes(wrong)), "MACLINT " + in_upper_case(verb)}};
}

/// A comment with more words that name no rule is no typing error: it gets no proposals.
constexpr std::size_t most_proposals = 8;

DirectiveFault names_no_rule(const ProgramFile& file, const RuleToken& token, bool proposes) {
    const std::string word = file.source->to_utf8(token.word);
    if (!proposes) return {token.span, "unknown", {word}};
    if (const auto similar = rules_like(word); !similar.empty())
        return {token.span, "similar", {word, similar.front()}};
    return {token.span, "unknown", {word}};
}

void read_tokens(const ProgramFile& file, Words& words, Directive& directive) {
    for (auto word = words.next(); !word.text.empty(); word = words.next()) {
        if (word.text.starts_with('-')) {
            std::string reason(word.text.substr(1));
            if (!reason.empty() && !words.rest().empty()) reason += ' ';
            reason += words.rest();
            directive.reason = file.source->to_utf8(reason);
            return;
        }
        RuleToken token{word.span, std::string(word.text), rules_named(word.text)};
        if (token.rules.empty())
            directive.faults.push_back(names_no_rule(file, token, directive.faults.size() < most_proposals));
        directive.tokens.push_back(std::move(token));
    }
}

} // namespace

std::optional<Directive> read_directive(const ProgramFile& file, const DirectiveComment& comment) {
    std::string_view text = file.source->bytes(comment.span);
    Offset begin = comment.span.begin;
    const char open = text.empty() ? '(' : text.front();
    while (!text.empty() && std::string_view("([; \t").find(text.front()) != std::string_view::npos) {
        text.remove_prefix(1);
        ++begin;
    }
    if (text.ends_with(')') || text.ends_with(']')) text.remove_suffix(1);
    Words words(text, begin);
    const auto name = words.next();
    Directive directive;
    directive.comment = &comment;
    if (const std::string_view tied = tied_to_name(name.text); !tied.empty()) {
        auto fault = tied_verb(file, tied, name.span, words);
        if (!fault) return std::nullopt;
        directive.valid = false;
        directive.faults.push_back(*std::move(fault));
        return directive;
    }
    if (in_upper_case(name.text) != "MACLINT") return std::nullopt;
    const auto verb = words.next();
    const auto* const row = std::ranges::find(verbs, in_upper_case(verb.text), &VerbRow::word);
    if (row != verbs.end()) {
        directive.verb = row->verb;
        read_tokens(file, words, directive);
        directive.valid = row->verb == Verb::on || !directive.tokens.empty();
        if (!directive.valid) directive.faults.push_back({comment.span, "no-rule", {example(open)}});
        return directive;
    }
    directive.valid = false;
    if (verb.text.empty()) {
        directive.faults.push_back({comment.span, "no-rule", {example(open)}});
    } else {
        directive.faults.push_back({verb.span, "no-verb", {file.source->to_utf8(verb.text)}});
    }
    return directive;
}

} // namespace maclint::cli
