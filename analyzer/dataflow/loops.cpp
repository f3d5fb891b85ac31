//! Natural loops of the reached part of the flow graph.
#include "analyzer/dataflow/loops.hpp"

#include "analyzer/program/overloaded.hpp"

#include <algorithm>
#include <tuple>
#include <unordered_map>

namespace maclint::dataflow {
namespace {

/// Nodes looked at for all loops of a program together, per node of the program; keeps the search linear.
constexpr std::size_t work_per_node = 16;
constexpr std::size_t work_at_least = 20'000;

class LoopSearch {
  public:
    LoopSearch(const Program& program, const flow::Structures& structures, const flow::Graph& graph,
               const Analysis& analysis)
        : program_(program)
        , graph_(graph)
        , analysis_(analysis)
        , budget_(std::max(work_at_least, work_per_node * graph.nodes.size()))
        , mark_(graph.nodes.size(), 0) {
        for (flow::StructureId id = 0; id < structures.all.size(); ++id)
            by_open_.emplace(structures.all[id].open, id);
        for (const flow::Exit& exit : graph.exits) exits_.push_back(exit.node);
        std::ranges::sort(exits_);
    }

    std::vector<Loop> run() {
        std::vector<Loop> loops;
        for (flow::EdgeId edge = 0; edge < graph_.edges.size(); ++edge) {
            if (!is_back(edge)) continue;
            Loop loop = loop_of(edge);
            if (budget_ == 0) break; // its body is not complete
            loop.changes = LoopChanges(loop, analysis_.facts());
            loop.counter = counter_of(program_, graph_, analysis_.facts(), loop);
            loops.push_back(std::move(loop));
        }
        std::ranges::sort(loops, {}, [this](const Loop& loop) {
            return std::tuple(graph_.nodes[loop.head].part.begin, loop.head,
                              graph_.nodes[loop.latch].part.begin, loop.back);
        });
        return loops;
    }

  private:
    [[nodiscard]] bool is_back(flow::EdgeId id) const {
        const flow::Edge& edge = graph_.edges[id];
        return analysis_.passable(id) && graph_.order[edge.to] <= graph_.order[edge.from];
    }

    Loop loop_of(flow::EdgeId back) {
        const flow::Edge& edge = graph_.edges[back];
        Loop loop;
        loop.head = edge.to;
        loop.latch = edge.from;
        loop.back = back;
        collect_body(loop);
        for (const flow::NodeId node : loop.body) {
            for (const flow::EdgeId out : graph_.out[node])
                if (mark_[graph_.edges[out].to] != round_) loop.ways_out.push_back(out);
            loop.can_stop |= std::ranges::binary_search(exits_, node);
            look_at_effects(loop, node);
        }
        for_each_in_body(loop, analysis_.facts().calls, [&](const CallMade& call) {
            loop.can_stop |= call.may_stop;
            loop.has_unknown_effects |= !call.known;
        });
        if (edge.kind == flow::EdgeKind::back) {
            const Slice effects = graph_.nodes[loop.head].effects;
            for (Id i = effects.first; i < effects.first + effects.count; ++i)
                if (const auto found = by_open_.find(i); found != by_open_.end())
                    loop.structure = found->second;
        }
        return loop;
    }

    /// Everything from which the latch is reached without passing the head.
    void collect_body(Loop& loop) {
        ++round_;
        mark_[loop.head] = round_;
        loop.body.push_back(loop.head);
        stack_.clear();
        const auto add = [&](flow::NodeId node) {
            if (mark_[node] == round_) return;
            mark_[node] = round_;
            loop.body.push_back(node);
            stack_.push_back(node);
        };
        add(loop.latch);
        while (!stack_.empty() && budget_ != 0) {
            const flow::NodeId node = stack_.back();
            stack_.pop_back();
            --budget_;
            for (const flow::EdgeId in : graph_.in[node])
                if (analysis_.passable(in)) add(graph_.edges[in].from);
        }
        put_in_order(loop.body);
    }

    /// Sorts the nodes that are marked. Bodies lie close together: mostly it is enough to look along the
    /// marks.
    void put_in_order(std::vector<flow::NodeId>& body) const {
        const auto [first, last] = std::ranges::minmax(body);
        constexpr std::size_t worth_it = 8;
        if (last - first > worth_it * body.size()) {
            std::ranges::sort(body);
            return;
        }
        body.clear();
        for (flow::NodeId node = first; node <= last; ++node)
            if (mark_[node] == round_) body.push_back(node);
    }

    void look_at_effects(Loop& loop, flow::NodeId node) const {
        for (const Effect& effect : program_.effects_in(graph_.nodes[node].effects)) {
            std::visit(overloaded{
                           [&](const Stop&) { loop.can_stop = true; },
                           [&](const UnreadableBlock&) { loop.has_unknown_effects = true; },
                           [](const auto&) {},
                       },
                       effect.what);
        }
    }

    const Program& program_;
    const flow::Graph& graph_;
    const Analysis& analysis_;
    std::size_t budget_;
    std::vector<std::uint32_t> mark_;
    std::vector<flow::NodeId> stack_;
    std::uint32_t round_ = 0;
    std::unordered_map<EffectId, flow::StructureId> by_open_;
    std::vector<flow::NodeId> exits_;
};

} // namespace

bool Loop::holds(flow::NodeId node) const { return std::ranges::binary_search(body, node); }

std::vector<Loop> find_loops(const Program& program, const flow::Structures& structures,
                             const flow::Graph& graph, const Analysis& analysis) {
    return LoopSearch(program, structures, graph, analysis).run();
}

} // namespace maclint::dataflow
