//! Lints texts without files: the whole path from bytes to judged findings.
#pragma once

#include "cli/engine/engine.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace maclint::test {

struct LintedText {
    std::string path;
    std::string text;
};

/// All texts as one workspace, isolated from any configuration. Rule words are checked.
[[nodiscard]] cli::Result lint_texts(const std::vector<LintedText>& texts, cli::Overrides overrides);
/// The same with some exemptions off, or what they hold back listed.
[[nodiscard]] cli::Result lint_texts(const std::vector<LintedText>& texts, cli::Overrides overrides,
                                     const ExemptionChoice& exemptions);

/// The same for one text under the default selection.
[[nodiscard]] cli::Result lint_text(std::string_view text);

/// "MAC303", one a finding, in the order of reports; suppressed ones left out.
[[nodiscard]] std::vector<std::string> codes(const cli::Result& result);

} // namespace maclint::test
