//! Asks from the particular to the general: a comment that speaks to maclint, a name, a word of the block, a
//! word of the language.
#include "cli/lsp/features/hover.hpp"

#include "analyzer/program/tables.hpp"
#include "cli/filter/directive.hpp"
#include "cli/lsp/features/read_document.hpp"
#include "cli/lsp/meanings/known_values.hpp"
#include "cli/lsp/meanings/meaning.hpp"
#include "cli/lsp/mentions/place.hpp"
#include "cli/text/letters.hpp"
#include "rules/path.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace maclint::cli::lsp {
namespace {

/// What is said of one place.
class Speech {
  public:
    Speech(Session& session, const std::shared_ptr<const ReadText>& text, Offset at)
        : session_(session)
        , held_(text)
        , text_(*text)
        , at_(at) {}

    [[nodiscard]] Json take() {
        if (is_in_comment(text_, at_))
            speak_of_comment();
        else if (const auto place = program_at(text_.programs(), at_))
            speak_of_program(*place);
        if (parts_.empty()) return nullptr;
        std::string all;
        for (const std::string& part : parts_) all += (all.empty() ? "" : "\n\n") + part;
        return {{"contents", {{"kind", "markdown"}, {"value", all}}}, {"range", text_.lines.range(about_)}};
    }

  private:
    void add(Span about, std::string part) {
        if (part.empty() || std::ranges::find(parts_, part) != parts_.end()) return;
        if (parts_.empty()) about_ = about;
        parts_.push_back(std::move(part));
    }

    void add_of_shop(Span span) {
        const std::string word = text_.source().to_utf8(text_.source().bytes(span));
        if (const std::string* meaning = shop_meaning(text_, word)) add(span, "**" + word + "** " + *meaning);
    }

    void speak_of_comment() {
        for (const DirectiveComment& comment : text_.programs().comments)
            if (touches(comment.span, at_)) return speak_of_directive(comment);
        const Span word = name_at(text_.source().bytes(), at_);
        if (!names_alarm(word)) return;
        add(word, meaning_of_alarm(*text_.read.control, text_.source().bytes(word)));
    }

    /// "ALARM 128", "PS0078".
    [[nodiscard]] bool names_alarm(Span word) const {
        const std::string name = in_upper_case(text_.source().bytes(word));
        if (name.starts_with("PS") || name.starts_with("SR")) return true;
        const Span line = text_.lines.line(text_.lines.line_of(at_));
        const std::string before =
            in_upper_case(text_.source().bytes({line.begin, std::max(line.begin, word.begin)}));
        const std::size_t last = before.find_last_not_of(" .:");
        return last != std::string::npos && std::string_view(before).substr(0, last + 1).ends_with("ALARM");
    }

    void speak_of_directive(const DirectiveComment& comment) {
        const auto directive = read_directive(text_.programs(), comment);
        if (!directive) return;
        for (const RuleToken& token : directive->tokens)
            if (touches(token.span, at_)) add(token.span, meaning_of_rule(token.word));
    }

    void speak_of_program(std::size_t place) {
        const Program& program = text_.programs().programs[place];
        const auto mention = mention_at(program, at_);
        if (mention) speak_of_mention(place, *mention);
        const std::vector<Word> block = words_at(program, text_.lines, at_);
        if (!mention || !is_value(mention->named))
            for (const Word& word : block)
                if (word.span.begin <= at_ && at_ < word.span.end) {
                    add_of_shop(word.span);
                    add(word.span, meaning_of_word(*program.control, block, word));
                }
        if (mention && is_value(mention->named)) return;
        speak_of_name(program, name_at(text_.source().bytes(), at_));
        speak_of_name(program, letters_at(text_.source().bytes(), at_));
    }

    static bool is_value(const Named& named) {
        return std::holds_alternative<Variable>(named) || std::holds_alternative<MachineValue>(named) ||
               std::holds_alternative<ModalValueName>(named);
    }

