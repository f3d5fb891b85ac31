//! The worklist solver: states along edges until nothing changes, then one pass that writes the facts down.
#include "analyzer/dataflow/analysis.hpp"

#include "analyzer/dataflow/transfer.hpp"
#include "analyzer/dataflow/worklist.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace maclint::dataflow {
namespace {

/// So many visits of a loop head before its bounds are widened, and of any node before its old state is kept
/// in the join.
constexpr std::uint32_t visits_before_widening = 2;
constexpr std::uint32_t visits_before_keeping = 12;
/// So many visits of a loop head before bounds stop growing from threshold to threshold.
constexpr std::uint32_t visits_before_infinity = 5;
constexpr std::size_t most_thresholds = 128;

/// The numbers that the program compares with: bounds of loops usually stop there.
std::vector<double> thresholds_of(const Program& program) {
    std::vector<double> numbers{0};
    for (const Expression& expression : program.expressions) {
        const auto* apply = std::get_if<Apply>(&expression.node);
        if (apply == nullptr || !is_comparison(apply->operation)) continue;
        for (const ExpressionId operand : program.operands_of(*apply))
            if (const auto* literal = std::get_if<Literal>(&program.expressions[operand].node))
                numbers.push_back(literal->value);
        if (numbers.size() > most_thresholds) break;
    }
    std::ranges::sort(numbers);
    numbers.erase(std::ranges::unique(numbers).begin(), numbers.end());
    return numbers;
}

constexpr std::size_t worth_keeping = std::size_t{1} << 16U; ///< bytes of a list

template<class T>
void hand_over_list(std::vector<T>& from, std::vector<T>& to) {
    if (from.capacity() * sizeof(T) > worth_keeping) {
        to = std::move(from);
        to.shrink_to_fit();
        from = {};
    } else {
        to.assign(std::move_iterator(from.begin()), std::move_iterator(from.end()));
        from.clear();
    }
}

/// Lists that every solver needs: most programs are small, and there are many.
struct SolverLists {
    std::vector<State> before;         ///< of every node
    std::vector<State> along;          ///< of every edge
    std::vector<std::uint32_t> visits; ///< of every node
    Facts facts;

    void prepare(const flow::Graph& graph) {
        before.assign(graph.nodes.size(), {});
        along.assign(graph.edges.size(), {});
        visits.assign(graph.nodes.size(), 0);
    }
    /// Keeps their memory for the next program, unless it is much.
    void release() {
        if (along.capacity() * sizeof(State) > worth_keeping) *this = {};
    }
};

} // namespace

void Facts::hand_over(Facts& to) {
    hand_over_list(comparisons, to.comparisons);
    hand_over_list(conditions, to.conditions);
    hand_over_list(reads, to.reads);
    hand_over_list(modal_reads, to.modal_reads);
    hand_over_list(stores, to.stores);
    hand_over_list(clobbers, to.clobbers);
    hand_over_list(calls, to.calls);
    hand_over_list(modal_writes, to.modal_writes);
    hand_over_list(computed_jumps, to.computed_jumps);
    hand_over_list(tool_changes, to.tool_changes);
    hand_over_list(watched, to.watched);
    hand_over_list(exits, to.exits);
}

/// Fills an Analysis.
class Solver {
  public:
    Solver(const Program& program, const flow::Graph& graph, const Callees& callees, SolverLists& lists,
           Analysis& result)
        : program_(program)
        , graph_(graph)
        , callees_(callees)
        , states_(*result.states_)
        , transfer_(program, graph, states_, callees)
        , result_(result)
        , thresholds_(thresholds_of(program))
        , before_(lists.before)
        , along_(lists.along)
        , visits_(lists.visits)
        , facts_(lists.facts) {
        lists.prepare(graph);
    }

    void run() {
        result_.reached_.assign(graph_.nodes.size(), false);
        result_.passable_.assign(graph_.edges.size(), false);
        collect_heads();
        solve();
        narrow();
        record();
        summarise();
        keep_what_rules_ask_for();
    }

  private:
    /// In every cycle an edge leads back in the text: states are widened there.
    void collect_heads() {
        head_.assign(graph_.nodes.size(), false);
        for (const flow::Edge& edge : graph_.edges) {
            if (edge.to <= edge.from) head_[edge.to] = true;
        }
    }

    /// The state in front of a node: all paths that lead there.
    [[nodiscard]] State incoming(flow::NodeId node) {
        State state = node == 0 ? states_.at_entry() : State{};
        for (const flow::EdgeId edge : graph_.in[node]) state = states_.join(state, along_[edge], node);
        return state;
    }

