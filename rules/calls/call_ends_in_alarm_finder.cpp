//! Begins the called programs with what is known at the calls, and looks for the nearest alarm.
#include "rules/calls/call_ends_in_alarm_finder.hpp"

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/dataflow/facts/call_begun.hpp"
#include "analyzer/dataflow/solver/known_calls.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/begun_programs.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/calls/shown_calls.hpp"
#include "analyzer/source/budget.hpp"
#include "rules/calls/call_ends_in_alarm_ends_finder.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

namespace maclint::rules {
namespace {

using dataflow::CallBegun;
using dataflow::KnownStart;
using queries::has_number;
using queries::has_numbers;

constexpr int most_levels = 8;            ///< of calls that lead to the alarm
constexpr int most_passed_on = 3;         ///< calls, one in the other, that pass on what decides
constexpr std::size_t most_followed = 64; ///< ways to begin one program
constexpr int no_level = -1;
constexpr std::size_t most_nodes = 300; ///< of a program that passes on what it is given

/// Whether the start decides what the variable is: a number where it knows any, else vacant.
bool is_decided(const ProgramAnalysis& called, const KnownStart& start, Variable variable) {
    const auto known = std::ranges::find(start.known, variable, &dataflow::KnownVariable::variable);
    if (has_numbers(start)) return known != start.known.end() && has_number(*known);
    if (known != start.known.end()) return true;
    using Passed = std::pair<Variable, dataflow::Vacancy>;
    return start.arguments && called.program().is_formal(variable) &&
           std::ranges::find(*start.arguments, variable, &Passed::first) == start.arguments->end();
}

/// What the condition of the test reads of it.
std::vector<Variable> asked_at(const ProgramAnalysis& called, flow::NodeId test, const KnownStart& start) {
    std::vector<Variable> asked;
    for (const flow::EdgeId edge : called.graph().out[test]) {
        const auto& condition = called.graph().edges[edge].condition;
        if (!condition) continue;
        for (const Variable variable : dataflow::variables_of(called.program(), *condition).variables)
            if (is_decided(called, start, variable) && std::ranges::find(asked, variable) == asked.end())
                asked.push_back(variable);
    }
    return asked;
}

/// What the start decides of what the call passes for the variables.
std::vector<Variable> asked_through(const ProgramAnalysis& called, EffectId call,
                                    std::span<const Variable> variables, const KnownStart& start) {
    std::vector<Variable> asked;
    const auto add = [&](Variable variable) {
        if (is_decided(called, start, variable) && std::ranges::find(asked, variable) == asked.end())
            asked.push_back(variable);
    };
    const auto arguments = called.program().arguments_of(queries::call_of(called.program(), call));
    for (const Variable variable : variables) {
        const decltype(Argument::given) given = variable;
        const auto argument = std::ranges::find(arguments, given, &Argument::given);
        if (argument == arguments.end())
            add(variable);
        else
            for (const Variable made_of : dataflow::variables_of(called.program(), argument->value).variables)
                add(made_of);
    }
    return asked;
}

const ProgramAnalysis* called_at(const ProgramAnalysis& calling, EffectId call) {
    const CallSite* site = calling.call_at(call);
    return site == nullptr ? nullptr : queries::called_program(calling, *site);
}

bool is_made_to_stop(const ProgramAnalysis& calling, const CallBegun& begun, const ProgramAnalysis& called) {
    const Call& call = queries::call_of(calling.program(), begun.effect);
    if (calling.control().calls[call.kind].trigger != CallTrigger::once) return false;
    return exemptions::called_to_stop.is_on() && called.summary().alarm_end.is_for_stopping() &&
           !calling.graph().expects_return(begun.node);
}

/// Whether the call writes the letter of a variable that is vacant all the same: I behind K is a second I.
bool is_out_of_order(const ProgramAnalysis& calling, const AlarmedCall& alarmed) {
    const auto arguments = calling.program().arguments_of(queries::call_of(calling.program(), alarmed.call));
    const ControlModel& control = alarmed.called->control();
    return std::ranges::any_of(alarmed.asked, [&](Variable variable) {
        const auto formal = std::ranges::find(control.formals, variable) - control.formals.begin();
        const auto place = static_cast<std::size_t>(formal);
        return place < control.formal_letters.size() &&
               std::ranges::any_of(arguments, [&](const Argument& argument) {
                   const auto* given = std::get_if<Variable>(&argument.given);
                   return given != nullptr && *given != variable &&
                          argument.address == std::string_view(&control.formal_letters[place], 1);
               });
    });
}

/// Follows calls, those of one start of one program once.
class Ends {
  public:
    /// What is vacant is asked first. `levels`: so many calls, one in the other, may pass on what decides.
    std::optional<AlarmedCall> of(const ProgramAnalysis& calling, const CallBegun& begun, int levels) {
        const ProgramAnalysis* called = called_at(calling, begun.effect);
        if (called == nullptr || !may_alarm(*called) || is_made_to_stop(calling, begun, *called))
            return std::nullopt;
        auto end = follow(*called, begun.start, levels);
        if (!end)
            if (auto start = queries::certain_numbers(calling, begun))
                end = follow(*called, *std::move(start), levels);
        if (!end) return std::nullopt;
        end->node = begun.node;
        end->call = begun.effect;
        if (end->reason == AlarmReason::left_out && is_out_of_order(calling, *end))
            end->reason = AlarmReason::out_of_order;
        return end;
    }

