//! The states of a program are solved, then one pass writes the facts down.
#include "analyzer/dataflow/solver/analysis.hpp"

#include "analyzer/dataflow/facts/fact_lists.hpp"
#include "analyzer/dataflow/solver/state_domain.hpp"
#include "analyzer/dataflow/solver/summarise.hpp"
#include "analyzer/dataflow/solver/transfer.hpp"
#include "analyzer/flow/solve.hpp"
#include "analyzer/source/platform/kept_by_thread.hpp"

#include <algorithm>
#include <utility>

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
        StateDomain domain(program, states_, transfer_);
        flow::solve<flow::Direction::forward>(graph, domain, lists.solution);
    }

    void run() {
        result_.reached_.assign(graph_.nodes.size(), false);
        result_.passable_.assign(graph_.edges.size(), false);
        record();
        result_.summary_ =
            summarise(*result_.program_, graph_, result_.callees_, states_, facts_, result_.reached_);
        keep_what_is_wanted();
    }

  private:
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
            if (leaves[node] && state.reached) left.emplace_back(node, state);
        }
        transfer_.record_in(nullptr);
        for (flow::EdgeId edge = 0; edge < graph_.edges.size(); ++edge)
            result_.passable_[edge] = along_[edge].reached;
        for (const flow::Exit& exit : graph_.exits) {
            const auto after =
                std::ranges::lower_bound(left, exit.node, {}, &decltype(left)::value_type::first);
            if (after == left.end() || after->first != exit.node) continue;
            facts_.add(ExitState{exit, after->second});
        }
    }

    void keep_what_is_wanted() {
        std::vector<State*> asked;
        for (PointState& point : facts_.of<BeforeToolChange>()) asked.push_back(&point.state);
        for (PointState& point : facts_.of<BeforeWatchedWord>()) asked.push_back(&point.state);
        if (wanted_.has<ExitState>())
            for (ExitState& exit : facts_.of<ExitState>()) asked.push_back(&exit.state);
        states_.keep_only(asked);
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
    AnalysisBuilder(program, graph, callees_, wanted, lists, *this).run();
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