    void solve() {
        Worklist waiting(graph_.nodes.size());
        const auto add = [&](flow::NodeId node) { waiting.add(node); };
        add(0);
        while (const auto node = waiting.take()) {
            const std::uint32_t visit = visits_[*node]++;
            if (!update_state(*node, visit)) continue;
            if (before_[*node].reached) propagate(*node, add);
        }
    }

    /// Whether the state in front of the node has changed.
    bool update_state(flow::NodeId node, std::uint32_t visit) {
        State& old = before_[node];
        const auto in = graph_.in[node];
        if (in.size() == 1 && node != 0 && !head_[node]) {
            // It comes here because that edge has changed.
            old = along_[in.front()];
            return true;
        }
        State state = incoming(node);
        if (old.reached) {
            if (head_[node] && visit >= visits_before_widening)
                state = states_.widen(old, state, node, thresholds_at(visit));
            else if (visit >= visits_before_keeping)
                state = states_.join(old, state, node);
            if (states_.equal(state, old)) return false;
        }
        old = state;
        return true;
    }

    [[nodiscard]] std::span<const double> thresholds_at(std::uint32_t visit) const {
        return visit < visits_before_infinity ? std::span<const double>(thresholds_)
                                              : std::span<const double>{};
    }

    template<class Add>
    void propagate(flow::NodeId node, const Add& add) {
        const State after = transfer_.run(node, before_[node]);
        for (const flow::EdgeId edge : graph_.out[node]) {
            State next = transfer_.along(graph_.edges[edge], after);
            if (states_.equal(next, along_[edge])) continue;
            along_[edge] = next;
            add(graph_.edges[edge].to);
        }
    }

    /// One sweep without widening wins back bounds that widening gave away; a solution stays a solution. Only
    /// what was widened, and what follows from it, can change.
    void narrow() {
        std::vector<bool> may_change(graph_.nodes.size(), false);
        bool any = false;
        for (flow::NodeId node = 0; node < graph_.nodes.size(); ++node) {
            may_change[node] =
                head_[node] ? visits_[node] > visits_before_widening : visits_[node] > visits_before_keeping;
            any = any || may_change[node];
        }
        if (!any) return;
        for (flow::NodeId node = 0; node < graph_.nodes.size(); ++node) {
            if (!may_change[node] || !before_[node].reached) continue;
            const State state = incoming(node);
            if (states_.equal(state, before_[node])) continue;
            before_[node] = state;
            propagate(node, [&](flow::NodeId next) { may_change[next] = true; });
        }
    }

    void record() {
        transfer_.record_in(&facts_);
        std::vector<bool> leaves(graph_.nodes.size(), false);
        for (const flow::Exit& exit : graph_.exits) leaves[exit.node] = true;
        std::vector<std::pair<flow::NodeId, State>> left;
        left.reserve(graph_.exits.size());
        for (flow::NodeId node = 0; node < graph_.nodes.size(); ++node) {
            if (!before_[node].reached) continue;
            result_.reached_[node] = true;
            const State state = transfer_.run(node, before_[node]);
            if (leaves[node]) left.emplace_back(node, state);
        }
        transfer_.record_in(nullptr);
        for (flow::EdgeId edge = 0; edge < graph_.edges.size(); ++edge)
            result_.passable_[edge] = along_[edge].reached;
        for (const flow::Exit& exit : graph_.exits) {
            const auto after =
                std::ranges::lower_bound(left, exit.node, {}, &decltype(left)::value_type::first);
            if (after == left.end() || after->first != exit.node) continue;
            facts_.exits.push_back({exit, after->second});
        }
    }

    void keep_what_rules_ask_for() {
        std::vector<State*> asked;
        asked.reserve(facts_.tool_changes.size() + facts_.watched.size() + facts_.exits.size());
        for (PointState& point : facts_.tool_changes) asked.push_back(&point.state);
        for (PointState& point : facts_.watched) asked.push_back(&point.state);
        for (ExitState& exit : facts_.exits) asked.push_back(&exit.state);
        states_.keep_only(asked);
        facts_.hand_over(result_.facts_);
    }

    void summarise() {
        Summary& summary = result_.summary_;
        summary.known = true;
        summary.may_stop = may_stop();
        State left;
        for (const ExitState& exit : facts_.exits) {
            if (exit.exit.kind != flow::ExitKind::returns && exit.exit.kind != flow::ExitKind::runs_off)
                continue;
            State state = exit.state;
            const Channels leaving = graph_.channels_at(exit.exit.node).running;
            states_.leave_out(state, static_cast<Channels>(graph_.all_channels & ~leaving));
            left = states_.join(left, state, static_cast<flow::NodeId>(graph_.nodes.size()));
            if (exit.exit.effect)
                add_resume_label(std::get<Return>(program_.effects[*exit.exit.effect].what));
        }
        summary.returns = returns();
        summary.written_for_callers = written_for_callers();
        if (!left.reached) return;
        for (std::size_t space = 0; space < most_spaces; ++space)
            if (states_.table().havoc(left.havoc).by_space[space] != 0)
                summary.havoc.push_back(static_cast<SpaceId>(space));
        states_.trees().for_each(left.root, [&](Key key, std::uint32_t id) {
            if (is_variable_key(key)) {
                const Value& value = states_.table().values[id];
                const Symbol& symbol = states_.table().symbols[value.symbol];
                if (symbol.kind == Symbol::Kind::entry && symbol.a == key) return;
                summary.variables.push_back(
                    {variable_of(key), value.vacancy, value.low, value.high, value.integer, value.exactness});
            } else if (is_group_key(key)) {
                summary.groups.push_back(describe(group_of(key), states_.table().modals[id]));
            }
        });
    }

