//! What MAC456 says of the reasons why a program must not run past its last block.
#pragma once

#include "analyzer/queries/calls/expected_ends.hpp"
#include "rules/finding.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace maclint::rules {

/// One of the messages of the rule, what it says of the evidence, and the place that shows it where the path
/// does not.
struct Evidence {
    std::string_view message;
    std::string shown;
    std::optional<RelatedLocation> place;
};

[[nodiscard]] Evidence evidence_of(const ProgramAnalysis& analysis, const queries::ExpectedEnd& why);

/// The word that leaves the program: that of the other exit, where that ends it for good.
[[nodiscard]] std::string missing_end(const ProgramAnalysis& analysis, const queries::ExpectedEnd& why);

} // namespace maclint::rules
