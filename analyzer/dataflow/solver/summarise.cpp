//! What a call does to its caller, from the states with which the program is left.
#include "analyzer/dataflow/solver/summarise.hpp"

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/dataflow/domain/state.hpp"
#include "analyzer/dataflow/solver/alarm_end.hpp"
#include "analyzer/dataflow/solver/callers_labels.hpp"
#include "analyzer/dataflow/solver/stop_reasons.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <utility>

namespace maclint::dataflow {
namespace {

class Summariser {
  public:
    Summariser(const Program& program, const flow::Graph& graph, const Callees& callees, States& states,
               const FactLists& facts, const std::vector<bool>& reached)
        : program_(program)
        , graph_(graph)
        , callees_(callees)
        , states_(states)
        , facts_(facts)
        , reached_(reached) {}

    Summary run() {
        summarise();
        return std::move(summary_);
    }

  private:
    void summarise() {
        summary_.known = true;
        summary_.may_stop = may_stop();
        if (summary_.may_stop) summary_.stop_reasons = find_stop_reasons(program_, graph_, facts_, reached_);
        State left;
        summary_.returns = returns();
        summary_.alarm_end = find_alarm_end(program_, graph_, callees_, reached_, summary_.returns);
        for (const ExitState& exit : facts_.of<ExitState>()) {
            // A call of what ends in an alarm may count as one that comes back.
            const bool counts = exit.exit.kind == flow::ExitKind::alarm && summary_.alarm_end.always;
            if (exit.exit.kind != flow::ExitKind::returns && exit.exit.kind != flow::ExitKind::runs_off &&
                !counts)
                continue;
            State state = exit.state;
            const Channels leaving = graph_.channels_at(exit.exit.node).running;
            states_.leave_out(state, static_cast<Channels>(graph_.all_channels & ~leaving));
            left = states_.join(left, state, static_cast<flow::NodeId>(graph_.nodes.size()));
            if (exit.exit.kind == flow::ExitKind::returns && exit.exit.effect)
                resume_labels_.add(program_, std::get<Return>(program_.effects[*exit.exit.effect].what));
        }
        summary_.resume_labels = resume_labels_.take();
        if (summary_.returns && summary_.alarm_end.possible) summary_.decides_end = decides_end();
        summary_.written_for_callers = written_for_callers();
        if (!left.reached) return;
        for (std::size_t space = 0; space < most_spaces; ++space)
            if (states_.table().havoc(left.havoc).by_space[space] != 0)
                summary_.havoc.push_back(static_cast<SpaceId>(space));
        const std::vector<Key> written = written_variables();
        states_.trees().for_each(left.root, [&](Key key, std::uint32_t id) {
            if (is_variable_key(key)) {
                // A condition tells what a variable is, and changes nothing.
                if (!std::ranges::binary_search(written, key) && !is_havoc(variable_of(key).space)) return;
                const Value& value = states_.table().values[id];
                const Symbol& symbol = states_.table().symbols[value.symbol];
                if (symbol.is_entry_of(key)) return;
                summary_.variables.push_back(
                    {variable_of(key), value.vacancy, value.low, value.high, value.integer, value.exactness});
            } else if (is_group_key(key)) {
                summary_.groups.push_back(describe(group_of(key), states_.table().modals[id]));
            }
        });
    }

    [[nodiscard]] bool is_havoc(SpaceId space) const {
        return std::ranges::find(summary_.havoc, space) != summary_.havoc.end();
    }

    /// All that is written by name or by a call, sorted.
    [[nodiscard]] std::vector<Key> written_variables() const {
        std::vector<Key> written;
        for (const Store& store : facts_.of<Store>()) written.push_back(key_of(store.variable));
        for (const Clobber& clobber : facts_.of<Clobber>())
            if (clobber.variable) written.push_back(key_of(*clobber.variable));
        std::ranges::sort(written);
        return written;
    }

