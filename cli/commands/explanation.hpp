//! What `maclint explain` knows of a word: pages, and rules that it may mean.
#pragma once

#include "cli/command_line.hpp"
#include "cli/config/rule_words.hpp"
#include "cli/report/plain_page.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli {

/// A page on one thing.
struct ExplainedPage {
    std::string_view kind;       ///< "rule", "row", "code", "word", "variable", "alarm" or "exemption"
    std::string text;            ///< laid out for reading
    NamedRule named = {nullptr}; ///< of a rule or a row
};

struct Explanation {
    std::vector<ExplainedPage> pages;
    std::vector<NamedRule>
        meant; ///< that the word may mean, where there is more than one; they have no pages
};

/// Both empty: nobody knows the word.
[[nodiscard]] Explanation explanation_of(const ExplainRequest& request, const PageStyle& style);

} // namespace maclint::cli