    /// The same of a program that is begun so.
    std::optional<AlarmedCall> of_start(const ProgramAnalysis& called, const KnownStart& start, int levels) {
        if (!may_alarm(called) || called.summary().alarm_end.always) return std::nullopt;
        KnownStart vacant = start;
        std::erase_if(vacant.known, has_number);
        auto end = follow(called, vacant, levels);
        return end ? end : follow(called, start, levels);
    }

  private:
    struct Followed {
        KnownStart start;
        int levels; ///< that may pass it on; `no_level`: it was asked how the program itself ends
        std::optional<AlarmedCall> found;
    };

    static bool may_alarm(const ProgramAnalysis& called) {
        const dataflow::Summary& summary = called.summary();
        return summary.alarm_end.always || !summary.decides_end.empty() || !summary.decides_calls.empty();
    }

    std::optional<AlarmedCall> follow(const ProgramAnalysis& called, const KnownStart& start, int levels) {
        const dataflow::Summary& summary = called.summary();
        KnownStart for_end = start;
        std::erase_if(for_end.known, [&](const dataflow::KnownVariable& known) {
            return std::ranges::find(summary.decides_end, known.variable) == summary.decides_end.end();
        });
        auto end = once(called, std::move(for_end), no_level,
                        [&](const KnownStart& kept) { return end_of(called, kept); });
        if (end || levels == 0 || !decides_calls(called, start)) return end;
        return once(called, start, levels,
                    [&](const KnownStart& kept) { return end_passed_on(called, kept, levels); });
    }

    /// Whether something is known of what the program passes on.
    static bool decides_calls(const ProgramAnalysis& called, const KnownStart& start) {
        return std::ranges::any_of(called.summary().decides_calls,
                                   [&](Variable variable) { return is_decided(called, start, variable); });
    }

    /// What was found before for the same start.
    template<class Find>
    std::optional<AlarmedCall> once(const ProgramAnalysis& called, KnownStart start, int levels,
                                    const Find& find) {
        auto& followed = followed_[&called];
        const auto before = std::ranges::find_if(
            followed, [&](const Followed& other) { return other.levels == levels && other.start == start; });
        if (before != followed.end()) return before->found;
        if (followed.size() >= most_followed) return std::nullopt;
        auto end = find(start);
        followed_[&called].push_back({std::move(start), levels, end});
        return end;
    }

    static std::optional<AlarmedCall> end_of(const ProgramAnalysis& called, const KnownStart& start) {
        const dataflow::AlarmEnd& end = called.summary().alarm_end;
        if (end.in_text) {
            auto alarm = nearest_alarm(called, called.data(), 0, most_levels);
            if (!alarm) return std::nullopt;
            const AlarmReason reason = end.by_mistake ? AlarmReason::fallen_in : AlarmReason::always;
            return AlarmedCall{0, 0, &called, reason, {}, std::move(*alarm), {}};
        }
        if (called.summary().decides_end.empty() && !end.always) return std::nullopt;
        if (is_nothing_known(start) || called.data().comes_back(start)) return std::nullopt;
        const dataflow::Analysis begun = called.data().begun_with(start, {});
        const bool only_alarms = std::ranges::all_of(called.graph().exits, [&](const flow::Exit& exit) {
            return exit.kind == flow::ExitKind::alarm || !begun.reached(exit.node);
        });
        const auto test = only_alarms ? last_test(called, begun) : std::nullopt;
        if (!test) return std::nullopt;
        auto alarm = nearest_alarm(called, begun, *test, most_levels);
        if (!alarm) return std::nullopt;
        return AlarmedCall{
            0, 0, &called, reason_for(start), asked_at(called, *test, start), std::move(*alarm), {}};
    }