    void speak_of_name(const Program& program, Span span) {
        if (span.empty() || !parts_.empty()) return;
        const std::string_view name = text_.source().bytes(span);
        add_of_shop(span);
        add(span, meaning_of_name(text_.dialect(), name));
        if (parts_.empty()) add(span, meaning_of_code(*program.control, name));
    }

    void speak_of_mention(std::size_t place, const Mention& mention) {
        const Program& program = text_.programs().programs[place];
        add_of_shop(mention.span);
        const std::string_view written = program.slice(mention.span);
        // A row of the language tells more than what all values of the machine have in common.
        const std::string about = std::holds_alternative<MachineValue>(mention.named)
                                      ? meaning_of_name(text_.dialect(), written.substr(0, written.find('[')))
                                      : std::string();
        add(mention.span, about.empty()
                              ? meaning_of_variable(program, mention.named, text_.source().to_utf8(written))
                              : about);
        if (const auto* argument = std::get_if<ArgumentName>(&mention.named))
            add(mention.span, words_of_argument(program, *argument));
        if (!std::holds_alternative<Variable>(mention.named)) return;
        if (const auto values = KnownValues::of(session_, held_)) {
            add(mention.span, value_of(*values, place, mention));
            add(mention.span, words_of_passed(*values, place, std::get<Variable>(mention.named)));
        }
        add(mention.span, places_set(program, mention));
    }

    /// "argument F: #9 of the called program"
    [[nodiscard]] static std::string words_of_argument(const Program& program, const ArgumentName& name) {
        const auto& call = std::get<Call>(program.effects[name.call].what);
        const Argument& argument = program.arguments_of(call)[name.place];
        const auto* variable = std::get_if<Variable>(&argument.given);
        if (variable == nullptr) return {};
        return "**" + std::string(argument.address) + "** argument: " + program.spell(*variable) +
               " of the called program";
    }

    /// What the analysis knows of it.
    [[nodiscard]] static std::string value_of(const KnownValues& values, std::size_t place,
                                              const Mention& mention) {
        std::string value = values.value_at(place, mention);
        if (value.empty()) return value;
        return (mention.role == Mention::Role::stores ? "Stored here: " : "Here: ") + value;
    }

    /// "Callers pass `100.`, `250.`"
    [[nodiscard]] static std::string words_of_passed(const KnownValues& values, std::size_t place,
                                                     const Variable& variable) {
        constexpr std::size_t most = 5;
        const auto passed = values.passed_for(place, variable);
        std::string text;
        for (std::size_t i = 0; i < std::min(most, passed.size()); ++i)
            text += (i == 0 ? "Callers pass `" : ", `") + passed[i] + "`";
        if (passed.size() > most) text += " and " + std::to_string(passed.size() - most) + " more";
        return text;
    }

    [[nodiscard]] std::string places_set(const Program& program, const Mention& mention) const {
        constexpr std::size_t most = 5;
        std::vector<Span> stores;
        for_each_mention(program, [&](const Mention& other) {
            if (other.role == Mention::Role::stores &&
                name_the_same(program, mention.named, program, other.named))
                stores.push_back(other.span);
        });
        std::ranges::sort(stores, {}, &Span::begin);
        std::string text;
        for (std::size_t i = 0; i < std::min(most, stores.size()); ++i) {
            const std::size_t line = text_.lines.line_of(stores[i].begin);
            const Span whole = text_.lines.line(line);
            text += "\n- line " + std::to_string(line + 1) + ": `" +
                    quoted(program, {stores[i].begin, std::max(stores[i].end, whole.end)}) + "`";
        }
        if (stores.size() > most) text += "\n- and " + std::to_string(stores.size() - most) + " more";
        return text.empty() ? text : "Set in this program:\n" + text;
    }

    Session& session_;
    const std::shared_ptr<const ReadText>& held_;
    const ReadText& text_;
    Offset at_;
    Span about_{};
    std::vector<std::string> parts_;
};

} // namespace

Json hover(Session& session, const Json& params) {
    const auto text = read_document(session, params);
    if (text == nullptr) return nullptr;
    return Speech(session, text, text->lines.offset(member(params, "position"))).take();
}

} // namespace maclint::cli::lsp
