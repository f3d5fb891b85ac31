//! Comments that speak to maclint: (MACLINT ALLOW MAC301 - REASON).
#pragma once

#include "analyzer/source/span.hpp"
#include "cli/config/rule_words.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint {
struct DirectiveComment;
}

namespace maclint::cli {

enum class Verb : std::uint8_t {
    allow,      ///< for the block that the comment stands in, or for the next one when it stands alone
    allow_file, ///< for the whole file
    off,        ///< from here on
    on,         ///< no longer
};

/// One word of a directive that names rules.
struct RuleToken {
    Span span;
    std::string word;
    std::vector<NamedRule> rules; ///< empty: there is no such rule or row
};

/// What is wrong with a comment whose first word is MACLINT, as MAC002 says it.
struct DirectiveFault {
    Span span;
    std::string_view message_id;
    std::vector<std::string> arguments;
};

struct Directive {
    const DirectiveComment* comment = nullptr;
    Verb verb = Verb::allow;
    std::vector<RuleToken> tokens; ///< none: all rules (ON only)
    std::string reason;            ///< UTF-8, may be empty
    std::vector<DirectiveFault> faults;
    bool valid = true; ///< otherwise only `faults` counts
};

/// Nothing when the comment merely mentions maclint.
[[nodiscard]] std::optional<Directive> read_directive(const ProgramFile& file,
                                                      const DirectiveComment& comment);

} // namespace maclint::cli
