//! Goes back from the alarms to the conditions in front of them, and from there to what these read.
#include "analyzer/dataflow/solver/stop_reasons.hpp"

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/flow/walk.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace maclint::dataflow {
namespace {

class StopReasonSearch {
  public:
    StopReasonSearch(const Program& program, const flow::Graph& graph, const FactLists& facts,
                     const std::vector<bool>& reached)
        : program_(program)
        , graph_(graph)
        , facts_(facts)
        , reached_(reached)
        , leads_(graph.nodes.size(), false) {}

    StopReasons run() {
        collect_alarms();
        if (reasons_.anything) return reasons_;
        go_back();
        for (flow::NodeId node = 0; node < graph_.nodes.size(); ++node)
            if (leads_[node] && !reasons_.anything) add_decisions(node);
        // The list grows: what a variable is made of decides, too.
        for (std::size_t i = 0; i < reasons_.variables.size() && !reasons_.anything; ++i)
            add_what_sets(reasons_.variables[i]);
        return reasons_;
    }

  private:
    /// A pause waits for the operator, who may end the program; so may a program that is called.
    void collect_alarms() {
        reasons_.anything = std::ranges::any_of(facts_.of<CallMade>(), &CallMade::may_stop);
        for (flow::NodeId node = 0; node < graph_.nodes.size(); ++node) {
            if (!reached_[node]) continue;
            for (const Effect& effect : program_.effects_in(graph_.nodes[node].effects)) {
                const auto* stop = std::get_if<Stop>(&effect.what);
                if (stop != nullptr && stop->kind == Stop::Kind::alarm) pending_.push_back(node);
                reasons_.anything |= (stop != nullptr && stop->kind != Stop::Kind::alarm) ||
                                     std::holds_alternative<UnreadableBlock>(effect.what);
            }
        }
    }

    void go_back() {
        for (const flow::NodeId alarm : pending_) leads_[alarm] = true;
        flow::walk<flow::Direction::backward>(graph_, std::move(pending_),
                                              [&](flow::EdgeId, flow::NodeId from) {
                                                  if (!reached_[from]) return flow::Step::refuse;
                                                  leads_[from] = true;
                                                  return flow::Step::go_on;
                                              });
    }

    void add_decisions(flow::NodeId node) {
        for (const flow::EdgeId id : graph_.out[node]) {
            const flow::Edge& edge = graph_.edges[id];
            reasons_.anything |= edge.kind != flow::EdgeKind::pass && operator_decides(node, edge);
            if (edge.condition) add_reads(*edge.condition);
            if (!edge.jump) continue;
            const auto* jump = std::get_if<Jump>(&program_.effects[*edge.jump].what);
            if (jump != nullptr)
                add_reads(jump->target);
            else
                reasons_.anything = true; // the called program decides where it comes back
        }
    }

    /// Whether other ways lead from the node under the same condition, past a block that may be skipped, and
    /// it makes a difference to the alarms which is taken: the switch may be on in one round and off in the
    /// next.
    [[nodiscard]] bool operator_decides(flow::NodeId node, const flow::Edge& way) const {
        if (way.jump) return false;
        // The node is shared by jumps, or by returns, which may go anywhere from there.
        if (way.kind == flow::EdgeKind::computed || way.kind == flow::EdgeKind::resume) return true;
        std::vector<flow::NodeId> targets;
        for (const flow::EdgeId id : graph_.out[node]) {
            const flow::Edge& edge = graph_.edges[id];
            if (edge.kind != flow::EdgeKind::pass && !edge.jump && edge.condition == way.condition &&
                edge.holds == way.holds)
                targets.push_back(edge.to);
        }
        const auto is_only_move = [&](flow::NodeId target) {
            return !graph_.out[target].empty() && !stores(target) &&
                   std::ranges::all_of(graph_.out[target], [&](flow::EdgeId id) {
                       return std::ranges::find(targets, graph_.edges[id].to) != targets.end();
                   });
        };
        return std::ranges::any_of(targets, [this](flow::NodeId target) { return leads_[target]; }) &&
               std::ranges::count_if(targets, std::not_fn(is_only_move)) > 1;
    }

    [[nodiscard]] bool stores(flow::NodeId node) const {
        return std::ranges::any_of(program_.effects_in(graph_.nodes[node].effects), [](const Effect& effect) {
            return std::holds_alternative<Assign>(effect.what) || std::holds_alternative<Call>(effect.what) ||
                   std::holds_alternative<Exchange>(effect.what);
        });
    }

    void add_reads(ExpressionId expression) {
        const ReadSet reads = variables_of(program_, expression);
        reasons_.anything |= !reads.closed;
        for (const Variable variable : reads.variables)
            if (std::ranges::find(reasons_.variables, variable) == reasons_.variables.end())
                reasons_.variables.push_back(variable);
    }

    void add_what_sets(Variable variable) {
        for (const Store& store : facts_.of<Store>())
            if (store.variable == variable) add_reads(store.expression);
        reasons_.anything |= std::ranges::any_of(
            facts_.of<Clobber>(), [&](const Clobber& clobber) { return clobber.may_change(variable); });
    }

    const Program& program_;
    const flow::Graph& graph_;
    const FactLists& facts_;
    const std::vector<bool>& reached_;
    std::vector<bool> leads_; ///< of each node: to an alarm, or it is one
    std::vector<flow::NodeId> pending_;
    StopReasons reasons_{.anything = false, .variables = {}};
};

} // namespace

StopReasons find_stop_reasons(const Program& program, const flow::Graph& graph, const FactLists& facts,
                              const std::vector<bool>& reached) {
    return StopReasonSearch(program, graph, facts, reached).run();
}

} // namespace maclint::dataflow