    static constexpr std::size_t most_written = 1000;
    static constexpr std::size_t most_deciding = 32; ///< whose assignments are followed
    /// Variables that a caller may have handed down and that this program, or one that it calls, writes; of
    /// too many it is not kept which.
    [[nodiscard]] std::optional<std::vector<std::string>> written_for_callers() const {
        const auto& spaces = program_.control->spaces;
        std::vector<std::string> written;
        if (std::ranges::none_of(spaces, &VariableSpace::handed_down)) return written;
        const auto add = [&](Variable variable) {
            if (spaces[variable.space].handed_down) written.push_back(program_.spell(variable));
        };
        for (const Store& store : facts_.of<Store>()) add(store.variable);
        for (const Clobber& clobber : facts_.of<Clobber>()) {
            if (!clobber.variable && spaces[clobber.space].handed_down) return std::nullopt;
            if (clobber.variable) add(*clobber.variable);
        }
        for (const CallMade& call : facts_.of<CallMade>()) {
            const auto& below = callees_(call.effect).summary.written_for_callers;
            if (!below) return std::nullopt;
            written.insert(written.end(), below->begin(), below->end());
        }
        std::ranges::sort(written);
        written.erase(std::ranges::unique(written).begin(), written.end());
        if (written.size() > most_written) return std::nullopt;
        return written;
    }

    /// The variables on which it depends how the program ends, and those that they are made of.
    [[nodiscard]] std::vector<Variable> decides_end() const {
        std::vector<Variable> deciding;
        const auto add_all = [&](ExpressionId expression) {
            for (const Variable variable : variables_of(program_, expression).variables)
                if (!program_.control->spaces[variable.space].named &&
                    std::ranges::find(deciding, variable) == deciding.end())
                    deciding.push_back(variable);
        };
        (void)any_reached([&](const Effect& effect) {
            if (const auto* guarded = std::get_if<Guarded>(&effect.what)) add_all(guarded->condition);
            if (const auto* jump = std::get_if<Jump>(&effect.what)) add_all(jump->target);
            return false;
        });
        // And what these are made of.
        for (std::size_t next = 0; next < std::min(deciding.size(), most_deciding); ++next)
            for (const Store& store : facts_.of<Store>())
                if (store.variable == deciding[next]) add_all(store.expression);
        return deciding;
    }

    [[nodiscard]] bool may_stop() const {
        return std::ranges::any_of(facts_.of<CallMade>(), &CallMade::may_stop) ||
               any_reached([](const Effect& effect) {
                   return std::holds_alternative<Stop>(effect.what) ||
                          std::holds_alternative<UnreadableBlock>(effect.what);
               });
    }

    /// A block that could not be read may be the return.
    [[nodiscard]] bool returns() const {
        return std::ranges::any_of(facts_.of<ExitState>(),
                                   [this](const ExitState& left_with) {
                                       return flow::returns_after_call(program_, left_with.exit);
                                   }) ||
               any_reached([](const Effect& effect) {
                   const auto* unreadable = std::get_if<UnreadableBlock>(&effect.what);
                   return unreadable != nullptr && unreadable->may_call_or_return;
               });
    }

    template<class Predicate>
    [[nodiscard]] bool any_reached(const Predicate& predicate) const {
        for (flow::NodeId node = 0; node < graph_.nodes.size(); ++node)
            if (reached_[node] &&
                std::ranges::any_of(program_.effects_in(graph_.nodes[node].effects), predicate))
                return true;
        return false;
    }

    [[nodiscard]] GroupChange describe(ChannelGroup of, const ModalValue& value) const {
        constexpr Channels all = 0xFFFF;
        const GroupId group = of.group;
        const Channels channels = graph_.channels.empty() ? all : static_cast<Channels>(1U << of.channel);
        GroupChange change{group, false, {}, value.unknown, channels};
        for (const ModalPart& part : value.parts) {
            if (states_.table().entry_group_of(part.symbol) == group)
                change.may_keep = true;
            else if (const auto code = states_.table().number_of(part.symbol))
                change.codes.push_back(*code);
            else
                change.other = true;
        }
        return change;
    }

    const Program& program_;
    const flow::Graph& graph_;
    const Callees& callees_;
    States& states_;
    const FactLists& facts_;
    const std::vector<bool>& reached_;
    Summary summary_;
    CallersLabels resume_labels_;
};

} // namespace

Summary summarise(const Program& program, const flow::Graph& graph, const Callees& callees, States& states,
                  const FactLists& facts, const std::vector<bool>& reached) {
    return Summariser(program, graph, callees, states, facts, reached).run();
}

} // namespace maclint::dataflow
