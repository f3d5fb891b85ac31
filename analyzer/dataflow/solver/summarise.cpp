//! What a call does to its caller, from the states with which the program is left.
#include "analyzer/dataflow/solver/summarise.hpp"

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/dataflow/domain/state.hpp"
#include "analyzer/dataflow/solver/alarm_end.hpp"
#include "analyzer/dataflow/solver/callers_labels.hpp"
#include "analyzer/dataflow/solver/stop_reasons.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <optional>
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
        if (summary_.returns && summary_.alarm_end.possible) summary_.decides_end = with_decisions({});
        if (const auto passed = passed_to_alarms()) summary_.decides_calls = with_sources(*passed);
        summary_.asked_at_calls = asked_at_calls();
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
    static constexpr std::size_t most_of_words = 64; ///< that decide what words are
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

    void add_all(std::vector<Variable>& variables, ExpressionId expression) const {
        for (const Variable variable : variables_of(program_, expression).variables)
            add_one(variables, variable);
    }
    void add_one(std::vector<Variable>& variables, Variable variable) const {
        if (!program_.control->spaces[variable.space].named &&
            std::ranges::find(variables, variable) == variables.end())
            variables.push_back(variable);
    }

    /// With the variables on which it depends where the program goes, and those that all of them are made of.
    [[nodiscard]] std::vector<Variable> with_decisions(std::vector<Variable> deciding) {
        if (!decisions_) {
            decisions_.emplace();
            (void)any_reached([&](const Effect& effect) {
                if (const auto* guarded = std::get_if<Guarded>(&effect.what))
                    add_all(*decisions_, guarded->condition);
                if (const auto* jump = std::get_if<Jump>(&effect.what)) add_all(*decisions_, jump->target);
                return false;
            });
        }
        for (const Variable variable : *decisions_) add_one(deciding, variable);
        return with_sources(std::move(deciding));
    }

    /// With those that they are made of.
    [[nodiscard]] std::vector<Variable> with_sources(std::vector<Variable> deciding) const {
        for (std::size_t next = 0; next < std::min(deciding.size(), most_deciding); ++next)
            for (const Store& store : facts_.of<Store>())
                if (store.variable == deciding[next]) add_all(deciding, store.expression);
        return deciding;
    }

    /// What is passed to programs that end in an alarm for some of it, and what these find set; nothing where
    /// it calls none.
    [[nodiscard]] std::optional<std::vector<Variable>> passed_to_alarms() const {
        std::optional<std::vector<Variable>> passed;
        for (const CallMade& made : facts_.of<CallMade>()) {
            const Summary& called = callees_(made.effect).summary;
            const auto* call = std::get_if<Call>(&program_.effects[made.effect].what);
            if (call == nullptr || (called.decides_end.empty() && called.decides_calls.empty())) continue;
            if (!passed) passed.emplace();
            const bool shared_frame = program_.control->calls[call->kind].frame == Frame::shared;
            for (const auto* deciding : {&called.decides_end, &called.decides_calls})
                for (const Variable variable : *deciding)
                    if (shared_frame || program_.control->spaces[variable.space].scope != Scope::frame)
                        add_one(*passed, variable);
            for (const Argument& argument : program_.arguments_of(*call)) add_all(*passed, argument.value);
        }
        return passed;
    }

    [[nodiscard]] std::vector<Variable> asked_at_calls() {
        std::vector<Variable> asked = summary_.decides_end;
        if (!summary_.decides_calls.empty())
            for (const Variable variable : with_decisions(summary_.decides_calls)) add_one(asked, variable);
        std::vector<Variable> words;
        const bool are_many = any_reached([&](const Effect& effect) {
            if (const auto* values = std::get_if<EvaluateWords>(&effect.what))
                for (const ExpressionId value : program_.values_of(*values)) add_all(words, value);
            return words.size() > most_of_words;
        });
        if (words.empty() || are_many) return asked;
        words = with_decisions(std::move(words));
        if (words.size() > most_of_words) return asked;
        for (const Variable variable : words) add_one(asked, variable);
        return asked;
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
    std::optional<std::vector<Variable>> decisions_; ///< what conditions and jumps read
    CallersLabels resume_labels_;
};

} // namespace

Summary summarise(const Program& program, const flow::Graph& graph, const Callees& callees, States& states,
                  const FactLists& facts, const std::vector<bool>& reached) {
    return Summariser(program, graph, callees, states, facts, reached).run();
}

} // namespace maclint::dataflow
