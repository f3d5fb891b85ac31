//! Pages made from the records of the rules, so that they cannot say anything else.
#include "cli/report/rule_page.hpp"

#include "analyzer/dialect/dialect.hpp"
#include "analyzer/source/encoding.hpp"
#include "cli/config/selection.hpp"
#include "cli/report/ansi_style.hpp"
#include "cli/report/columns.hpp"
#include "cli/report/sources.hpp"

#include <algorithm>
#include <array>

namespace maclint::cli {
namespace {

struct FamilyRow {
    std::string_view prefix;
    std::string_view name;
};

constexpr std::array<FamilyRow, 10> families{{
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
    case Capability::block_references: return "words name blocks of certain sections";
    case Capability::macro_calls: return "macro calls have a limit of their own";
    case Capability::modal_calls: return "programs can be called after every move or block";
    case Capability::named_arguments: return "what a call passes is read by names of its own";
    case Capability::suppression: return "programs can switch off single block, feed hold or override";
    }
    return {};
}

std::string facts_of(const Rule& rule) {
    std::string severity(name_of(rule.severity));
    for (const OtherSeverity& other : rule.severity_elsewhere)
        severity += ", in " + std::string(other.language) + " " + std::string(name_of(other.severity));
    std::string facts = "Severity: " + severity + ". Precision: " + std::string(name_of(rule.precision)) +
                        ". " + (rule.on_by_default ? "On by default." : "Off by default.");
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

std::string indented(std::string_view text, std::string_view indent) {
    std::string out;
    while (!text.empty()) {
        const auto line = text.substr(0, text.find('\n'));
        const std::string shown = printable(to_utf8(line, detect_encoding(line)));
        out += (shown.empty() ? "" : std::string(indent) + shown) + "\n";
        text.remove_prefix(line.size() == text.size() ? line.size() : line.size() + 1);
    }
    return out;
}

/// An example that a page can show: very long ones are cut.
std::string shown_example(const Example& example, std::string_view indent) {
    constexpr std::size_t longest = 2000;
    constexpr std::size_t start = 120;
    const bool cut = example.text.size() > longest;
    std::string out = indented(cut ? example.text.substr(0, start) : example.text, indent);
    if (cut) out += std::string(indent) + "… (" + std::to_string(example.text.size()) + " bytes)\n";
    return out;
}

std::string markdown_examples(std::string_view heading, const std::vector<Example>& examples) {
    std::string out;
    for (const Example& example : examples)
        out += "\n## " + std::string(heading) + " (" + std::string(example.dialect) + ")\n\n```\n" +
               shown_example(example, "") + "```\n";
    return out;
}

std::string alarm_line(const Alarm& alarm) {
    return std::string(alarm.control) + ": " + std::string(alarm.number) + " " + std::string(alarm.text);
}

/// The comment that allows the rule, once for every path that the dialects of its examples write comments.
std::string allowances(const Rule& rule, std::string_view quote, std::string_view between) {
    std::string all;
    for (const Dialect& dialect : dialects()) {
        const auto of_dialect = [&](const Example& example) { return example.dialect == dialect.name; };
        if (std::ranges::none_of(rule.bad, of_dialect) && std::ranges::none_of(rule.good, of_dialect))
            continue;
        const std::string comment = std::string(dialect.comment_open) + "MACLINT ALLOW " +
                                    std::string(rule.code) + " - REASON" + std::string(dialect.comment_close);
        if (all.find(comment) != std::string::npos) continue;
        all.append(all.empty() ? "" : between).append(quote).append(comment).append(quote);
        if (!dialect.comment_open.starts_with('(')) all.append(" (").append(dialect.name).append(")");
    }
    return all;
}

/// A source with what its key means where that decides how far to trust it.
std::string shown_source(std::string_view source) {
    constexpr std::string_view experience = "T";
    if (source != experience && !source.starts_with("T:")) return std::string(source);
    return "T (experience, not confirmed)" + std::string(source.substr(experience.size()));
}

/// Writes a page line by line.
class PlainPage {
  public:
    explicit PlainPage(const PageStyle& style)
        : width_(style.width)
        , style_(style.colour) {}

    [[nodiscard]] std::string of(const Rule& rule, const MarkedLines& marked) {
        out_ = style_.bold(std::string(rule.code) + " " + std::string(rule.name)) + " (" +
               std::string(family_of(rule)) + ")\n\n";
        add(summary_sentence(rule), "");
        add(facts_of(rule), "");
        out_ += "\n";
        add(rule.why, "");
        for (std::size_t i = 0; i < rule.bad.size(); ++i)
            add_example("Bad", rule.bad[i], i < marked.size() ? marked[i] : std::vector<std::uint32_t>{});
        for (const Example& example : rule.good) add_example("Good", example, {});
        if (!rule.alarms.empty()) add_heading("Alarms it prevents:");
        for (const Alarm& alarm : rule.alarms) add(alarm_line(alarm), indent);
        add_heading("To allow it, at the end of the block or alone on the line before it:");
        out_ += std::string(indent) + allowances(rule, "", "\n    ") + "\n"; // to be copied, so not wrapped
        if (!rule.sources.empty()) add_heading("Sources:");
        for (const std::string_view source : rule.sources) add_source(source);
        return std::move(out_);
    }

  private:
    static constexpr std::string_view indent = "    ";

    void add_heading(std::string_view heading) { out_ += "\n" + style_.note(heading) + "\n\n"; }

    void add(std::string_view text, std::string_view before) {
        if (width_ == 0) {
            out_ += std::string(before) + std::string(text) + "\n";
            return;
        }
        const std::size_t room = width_ - before.size();
        for (const std::string& line : wrapped(text, room, room)) out_ += std::string(before) + line + "\n";
    }

    void add_example(std::string_view heading, const Example& example,
                     const std::vector<std::uint32_t>& marked) {
        add_heading(std::string(heading) + " (" + std::string(example.dialect) + "):");
        const std::string text = shown_example(example, "");
        std::uint32_t number = 1;
        for (std::string_view rest = text; !rest.empty(); ++number) {
            const std::string_view line = rest.substr(0, rest.find('\n'));
            rest.remove_prefix(std::min(rest.size(), line.size() + 1));
            if (std::ranges::find(marked, number) != marked.end())
                out_ += "  " + style_.severity(Severity::error, "> " + std::string(line)) + "\n";
            else
                out_ += (line.empty() ? "" : std::string(indent) + std::string(line)) + "\n";
        }
    }

    void add_source(std::string_view source) {
        const std::string shown = shown_source(source);
        add(shown, indent);
        if (shown == source && !document_of(source).empty()) add(document_of(source), "        ");
    }

    std::size_t width_;
    AnsiStyle style_;
    std::string out_;
};

} // namespace

std::string page_name(const Rule& rule) { return std::string(rule.code) + ".md"; }

std::string_view family_of(const Rule& rule) {
    for (const FamilyRow& row : families)
        if (rule.code.starts_with(row.prefix)) return row.name;
    return "";
}

std::string_view name_of(Precision precision) {
    constexpr std::array<std::string_view, 4> names = {"low", "medium", "high", "very-high"};
    return names.at(static_cast<std::size_t>(precision));
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
    out += "\n## To allow it\n\n" + allowances(rule, "`", " or ") +
           " at the end of the block, or alone on the line before it.\n";
    if (!rule.sources.empty()) out += "\n## Sources\n\n";
    for (const std::string_view source : rule.sources) out += "- " + shown_source(source) + "\n";
    return out;
}

std::string plain_page(const Rule& rule, const PageStyle& style, const MarkedLines& marked) {
    return PlainPage(style).of(rule, marked);
}

std::string plain_list(std::span<const Rule* const> rules) {
    std::size_t widest = 0;
    for (const Rule* rule : rules) widest = std::max(widest, rule->name.size());
    std::string out;
    std::string_view family;
    for (const Rule* rule : rules) {
        if (family_of(*rule) != family) {
            family = family_of(*rule);
            out += (out.empty() ? "" : "\n") + std::string(family) + "\n";
        }
        std::string severity(name_of(rule->severity));
        severity.resize(7, ' ');
        out += "  " + std::string(rule->code) + " " + std::string(rule->name) +
               std::string(widest - rule->name.size() + 1, ' ') + severity +
               (rule->on_by_default ? "      " : "  off ") + std::string(rule->summary) + "\n";
    }
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
