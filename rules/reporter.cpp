//! Collects the findings of one rule.
#include "rules/rule.hpp"

namespace maclint {

Finding& Reporter::report(const ProgramFile& file, Span span, std::string_view message_id,
                          std::vector<std::string> arguments) {
    return findings_.emplace_back(
        Finding{rule_, rule_->severity, &file, span, message_id, std::move(arguments), {}, {}, {}});
}

} // namespace maclint