    /// The alarm of a further program, which this one always calls with what brings it. A call that brings it
    /// whatever this one is given is told by itself.
    std::optional<AlarmedCall> end_passed_on(const ProgramAnalysis& called, const KnownStart& start,
                                             int levels) {
        if (called.graph().nodes.size() > most_nodes) return std::nullopt;
        const auto stops = [&](std::span<const CallBegun> calls) {
            return std::ranges::any_of(calls, [&](const CallBegun& passed) {
                return of(called, passed, levels - 1) && !ends_for_all(called, passed.effect, levels);
            });
        };
        if (ways_around(called).may_leave(start, stops)) return std::nullopt;
        const dataflow::Analysis begun = called.data().begun_with(start, dataflow::facts<CallBegun>());
        std::vector<bool> ends(called.graph().nodes.size(), false);
        std::optional<AlarmedCall> first;
        for (const CallBegun& passed : begun.facts().all<CallBegun>()) {
            if (!Budget::allows()) return std::nullopt;
            auto end = of(called, passed, levels - 1);
            if (!end || ends_for_all(called, passed.effect, levels)) continue;
            ends[passed.node] = true;
            if (!first) first = std::move(end);
        }
        if (!first || !queries::always_comes_by(called.graph(), begun, ends)) return std::nullopt;
        AlarmedCall end{0,
                        0,
                        &called,
                        reason_for(start),
                        asked_through(called, first->call, first->asked, start),
                        std::move(first->alarm),
                        std::move(first->through)};
        end.through.insert(end.through.begin(), {&called, first->call, path_to(called, begun, first->node)});
        return end;
    }

    /// Around calls that may bring an alarm.
    const dataflow::WaysAround& ways_around(const ProgramAnalysis& called) {
        const auto known = ways_.find(&called);
        if (known != ways_.end()) return known->second;
        std::vector<bool> nodes(called.graph().nodes.size(), false);
        for (const CallBegun& begun : called.facts().all<CallBegun>())
            if (const ProgramAnalysis* next = called_at(called, begun.effect);
                next != nullptr && may_alarm(*next))
                nodes[begun.node] = true;
        return ways_.try_emplace(&called, called.program(), called.graph(), called.data(), std::move(nodes))
            .first->second;
    }

    bool ends_for_all(const ProgramAnalysis& called, EffectId call, int levels) {
        return std::ranges::any_of(called.facts().at<CallBegun>(call), [&](const CallBegun& begun) {
            return of(called, begun, levels - 1).has_value();
        });
    }

    static bool is_nothing_known(const KnownStart& start) { return start.known.empty() && !start.arguments; }
    static AlarmReason reason_for(const KnownStart& start) {
        return has_numbers(start) ? AlarmReason::number : AlarmReason::left_out;
    }

    std::unordered_map<const ProgramAnalysis*, std::vector<Followed>> followed_;
    std::unordered_map<const ProgramAnalysis*, dataflow::WaysAround> ways_; ///< around calls that may alarm
};

} // namespace

std::vector<AlarmedCall> find_alarmed_calls(const ProgramAnalysis& analysis) {
    Ends ends;
    std::vector<AlarmedCall> found;
    std::unordered_set<EffectId> told;
    for (const CallBegun& begun : analysis.facts().all<CallBegun>()) {
        if (!Budget::allows()) break;
        auto end = ends.of(analysis, begun, most_passed_on);
        if (end && told.insert(begun.effect).second) found.push_back(std::move(*end));
    }
    std::ranges::sort(found, {}, &AlarmedCall::call);
    for (const queries::ShownCall& shown : queries::shown_calls(analysis))
        if (auto end = ends.of_start(analysis, shown.start, most_passed_on)) {
            end->shown = shown.span;
            found.push_back(std::move(*end));
        }
    return found;
}

} // namespace maclint::rules
