//! Begins the called programs with what is known at the calls, and looks for the nearest alarm.
#include "rules/calls/call_ends_in_alarm_finder.hpp"

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/dataflow/facts/call_begun.hpp"
#include "analyzer/flow/walk.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/values/calculations.hpp"
#include "analyzer/source/budget.hpp"

#include <algorithm>
#include <deque>
#include <limits>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <variant>

namespace maclint::rules {
namespace {

using dataflow::CallBegun;
using dataflow::KnownStart;

constexpr int most_levels = 8;            ///< of calls that lead to the alarm
constexpr std::size_t most_followed = 64; ///< ways to begin one program
/// Letters of arguments that are numbers of something, with a decimal point or without [MAN-PB278].
constexpr std::string_view whole_letters = "DHSTM";
constexpr flow::EdgeId none = std::numeric_limits<flow::EdgeId>::max();

/// Which edges of a program can be taken.
class Edges {
  public:
    explicit Edges(const ProgramAnalysis& analysis)
        : analysis_(analysis) {}
    Edges(const ProgramAnalysis& analysis, std::vector<bool> passable)
        : analysis_(analysis)
        , passable_(std::move(passable)) {}

    [[nodiscard]] bool passable(flow::EdgeId edge) const {
        return passable_.empty() ? analysis_.data().passable(edge) : passable_[edge];
    }

  private:
    const ProgramAnalysis& analysis_;
    std::vector<bool> passable_; ///< for one call of it; empty: for all
};

/// The alarm in which a node ends, or the program that it calls and that does.
struct EndAt {
    std::optional<EffectId> stop;
    const ProgramAnalysis* called = nullptr;
};

EndAt end_at(const ProgramAnalysis& analysis, flow::NodeId node, const Edges& edges) {
    const Slice effects = analysis.graph().nodes[node].effects;
    const bool goes_on = std::ranges::any_of(analysis.graph().out[node],
                                             [&](flow::EdgeId edge) { return edges.passable(edge); });
    for (Id id = effects.first; id < effects.first + effects.count; ++id) {
        const auto& what = analysis.program().effects[id].what;
        const auto* stop = std::get_if<Stop>(&what);
        if (stop != nullptr && stop->kind == Stop::Kind::alarm) return {id};
        const CallSite* site = std::holds_alternative<Call>(what) ? analysis.call_at(id) : nullptr;
        const ProgramAnalysis* called = site == nullptr ? nullptr : queries::called_program(analysis, *site);
        const bool ends = !goes_on && called != nullptr && !site->in_cycle;
        if (ends && called->summary().alarm_end.always) return {std::nullopt, called};
    }
    return {};
}

/// Paths through a called program over the edges that can be taken, from one of its nodes.
class Nearest {
  public:
    Nearest(const ProgramAnalysis& analysis, const Edges& edges, flow::NodeId start)
        : graph_(analysis.graph())
        , edges_(edges)
        , came_by_(graph_.nodes.size(), none)
        , met_(graph_.nodes.size(), false)
        , nearest_{start} {
        met_[start] = true;
    }

    /// The nearest node of which `is_end` says so; nothing where there is none.
    template<class Ask>
    std::optional<flow::NodeId> find(const Ask& is_end) {
        for (std::size_t i = 0; i < nearest_.size(); ++i) {
            if (!Budget::allows()) break;
            const flow::NodeId node = nearest_[i];
            if (is_end(node)) return node;
            for (const flow::EdgeId edge : graph_.out[node])
                if (const flow::NodeId to = graph_.edges[edge].to; !met_[to] && edges_.passable(edge)) {
                    met_[to] = true;
                    came_by_[to] = edge;
                    nearest_.push_back(to);
                }
        }
        return std::nullopt;
    }

    [[nodiscard]] std::vector<flow::EdgeId> path_to(flow::NodeId node) const {
        std::vector<flow::EdgeId> path;
        while (came_by_[node] != none) {
            path.push_back(came_by_[node]);
            node = graph_.edges[path.back()].from;
        }
        std::ranges::reverse(path);
        return path;
    }

