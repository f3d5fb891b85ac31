//! Words of the messages about calls that end in an alarm.
#include "rules/calls/call_ends_in_alarm_words.hpp"

#include "rules/path.hpp"
#include "rules/trace.hpp"

#include <utility>
#include <vector>

namespace maclint::rules {

std::string names_of(const AlarmedCall& call) {
    std::string names;
    for (const Variable variable : call.asked)
        names += (names.empty() ? "" : ", ") + with_letter(*call.called, variable);
    return names;
}

std::string alarm_of(const AlarmedCall& call) {
    const ProgramAnalysis& stopping = *call.alarm.program;
    return std::string(call.alarm.is_one_of_several ? "an alarm, as " : "") + "'" +
           quoted(stopping.program(), call.alarm.text) + "' on line " +
           line_number(stopping.file(), call.alarm.text.begin);
}

std::string_view message_for(const AlarmedCall& call) {
    switch (call.reason) {
    case AlarmReason::left_out: return call.asked.empty() ? "vacant" : "left-out";
    case AlarmReason::number: return call.asked.empty() ? "numbers" : "number";
    case AlarmReason::out_of_order: return "order";
    case AlarmReason::fallen_in: return "fallen-in";
    case AlarmReason::always: break;
    }
    return "always";
}

void add_steps(Finding& finding, const AlarmedCall& call) {
    const auto add_path = [&](const ProgramAnalysis& program, const std::vector<flow::EdgeId>& path) {
        for (RelatedLocation& step : steps_along(program, path)) finding.related.push_back(std::move(step));
    };
    for (const PassedOn& passed : call.through) {
        add_path(*passed.program, passed.path);
        finding.related.push_back({passed.program->source(),
                                   passed.program->program().effects[passed.call].span,
                                   "the call that passes it on"});
    }
    const AlarmReached& alarm = call.alarm;
    if (!alarm.is_one_of_several) add_path(*alarm.program, alarm.path);
    finding.related.push_back({alarm.program->source(), alarm.text, "the alarm"});
}

} // namespace maclint::rules
