//! What becomes of findings: rules that are off, severities, suppression comments and what is wrong with
//! those.
#pragma once

#include "cli/config/selection.hpp"
#include "rules/rule.hpp"

#include <optional>
#include <string>
#include <vector>

namespace maclint::cli {

/// The comment that allows a finding, the baseline that knows it, the maker whose program it is in, or the
/// exemptions of its rule that hold it back (Finding::withheld): it does not count.
struct Suppression {
    Span comment = {};
    std::string reason = {};   ///< UTF-8, may be empty
    std::string baseline = {}; ///< path; empty: a comment allows the finding, or
    bool vendor = false;       ///< it is a warning or note in a maker's program
};

struct FilteredFinding {
    Finding finding;
    std::optional<Suppression> suppressed;
};

struct FileRules {
    const ProgramFile* file;
    const RuleStates* rules;
};

/// Rules and rows that must run, wanted or not, so that it can be told which suppressions of the file are of
/// use.
[[nodiscard]] std::vector<NamedRule> rules_in_suppressions(const ProgramFile& file);

/// Judges findings of the files given; others are dropped. In the order of reports.
[[nodiscard]] std::vector<FilteredFinding> apply_suppressions(std::vector<Finding> findings,
                                                              const std::vector<FileRules>& files);

} // namespace maclint::cli