  private:
    const flow::Graph& graph_;
    const Edges& edges_;
    std::vector<flow::EdgeId> came_by_;
    std::vector<bool> met_;
    std::vector<flow::NodeId> nearest_;
};

std::optional<AlarmReached> nearest_alarm(const ProgramAnalysis& analysis, const Edges& edges,
                                          flow::NodeId start, int levels) {
    Nearest search(analysis, edges, start);
    EndAt end;
    const auto node = search.find([&](flow::NodeId at) {
        end = end_at(analysis, at, edges);
        return end.stop || end.called != nullptr;
    });
    if (!node) return std::nullopt;
    if (!end.stop)
        return levels == 0 ? std::nullopt : nearest_alarm(*end.called, Edges(*end.called), 0, levels - 1);
    const Span text{analysis.program().effects[*end.stop].span.begin, analysis.graph().nodes[*node].part.end};
    Nearest others(analysis, edges, start);
    const bool several = others
                             .find([&](flow::NodeId at) {
                                 const EndAt other = end_at(analysis, at, edges);
                                 return at != *node && (other.stop || other.called != nullptr);
                             })
                             .has_value();
    return AlarmReached{&analysis, *end.stop, text, search.path_to(*node), several};
}

/// Where the program can still come back, whatever it is called with.
std::vector<bool> nodes_that_return(const ProgramAnalysis& analysis) {
    std::vector<flow::NodeId> exits;
    std::vector<bool> returns(analysis.graph().nodes.size(), false);
    for (const flow::Exit& exit : analysis.graph().exits)
        if (exit.kind != flow::ExitKind::alarm && !returns[exit.node]) {
            returns[exit.node] = true;
            exits.push_back(exit.node);
        }
    flow::walk<flow::Direction::backward>(analysis.graph(), exits, [&](flow::EdgeId, flow::NodeId from) {
        returns[from] = true;
        return flow::Step::go_on;
    });
    return returns;
}

/// The nearest test at which this call has no way but to the alarm, while others may come back from there.
std::optional<flow::NodeId> last_test(const ProgramAnalysis& called, const Edges& edges) {
    const std::vector<bool> returns = nodes_that_return(called);
    const flow::Graph& graph = called.graph();
    return Nearest(called, edges, 0).find([&](flow::NodeId at) {
        return returns[at] && std::ranges::none_of(graph.out[at], [&](flow::EdgeId edge) {
                   return edges.passable(edge) && returns[graph.edges[edge].to];
               });
    });
}

bool has_number(const dataflow::KnownVariable& known) { return known.number.has_value(); }
bool has_numbers(const KnownStart& start) { return std::ranges::any_of(start.known, has_number); }

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

/// The same start of the same program leads to the same alarm.
struct Followed {
    const KnownStart* start;
    std::optional<AlarmedCall> found;
};

class Finder {
  public:
    explicit Finder(const ProgramAnalysis& analysis)
        : analysis_(analysis) {}

    std::vector<AlarmedCall> run() {
        std::vector<AlarmedCall> found;
        for (const CallBegun& begun : analysis_.facts().all<CallBegun>()) {
            if (!Budget::allows()) break;
            const CallSite* site = analysis_.call_at(begun.effect);
            const ProgramAnalysis* called =
                site == nullptr ? nullptr : queries::called_program(analysis_, *site);
            if (called == nullptr || is_made_to_stop(begun, *called)) continue;
            const auto& end = end_for(*called, begun);
            if (end && told_.insert(begun.effect).second) {
                found.push_back(*end);
                found.back().node = begun.node;
                found.back().call = begun.effect;
                if (found.back().reason == AlarmReason::left_out &&
                    is_out_of_order(begun.effect, found.back()))
                    found.back().reason = AlarmReason::out_of_order;
            }
        }
        std::ranges::sort(found, {}, &AlarmedCall::call);
        return found;
    }

  private:
    [[nodiscard]] bool is_made_to_stop(const CallBegun& begun, const ProgramAnalysis& called) const {
        const Call& call = queries::call_of(analysis_.program(), begun.effect);
        if (analysis_.control().calls[call.kind].trigger != CallTrigger::once) return false;
        return exemptions::called_to_stop.is_on() && called.summary().alarm_end.is_for_stopping() &&
               !analysis_.graph().expects_return(begun.node);
    }

