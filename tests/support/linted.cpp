//! Texts in place of files.
#include "tests/support/linted.hpp"

#include <stdexcept>

namespace maclint::test {

cli::Result lint_texts(const std::vector<LintedText>& texts, cli::Overrides overrides) {
    return lint_texts(texts, std::move(overrides), {});
}

cli::Result lint_texts(const std::vector<LintedText>& texts, cli::Overrides overrides,
                       const ExemptionChoice& exemptions) {
    overrides.isolated = true;
    for (const auto* words : {&overrides.select, &overrides.ignore})
        for (const std::string& word : *words)
            if (cli::rules_named(word).empty()) throw std::invalid_argument("no rule " + word);
    cli::Settings settings(std::move(overrides));
    cli::Snapshot snapshot;
    for (const LintedText& text : texts)
        snapshot.files.push_back({{text.path, true, true, false},
                                  *settings.for_file(text.path),
                                  Source::from_bytes(text.path, text.text)});
    cli::Progress progress(cli::Progress::Shown::never);
    return cli::Engine({.jobs = 1, .exemptions = exemptions}, progress).analyse(snapshot);
}

cli::Result lint_text(std::string_view text) { return lint_texts({{"O1.nc", std::string(text)}}, {}); }

std::vector<std::string> codes(const cli::Result& result) {
    std::vector<std::string> all;
    for (const cli::FilteredFinding& evaluated : result.findings)
        if (!evaluated.suppressed) all.emplace_back(evaluated.finding.rule->code);
    return all;
}

} // namespace maclint::test
