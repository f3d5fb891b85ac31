//! Collects the findings of one rule.
#include "rules/rule.hpp"

#include <algorithm>

namespace maclint {

Finding& Reporter::report(const ProgramFile& file, Span span, std::string_view message_id,
                          std::vector<std::string> arguments) {
    return findings_.emplace_back(
        Finding{rule_, rule_->severity, &file, span, message_id, std::move(arguments), {}, {}, {}});
}

bool Reporter::has_message(std::string_view id) const {
    return std::ranges::find(rule_->messages, id, &Message::id) != rule_->messages.end();
}

} // namespace maclint