    /// Whether the call writes the letter of a variable that is vacant all the same: I behind K is a second
    /// I.
    [[nodiscard]] bool is_out_of_order(EffectId effect, const AlarmedCall& alarmed) const {
        const auto arguments =
            analysis_.program().arguments_of(queries::call_of(analysis_.program(), effect));
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

    const std::optional<AlarmedCall>& end_for(const ProgramAnalysis& called, const CallBegun& begun) {
        const auto& end = follow(called, begun.start);
        if (end || begun.with_numbers.known.empty()) return end;
        KnownStart start = begun.with_numbers;
        std::erase_if(start.known, [&](const dataflow::KnownVariable& known) {
            return has_number(known) && !is_certain(begun.effect, known);
        });
        if (!has_numbers(start)) return end;
        return follow(called, with_numbers_.emplace_back(std::move(start)));
    }

    /// Whether the control has that number, too: no calculation has rounded it, and it is not one that is
    /// passed without a decimal point, of which a parameter says what it counts in.
    [[nodiscard]] bool is_certain(EffectId effect, const dataflow::KnownVariable& known) const {
        if (!queries::is_as_written(*known.number)) return false;
        const Program& program = analysis_.program();
        const auto arguments = program.arguments_of(queries::call_of(program, effect));
        const auto passed = std::ranges::find_if(arguments, [&](const Argument& argument) {
            const auto* given = std::get_if<Variable>(&argument.given);
            return given != nullptr && *given == known.variable;
        });
        if (passed == arguments.end() || analysis_.control().calculator_input) return true;
        const auto* literal = std::get_if<Literal>(&program.expressions[passed->value].node);
        return literal == nullptr || literal->decimal_point || literal->value == 0 ||
               whole_letters.find(passed->address) != std::string_view::npos;
    }

    const std::optional<AlarmedCall>& follow(const ProgramAnalysis& called, const KnownStart& start) {
        static const std::optional<AlarmedCall> comes_back;
        auto& followed = followed_[&called];
        const auto before =
            std::ranges::find_if(followed, [&](const Followed& other) { return *other.start == start; });
        if (before != followed.end()) return before->found;
        if (followed.size() >= most_followed) return comes_back;
        followed.push_back({&start, end_of(called, start)});
        return followed.back().found;
    }

    static std::optional<AlarmedCall> end_of(const ProgramAnalysis& called, const KnownStart& start) {
        const dataflow::AlarmEnd& end = called.summary().alarm_end;
        if (end.in_text) {
            auto alarm = nearest_alarm(called, Edges(called), 0, most_levels);
            if (!alarm) return std::nullopt;
            const AlarmReason reason = end.by_mistake ? AlarmReason::fallen_in : AlarmReason::always;
            return AlarmedCall{0, 0, &called, reason, {}, std::move(*alarm)};
        }
        const bool is_nothing_known = start.known.empty() && !start.arguments;
        if (is_nothing_known || called.data().comes_back(start)) return std::nullopt;
        const dataflow::Begun begun = called.data().begun_with(start);
        const bool only_alarms = std::ranges::all_of(called.graph().exits, [&](const flow::Exit& exit) {
            return exit.kind == flow::ExitKind::alarm || !begun.reached[exit.node];
        });
        const Edges edges(called, begun.passable);
        const auto test = only_alarms ? last_test(called, edges) : std::nullopt;
        if (!test) return std::nullopt;
        auto alarm = nearest_alarm(called, edges, *test, most_levels);
        if (!alarm) return std::nullopt;
        const AlarmReason reason = has_numbers(start) ? AlarmReason::number : AlarmReason::left_out;
        return AlarmedCall{0, 0, &called, reason, asked_at(called, *test, start), std::move(*alarm)};
    }

    const ProgramAnalysis& analysis_;
    std::unordered_map<const ProgramAnalysis*, std::vector<Followed>> followed_;
    std::unordered_set<EffectId> told_;
    std::deque<KnownStart> with_numbers_; ///< that were followed
};

} // namespace

std::vector<AlarmedCall> find_alarmed_calls(const ProgramAnalysis& analysis) {
    return Finder(analysis).run();
}

} // namespace maclint::rules
