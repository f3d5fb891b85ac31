//! The pages of `explain`, cut down to what somebody wants to know while he reads a program.
#include "cli/lsp/meanings/meaning.hpp"

#include "analyzer/program/language_words.hpp"
#include "analyzer/program/tables.hpp"
#include "cli/config/rule_words.hpp"
#include "cli/report/alarm_page.hpp"
#include "cli/report/code_page.hpp"
#include "cli/report/group_page.hpp"
#include "cli/report/rule_page.hpp"
#include "cli/report/variable_page.hpp"
#include "cli/text/letters.hpp"
#include "rules/words/code_pages.hpp"
#include "rules/words/section_pages.hpp"

#include <algorithm>
#include <charconv>
#include <vector>

namespace maclint::cli::lsp {
namespace {

bool is_code(const Word& word) {
    return (word.address == "G" || word.address == "M") && std::holds_alternative<Literal>(word.value);
}

/// "G54.1"; codes have one figure behind the point at most.
std::string code_of(const Word& word) {
    constexpr std::size_t room = 32;
    char text[room];
    const auto [end, error] = std::to_chars(text, text + room, std::get<Literal>(word.value).value);
    return std::string(word.address) + (error == std::errc() ? std::string(text, end) : "");
}

std::vector<const CodePage*> pages_on(const ControlModel& control, std::string_view code) {
    std::vector<const CodePage*> pages = pages_of_code(control.language, code);
    std::erase_if(pages, [&](const CodePage* page) { return !page->is_of(control); });
    return pages;
}

void add(std::string& text, const std::string& more) {
    if (more.empty() || text.find(more) != std::string::npos) return;
    text += (text.empty() ? "" : "\n\n") + more;
}

std::string with_title(std::string_view title, const std::vector<std::string>& lines) {
    std::string text = "**" + std::string(title) + "**";
    for (const std::string& line : lines) text += (&line == &lines.front() ? " " : "\n- ") + line;
    return text;
}

struct VariableFacts {
    const Program& program;
    std::string_view written;

    std::string operator()(const Variable& variable) const {
        std::vector<std::string> lines;
        const ControlModel& control = *program.control;
        const VariableSpace& space = control.spaces[variable.space];
        for (const VariableFamily& family : control.families) {
            const VariableRange* range = space.named ? nullptr : family.find(variable.number);
            if (range == nullptr || range->meaning != Meaning::variable || range->space != variable.space)
                continue;
            lines = facts_of_number(control, *range, variable.number);
            break;
        }
        if (lines.empty()) lines = {std::string(space.name), maclint::cli::scope_of(space)};
        if (const Declaration* declared = program.declaration_of(variable);
            declared != nullptr && !declared->type_name.empty())
            lines.push_back("declared as " + std::string(declared->type_name));
        if (std::ranges::find(program.formals, variable, &Formal::variable) != program.formals.end())
            lines.emplace_back("parameter of the program");
        return with_title(program.spell(variable), lines);
    }
    std::string operator()(const MachineValue& value) const {
        const ControlModel& control = *program.control;
        const VariableRange* range = control.families[value.family].find(value.number);
        return range == nullptr ? "" : with_title(written, facts_of_number(control, *range, value.number));
    }
    std::string operator()(const ModalValueName& name) const {
        return with_title(written,
                          {"what is in force of: " + std::string(program.control->groups[name.group].name)});
    }
    template<class Other>
    std::string operator()(const Other& /*name*/) const {
        return {};
    }
};

} // namespace

std::string meaning_of_code(const ControlModel& control, std::string_view code) {
    std::string text;
    for (const CodePage& page : pages_named(control.language, code))
        if (page.is_of(control)) add(text, short_code_page(page, control));
    return text.empty() ? short_group_page(control, code) : text;
}

std::string meaning_of_word(const ControlModel& control, std::span<const Word> block, const Word& word) {
    if (is_code(word)) return meaning_of_code(control, code_of(word));
    std::string text;
    for (const Word& code : block) {
        if (!is_code(code)) continue;
        for (const CodePage* page : pages_on(control, code_of(code)))
            if (const auto means = word_of_page(*page, word.address, control))
                add(text, "**" + std::string(word.address) + "** of " + code_of(code) + ": " + *means);
    }
    return text;
}

std::string meaning_of_name(const Dialect& dialect, std::string_view name) {
    const std::string capitals = in_upper_case(name);
    const LanguageTables tables = dialect.words();
    for (const LanguageWord& word : tables.words)
        if (word.word == capitals)
            return "**" + capitals + "** " + std::string(name_of(word.use)) +
                   (word.what.empty() ? "" : ": " + std::string(word.what));
    if (tables.about_variable != nullptr)
        if (const std::string about = tables.about_variable(capitals); !about.empty())
            return "**" + capitals + "** " + about;
    return {};
}

std::string meaning_of_variable(const Program& program, const Named& named, std::string_view written) {
    return std::visit(VariableFacts{program, written}, named);
}

std::string meaning_of_rule(std::string_view word) {
    constexpr std::size_t most = 5; // "MAC5" names a hundred
    std::string text;
    const auto named = rules_named(word);
    if (named.size() > most) return {};
    for (const NamedRule& one : named) {
        const Rule& rule = *one.rule;
        add(text, "**" + std::string(rule.code) + "** " + std::string(rule.name) + ": " +
                      summary_sentence(rule) + "\n\n" + std::string(rule.why));
        if (const std::string url = page_url(rule); !url.empty())
            text.append("\n\n[").append(url).append("](").append(url).append(")");
    }
    return text;
}

std::string meaning_of_alarm(const ControlModel& control, std::string_view word) {
    std::string text;
    if (control.alarms.empty()) return text;
    for (const ControlAlarm* alarm : alarms_named(word, control.alarms))
        add(text, "**Alarm " + std::string(alarm->number) + "** " +
                      std::string(alarm->title_on(control.alarms)) + "\n\n" + std::string(alarm->cause));
    return text;
}

const std::string* shop_meaning(const ReadText& text, std::string_view word) {
    const auto& configuration = text.file.settings.configuration;
    return configuration == nullptr ? nullptr : meaning_in(configuration->words, word);
}

} // namespace maclint::cli::lsp