    /// Variables that a caller may have handed down and that this program, or one that it calls, writes.
    [[nodiscard]] std::optional<std::vector<std::string>> written_for_callers() const {
        const auto& spaces = program_.control->spaces;
        std::vector<std::string> written;
        if (std::ranges::none_of(spaces, &VariableSpace::handed_down)) return written;
        const auto add = [&](Variable variable) {
            const VariableSpace& space = spaces[variable.space];
            if (space.handed_down && !space.written_once) written.push_back(program_.spell(variable));
        };
        for (const Store& store : facts_.stores) add(store.variable);
        for (const Clobber& clobber : facts_.clobbers) {
            if (!clobber.variable && spaces[clobber.space].handed_down) return std::nullopt;
            if (clobber.variable) add(*clobber.variable);
        }
        for (const CallMade& call : facts_.calls) {
            const auto& below = callees_(call.effect).summary.written_for_callers;
            if (!below) return std::nullopt;
            written.insert(written.end(), below->begin(), below->end());
        }
        std::ranges::sort(written);
        written.erase(std::ranges::unique(written).begin(), written.end());
        return written;
    }

    [[nodiscard]] bool may_stop() const {
        return std::ranges::any_of(facts_.calls, &CallMade::may_stop) ||
               any_reached([](const Effect& effect) {
                   return std::holds_alternative<Stop>(effect.what) ||
                          std::holds_alternative<UnreadableBlock>(effect.what);
               });
    }

    /// A block that could not be read may be the return.
    [[nodiscard]] bool returns() const {
        return std::ranges::any_of(facts_.exits,
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
            if (result_.reached_[node] &&
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

    void add_resume_label(const Return& back) {
        if (!back.resume_label) return;
        if (const auto label = flow::constant_target(program_, *back.resume_label))
            result_.summary_.resume_labels.push_back(callers_label(program_, *label));
    }

    const Program& program_;
    const flow::Graph& graph_;
    const Callees& callees_;
    States& states_;
    Transfer transfer_;
    Analysis& result_;
    std::vector<double> thresholds_;
    std::vector<State>& before_;
    std::vector<State>& along_;
    std::vector<std::uint32_t>& visits_;
    Facts& facts_;
    std::vector<bool> head_;
};

Analysis::Analysis(const Program& program, const flow::Graph& graph, EntryKnowledge knowledge,
                   Callees callees)
    : program_(&program)
    , graph_(&graph)
    , knowledge_(std::move(knowledge))
    , callees_(std::move(callees))
    , states_(std::make_unique<States>(program, knowledge_)) {
    thread_local SolverLists lists;
    Solver(program, graph, callees_, lists, *this).run();
    lists.release();
}

std::optional<flow::EdgeId> Analysis::first_impossible(std::span<const flow::EdgeId> path) const {
    States states(*program_, knowledge_); // of its own: rules ask on several threads
    Transfer transfer(*program_, *graph_, states, callees_);
    State state = states.at_entry();
    for (const flow::EdgeId id : path) {
        const flow::Edge& edge = graph_->edges[id];
        state = transfer.along(edge, transfer.run(edge.from, state));
        if (!state.reached) return id;
    }
    return std::nullopt;
}

Analysis::Analysis(Analysis&&) noexcept = default;
Analysis& Analysis::operator=(Analysis&&) noexcept = default;
Analysis::~Analysis() = default;

Entry Analysis::entry() const { return states_->entry(); }
const ValueTable& Analysis::table() const { return states_->table(); }
ModalValue Analysis::modal(const State& state, flow::NodeId node, GroupId group) const {
    const auto [running, uncertain] = graph_->channels_at(node);
    if (uncertain == 0) return states_->read(state, running, group);
    ModalValue value = states_->read(state, static_cast<Channels>(running & ~uncertain), group);
    value.unknown = true;
    return value;
}
bool Analysis::is_vacant_at_entry(Variable variable) const { return states_->is_vacant_at_entry(variable); }

} // namespace maclint::dataflow
