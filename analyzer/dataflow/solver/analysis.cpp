//! The states of a program are solved; facts are written down as soon as those of a node change no more.
#include "analyzer/dataflow/solver/analysis.hpp"

#include "analyzer/dataflow/facts/fact_lists.hpp"
#include "analyzer/dataflow/solver/state_domain.hpp"
#include "analyzer/dataflow/solver/summarise.hpp"
#include "analyzer/dataflow/solver/transfer.hpp"
#include "analyzer/flow/solve.hpp"
#include "analyzer/source/platform/kept_by_thread.hpp"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace maclint::dataflow {
namespace {

constexpr std::size_t worth_keeping = std::size_t{1} << 16U; ///< bytes of a list

/// Lists that every analysis needs: most programs are small, and there are many.
struct WorkingLists {
    flow::Solution<State> solution;
    FactLists facts;

    /// Keeps their memory for the next program, unless it is much.
    void release() {
        if (solution.along.capacity() * sizeof(State) > worth_keeping) *this = {};
    }
};

/// Writes the facts of each node down when the state in front of it changes no more.
class RecordingDomain : public StateDomain {
  public:
    RecordingDomain(const Program& program, const flow::Graph& graph, States& states, Transfer& transfer,
                    FactLists& facts)
        : StateDomain(program, states, transfer)
        , transfer_(transfer)
        , facts_(facts)
        , leaves_(graph.nodes.size(), false) {
        for (const flow::Exit& exit : graph.exits) leaves_[exit.node] = true;
    }

    [[nodiscard]] State run_settled(flow::NodeId node, const State& state) {
        transfer_.record_in(&facts_);
        State after = transfer_.run(node, state);
        transfer_.record_in(nullptr);
        if (leaves_[node] && after.reached) left_.emplace(node, after);
        return after;
    }

    /// After the node; nothing where the program is not left there.
    [[nodiscard]] std::optional<State> left_at(flow::NodeId node) const {
        const auto found = left_.find(node);
        return found == left_.end() ? std::nullopt : std::optional(found->second);
    }

  private:
    Transfer& transfer_;
    FactLists& facts_;
    std::vector<bool> leaves_; ///< of every node, whether the program may end there
    std::unordered_map<flow::NodeId, State> left_;
};

} // namespace

/// Fills an Analysis.
class AnalysisBuilder {
  public:
    AnalysisBuilder(const Program& program, const flow::Graph& graph, const Callees& callees, FactSet wanted,
                    WorkingLists& lists, Analysis& result)
        : graph_(graph)
        , states_(*result.states_)
        , transfer_(program, graph, states_, callees)
        , result_(result)
        , before_(lists.solution.before)
        , along_(lists.solution.along)
        , wanted_(wanted)
        , facts_(lists.facts) {
        facts_.record_only(wanted | facts_of_summaries);
        RecordingDomain domain(program, graph, states_, transfer_, facts_);
        flow::solve<flow::Direction::forward>(graph, domain, lists.solution);
        facts_.put_in_order();
        for (const flow::Exit& exit : graph.exits)
            if (const auto state = domain.left_at(exit.node)) facts_.add(ExitState{exit, *state});
    }

    void run() {
        for (const State& state : before_) result_.reached_.push_back(state.reached);
        for (const State& state : along_) result_.passable_.push_back(state.reached);
        result_.summary_ =
            summarise(*result_.program_, graph_, result_.callees_, states_, facts_, result_.reached_);
        keep_what_is_wanted();
    }

  private:
    void keep_what_is_wanted() {
        if (wanted_.has<BeforeNode>())
            for (flow::NodeId node = 0; node < before_.size(); ++node)
                if (before_[node].reached) facts_.add(BeforeNode{node, before_[node]});
        std::vector<State*> asked;
        facts_.for_each_state(wanted_, [&](State& state) { asked.push_back(&state); });
        states_.keep_groups_of(asked);
        // Most nodes set no group: only those after a change are kept.
        const auto same = std::ranges::unique(facts_.of<BeforeNode>(), {},
                                              [](const BeforeNode& before) { return before.state.root; });
        facts_.of<BeforeNode>().erase(same.begin(), same.end());
        result_.facts_ = facts_.hand_over(wanted_, worth_keeping);
    }

    const flow::Graph& graph_;
    States& states_;
    Transfer transfer_;
    Analysis& result_;
    const std::vector<State>& before_;
    const std::vector<State>& along_;
    FactSet wanted_;
    FactLists& facts_;
};

Analysis::Analysis(const Program& program, const flow::Graph& graph, EntryKnowledge knowledge,
                   Callees callees, FactSet wanted)
    : program_(&program)
    , graph_(&graph)
    , knowledge_(std::move(knowledge))
    , callees_(std::move(callees))
    , states_(std::make_unique<States>(program, knowledge_))
    , known_starts_(std::make_unique<KnownStarts>()) {
    auto& lists = platform::KeptByThread<WorkingLists>::get();
    try {
        AnalysisBuilder(program, graph, callees_, wanted, lists, *this).run();
    } catch (...) { // no memory: what stands there is of this program, and none of the next one's
        lists = {};
        throw;
    }
    lists.release();
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
bool Analysis::is_set_by_no_caller(Variable variable) const { return states_->is_set_by_no_caller(variable); }

} // namespace maclint::dataflow
