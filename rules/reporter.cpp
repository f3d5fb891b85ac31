//! Collects the findings of one rule.
#include "rules/reporter.hpp"

#include "analyzer/program/model.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/source/budget.hpp"
#include "rules/rule.hpp"

#include <algorithm>

namespace maclint {

namespace {

Severity severity_in(const ProgramFile& file, const Rule& rule) {
    if (file.control == nullptr) return rule.severity;
    const auto other =
        std::ranges::find(rule.severity_elsewhere, file.control->language, &OtherSeverity::language);
    return other == rule.severity_elsewhere.end() ? rule.severity : other->severity;
}

/// The one alarm that it is true of; nullptr: of none, or of several, and nobody knows which is raised.
template<class Is>
const Alarm* only_one(std::span<const Alarm> alarms, const Is& is) {
    const auto found = std::ranges::find_if(alarms, is);
    if (found == alarms.end() || std::ranges::count_if(alarms, is) != 1) return nullptr;
    return &*found;
}

} // namespace

Finding& Reporter::report(const Cause& cause, Span span, std::string_view message_id,
                          std::vector<std::string> arguments) {
    const ProgramFile& file = *cause.file;
    if (!Budget::is_innermost_spent()) sure_ = findings_.size();
    return findings_.emplace_back(Finding{.rule = rule_,
                                          .cause = cause,
                                          .severity = severity_in(file, *rule_),
                                          .source = file.source,
                                          .span = span,
                                          .message_id = message_id,
                                          .arguments = std::move(arguments),
                                          .related = {},
                                          .path = {},
                                          .fixes = {},
                                          .alarm = severity_in(file, *rule_) == Severity::error
                                                       ? alarm_for(file, message_id)
                                                       : std::string_view()});
}

std::string_view Reporter::alarm_for(const ProgramFile& file, std::string_view trouble) const {
    if (file.control == nullptr) return {};
    const auto raised = [&](const Alarm& alarm) { return alarm.control == file.control->alarms; };
    if (const Alarm* own = only_one(rule_->alarms, [&](const Alarm& alarm) {
            return raised(alarm) && !trouble.empty() && lists_code(alarm.of, trouble);
        }))
        return own->number;
    const Alarm* usual =
        only_one(rule_->alarms, [&](const Alarm& alarm) { return raised(alarm) && alarm.of.empty(); });
    return usual != nullptr && usual->always ? usual->number : std::string_view();
}

std::vector<Finding> Reporter::take() {
    if (Budget::is_innermost_spent())
        findings_.erase(findings_.begin() + static_cast<std::ptrdiff_t>(sure_), findings_.end());
    return std::move(findings_);
}

std::string Reporter::alarm_words(const ProgramFile& file) const {
    const auto known = std::ranges::find_if(rule_->alarms, [&](const Alarm& alarm) {
        return file.control != nullptr && alarm.control == file.control->alarms;
    });
    return known == rule_->alarms.end() ? "an alarm" : "alarm " + std::string(known->number);
}

bool Reporter::has_message(std::string_view id) const {
    return std::ranges::find(rule_->messages, id, &Message::id) != rule_->messages.end();
}

} // namespace maclint
