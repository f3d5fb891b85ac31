//! Data flow over one program: its states, and what they say of it.
#pragma once

#include "analyzer/dataflow/domain/state.hpp"
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/facts.hpp"
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/dataflow/solver/summary.hpp"
#include "analyzer/flow/graph.hpp"

#include <memory>

namespace maclint::dataflow {

struct KnownStart;
class KnownStarts;

class Analysis {
  public:
    /// Solves at once. The references, and those that `callees` holds, must outlive the analysis. Facts of
    /// the types that are `wanted` can be asked for afterwards.
    Analysis(const Program& program, const flow::Graph& graph, EntryKnowledge knowledge, Callees callees,
             FactSet wanted);
    Analysis(Analysis&&) noexcept;
    Analysis& operator=(Analysis&&) noexcept;
    ~Analysis();

    [[nodiscard]] const Facts& facts() const { return facts_; }
    [[nodiscard]] const Summary& summary() const { return summary_; }
    /// What the call runs.
    [[nodiscard]] Callee callee(EffectId call) const { return callees_(call); }
    [[nodiscard]] Entry entry() const;
    /// Whether any path leads to the node.
    [[nodiscard]] bool reached(flow::NodeId node) const { return reached_[node]; }
    /// Whether the edge can be taken.
    [[nodiscard]] bool passable(flow::EdgeId edge) const { return passable_[edge]; }
    /// What the program's start and its calls are known to bring.
    [[nodiscard]] const EntryKnowledge& knowledge() const { return knowledge_; }
    [[nodiscard]] const Callees& callees() const { return callees_; }

    /// Whether some path leads back to the caller when the program is begun with this. May be asked on
    /// several threads.
    [[nodiscard]] bool comes_back(const KnownStart& start) const;
    /// The program, begun with this.
    [[nodiscard]] Analysis begun_with(const KnownStart& start, FactSet wanted) const;

    [[nodiscard]] const ValueTable& table() const;
    [[nodiscard]] const Origin& origin(OriginId id) const { return table().origins[id]; }
    /// What a group can be in a state of facts(), in the channels that run the node; unknown where it is not
    /// known whether they do.
    [[nodiscard]] ModalValue modal(const State& state, flow::NodeId node, GroupId group) const;
    [[nodiscard]] ModalValue modal(const PointState& point, GroupId group) const {
        return modal(point.state, point.node, group);
    }
    [[nodiscard]] ModalValue modal(const ExitState& left_with, GroupId group) const {
        return modal(left_with.state, left_with.exit.node, group);
    }
    /// Whether nothing can have set the variable when the program begins.
    [[nodiscard]] bool is_vacant_at_entry(Variable variable) const;
    /// The program shares its callers' local variables, and no known caller sets this one.
    [[nodiscard]] bool is_set_by_no_caller(Variable variable) const;

  private:
    friend class AnalysisBuilder;
    [[nodiscard]] bool finds_way_back(const KnownStart& start) const;

    const Program* program_;
    const flow::Graph* graph_;
    EntryKnowledge knowledge_;
    Callees callees_;
    std::unique_ptr<States> states_;
    std::vector<bool> reached_;
    std::vector<bool> passable_;
    Facts facts_;
    Summary summary_;
    std::unique_ptr<KnownStarts> known_starts_; ///< that were asked about
};

} // namespace maclint::dataflow
