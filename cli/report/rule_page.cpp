//! Pages made from the records of the rules, so that they cannot say anything else.
#include "cli/report/rule_page.hpp"

#include "analyzer/dialect/dialect.hpp"
#include "cli/config/selection.hpp"
#include "cli/report/columns.hpp"
#include "cli/report/exemption_page.hpp"
#include "cli/report/measured_precision.hpp"
#include "cli/report/row_page.hpp"
#include "cli/report/sources.hpp"
#include "rules/alarms/alarm.hpp"

#include <algorithm>
#include <array>

namespace maclint::cli {
namespace {

struct FamilyRow {
    std::string_view prefix;
    std::string_view name;
};

constexpr std::array<FamilyRow, 11> families{{
    {"MAC0", "input and suppressions"},
    {"MAC1", "syntax"},
    {"MAC2", "variables and data flow"},
    {"MAC3", "loops and jumps"},
    {"MAC4", "calls and arguments"},
    {"MAC5", "modal state and motion safety"},
    {"MAC6", "look-ahead and timing"},
    {"MAC7", "numbers and expressions"},
    {"MAC8", "style"},
    {"DIN", "DIN PLUS"},
    {"SIN", "SINUMERIK"},
}};

std::string_view words_for(Capability capability) {
    switch (capability) {
    case Capability::loop_numbers: return "loops have numbers";
    case Capability::sections: return "programs have sections";
    case Capability::exclusive_words: return "it is known which words exclude each other in a block";
    case Capability::vacancy: return "variables can be vacant";
    case Capability::unset_locals: return "local variables hold no number before something sets them";
    case Capability::undefined_variables: return "variables that nothing has set are undefined";
    case Capability::jumps: return "programs jump to blocks";
    case Capability::sequence_numbers: return "programs name blocks by their numbers";
    case Capability::block_if: return "IF opens blocks up to ELSE or ENDIF";
    case Capability::paired_words:
        return "loops and choices have closing words of their own, such as ENDIF and ENDFOR";
    case Capability::block_references: return "words name blocks of certain sections";
    case Capability::macro_calls: return "macro calls have a limit of their own";
    case Capability::modal_calls: return "programs can be called after every move or block";
    case Capability::named_arguments: return "what a call passes is read by names of its own";
    case Capability::suppression: return "programs can switch off single block, feed hold or override";
    }
    return {};
}

std::string share_of(const ReadFindings& findings) {
    return std::to_string(findings.correct) + " of " + std::to_string(findings.decided);
}

/// For readers who meet the word for the first time: the bounds by which it is given (docs/precision.md).
std::string meaning_of(Precision precision) {
    switch (precision) {
    case Precision::low: return "Low: of its findings fewer than half are worth acting on.";
    case Precision::medium: return "Medium: of its findings at least half are worth acting on.";
    case Precision::high: return "High: of 10 findings at least 8 are worth acting on.";
    case Precision::very_high: return "Very high: of 20 findings at least 19 are worth acting on.";
    }
    return {};
}

std::string facts_of(const Rule& rule) {
    std::string severity(name_of(rule.severity));
    for (const OtherSeverity& other : rule.severity_elsewhere)
        severity += ", in " + std::string(other.language) + " " + std::string(name_of(other.severity));
    std::string facts = "Severity: " + severity + ". " + precision_of(rule, measured(rule.code)) + " " +
                        meaning_of(rule.precision) + " " +
                        (rule.on_by_default ? "On by default." : "Off by default.");
    if (!rule.off_reason.empty()) {
        facts += " " + std::string(rule.off_reason);
        if (!facts.ends_with('.')) facts += '.';
    }
    if (!rule.aliases.empty()) facts += " Also known as " + std::string(rule.aliases) + ".";
    for (const Capability needed : rule.needs) facts += " Only where " + std::string(words_for(needed)) + ".";
    if (!rule.yields_to.empty())
        facts += " Silent where one of these speaks of the same: " + std::string(rule.yields_to) + ".";
    return facts;
}

std::string markdown_examples(std::string_view heading, const std::vector<Example>& examples) {
    std::string out;
    for (const Example& example : examples)
        out += "\n## " + std::string(heading) + " (" + origin_of(example) + ")\n\n```\n" +
               shown_example(example) + "```\n";
    return out;
}

/// Dialects of which the rule has an example.
auto dialects_of(const Rule& rule) {
    return [&rule](const Dialect& dialect) {
        const auto is_of_dialect = [&](const Example& example) { return example.dialect == dialect.name; };
        return std::ranges::any_of(rule.bad, is_of_dialect) || std::ranges::any_of(rule.good, is_of_dialect);
    };
}

std::string alarm_line(const Alarm& alarm) {
    const ControlAlarm* known = find_alarm(alarm.control, alarm.number);
    return std::string(alarm.control) + ": " + std::string(alarm.number) + " " + std::string(alarm.text) +
           (known != nullptr && known->backing == AlarmBacking::memory ? " (number not confirmed)" : "");
}

} // namespace

std::string page_name(const Rule& rule) { return std::string(rule.code) + ".md"; }

std::string_view help_base() { return {MACLINT_HELP_BASE_URL, sizeof(MACLINT_HELP_BASE_URL) - 1}; }

std::string page_url(const Rule& rule) {
    return help_base().empty() ? "" : std::string(help_base()) + "/" + page_name(rule);
}

std::string_view family_of(const Rule& rule) {
    for (const FamilyRow& row : families)
        if (rule.code.starts_with(row.prefix)) return row.name;
    return "";
}

std::string_view name_of(Precision precision) {
    constexpr std::array<std::string_view, 4> names = {"low", "medium", "high", "very-high"};
    return names.at(static_cast<std::size_t>(precision));
}

std::string precision_of(const Rule& rule, const MeasuredRule* entry) {
    const std::string precision = "Precision: " + std::string(name_of(rule.precision));
    if (entry == nullptr) return precision + ", estimated.";
    const bool is_note = rule.severity == Severity::note;
    const std::string basis = share_of(is_note ? entry->notes : entry->alarms);
    std::string sentences = precision;
    sentences += entry->precision
                     ? ", measured: " + basis + " findings in real programs were worth acting on."
                     : ", estimated.";
    if (!is_note && entry->notes.decided > 0)
        sentences += " Notes of it worth acting on: " + share_of(entry->notes) + ".";
    return sentences;
}

std::string summary_sentence(const Rule& rule) {
    std::string sentence(rule.summary);
    if (!sentence.ends_with('.')) sentence += '.';
    return sentence;
}

std::string markdown_page(const Rule& rule) {
    std::string out = "# " + std::string(rule.code) + " " + std::string(rule.name) + "\n\n";
    out += summary_sentence(rule) + "\n\n" + facts_of(rule) + "\n\n## Why\n\n" + std::string(rule.why) + "\n";
    out += markdown_examples("Bad", rule.bad) + markdown_examples("Good", rule.good);
    if (!rule.alarms.empty()) out += "\n## Alarms it prevents\n\n";
    for (const Alarm& alarm : rule.alarms) out += "- " + alarm_line(alarm) + "\n";
    out += markdown_exemptions(rule);
    out += "\n## To allow it\n\n" + allowances(rule.code, dialects_of(rule), "`", " or ") +
           " at the end of the block, or alone on the line before it.\n";
    if (!rule.sources.empty()) out += "\n## Sources\n\n";
    for (const std::string_view source : rule.sources) out += "- " + source_sentence(source) + "\n";
    return out;
}

std::string plain_page(const Rule& rule, const PageStyle& style, const MarkedLines& marked) {
    PlainPage page(style);
    page.add_title(std::string(rule.code) + " " + std::string(rule.name), family_of(rule));
    page.add(summary_sentence(rule));
    page.add(facts_of(rule));
    page.add_empty_line();
    page.add(rule.why);
    for (std::size_t i = 0; i < rule.bad.size(); ++i)
        page.add_example("Bad", rule.bad[i], i < marked.size() ? marked[i] : std::vector<std::uint32_t>{});
    for (const Example& example : rule.good) page.add_example("Good", example, {});
    if (!rule.alarms.empty()) page.add_heading("Alarms it prevents:");
    for (const Alarm& alarm : rule.alarms) page.add_item(alarm_line(alarm));
    add_exemptions(rule, page);
    page.add_heading("To allow it, at the end of the block or alone on the line before it:");
    page.add_to_copy(allowances(rule.code, dialects_of(rule), "", "\n    "));
    if (!rule.sources.empty()) page.add_heading("Sources:");
    for (const std::string_view source : rule.sources) page.add_source(source);
    return page.take();
}

std::string plain_list(std::span<const Rule* const> rules, ListedRows rows, std::size_t width) {
    std::size_t widest = 0;
    for (const Rule* rule : rules) widest = std::max(widest, rule->name.size());
    std::string out;
    std::string_view family;
    for (const Rule* rule : rules) {
        if (family_of(*rule) != family) {
            family = family_of(*rule);
            out += (out.empty() ? "" : "\n") + std::string(family) + "\n";
        }
        std::string name(rule->name);
        name.resize(widest, ' ');
        out += "  " + std::string(rule->code) + " " + name + " " + std::string(name_of(rule->severity)) +
               (rule->on_by_default ? "\n" : ", off\n") + below_name(rule->summary, width);
        if (rows == ListedRows::shown) out += list_below(*rule, width);
    }
    return out;
}

std::string below_name(std::string_view text, std::size_t width) {
    constexpr std::size_t column = 9;
    const std::size_t room = width == 0 ? std::string::npos : width - column;
    std::string out;
    for (const std::string& line : wrapped(text, room, room)) out += std::string(column, ' ') + line + "\n";
    return out;
}

std::string markdown_index() {
    std::string out = "# Rules\n\n" + std::string(generated_mark) + "\n";
    std::string_view family;
    for (const Rule* rule : all_rules()) {
        if (family_of(*rule) != family) {
            family = family_of(*rule);
            out += "\n## " + std::string(family) +
                   "\n\n| code | name | severity | default | what it finds |\n|---|---|---|---|---|\n";
        }
        out += "| [" + std::string(rule->code) + "](" + page_name(*rule) + ") | " + std::string(rule->name) +
               " | " + std::string(name_of(rule->severity)) + " | " + (rule->on_by_default ? "on" : "off") +
               " | " + std::string(rule->summary) + " |\n";
    }
    return out;
}

} // namespace maclint::cli
