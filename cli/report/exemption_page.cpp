//! A name, why the guess is made, and the program that wants it.
#include "cli/report/exemption_page.hpp"

#include <algorithm>

namespace maclint::cli {
namespace {

std::vector<NamedExemption> exemptions_of_rule(const Rule& rule) {
    std::vector<NamedExemption> own;
    std::ranges::copy_if(all_exemptions(), std::back_inserter(own),
                         [&](const NamedExemption& exemption) { return exemption.rule == &rule; });
    return own;
}

} // namespace

std::string markdown_exemptions(const Rule& rule) {
    if (rule.exemptions.empty()) return {};
    std::string out =
        "\n## Exemptions\n\nGuesses at what is meant, by which it says nothing. `--show-withheld` "
        "shows what they hold back,\n`--without-exemption NAME` does without one.\n";
    for (const NamedExemption& exemption : exemptions_of_rule(rule))
        out += "\n### " + exemption.name() + "\n\n" + std::string(exemption.record().why) + "\n\n```\n" +
               shown_example(exemption.record().wanted_by) + "```\n";
    return out;
}

void add_exemptions(const Rule& rule, PlainPage& page) {
    if (rule.exemptions.empty()) return;
    page.add_heading("Exemptions, guesses by which it says nothing (--show-withheld):");
    for (const NamedExemption& exemption : exemptions_of_rule(rule))
        page.add_item(exemption.name() + ": " + std::string(exemption.record().why));
}

std::string plain_exemption_page(const NamedExemption& exemption, const PageStyle& style) {
    const RuleExemption& record = exemption.record();
    PlainPage page(style);
    page.add_title(exemption.name(), "exemption of " + std::string(exemption.rule->name));
    page.add(record.why);
    page.add_example("Nothing is said of", record.wanted_by, {});
    page.add_heading("To hear of it:");
    page.add_to_copy("maclint check --without-exemption " + exemption.name());
    return page.take();
}

} // namespace maclint::cli
