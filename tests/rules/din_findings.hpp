//! What a rule finds in a DIN PLUS text.
#pragma once

#include "rules/rule.hpp"
#include "tests/support/analysed.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace maclint::test {

inline std::vector<Finding> din_findings(std::string_view code, std::string text) {
    return run_rules(*analyse_text("dinplus", std::move(text)), {{find_rule(code)}}, 1);
}

/// 1-based lines on which the rule speaks.
inline std::vector<std::uint32_t> din_lines(std::string_view code, std::string text) {
    std::vector<std::uint32_t> all;
    for (const Finding& finding : din_findings(code, std::move(text)))
        all.push_back(finding.source->position(finding.span.begin).line);
    return all;
}

/// Whether the rule speaks of a block of MACHINING.
inline bool din_speaks(std::string_view code, const std::string& block) {
    return !din_findings(code, "MACHINING\n" + block + "\n").empty();
}

} // namespace maclint::test
