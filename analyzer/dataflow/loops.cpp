//! Natural loops of the reached part of the flow graph.
#include "analyzer/dataflow/loops.hpp"

#include "analyzer/dataflow/facts/call_made.hpp"
#include "analyzer/dataflow/loop_stops.hpp"

#include <algorithm>
#include <tuple>

namespace maclint::dataflow {
namespace {

/// Nodes looked at for all loops of a program together, per node of the program; keeps the search linear.
constexpr std::size_t work_per_node = 16;
constexpr std::size_t work_at_least = 20'000;

class LoopSearch {
  public:
    LoopSearch(const Program& program, const flow::Regions& regions, const flow::Graph& graph,
               const Analysis& analysis, const Cycles& cycles)
        : program_(program)
        , regions_(regions)
        , graph_(graph)
        , analysis_(analysis)
        , component_(cycles.components.of)
        , budget_(std::max(work_at_least, work_per_node * graph.nodes.size()))
        , traits_(graph.nodes.size(), 0)
        , mark_(graph.nodes.size(), 0) {
        for (const flow::Exit& exit : graph.exits) mark(exit.node, true, false);
        for (const CallMade& call : analysis.facts().all<CallMade>())
            mark(call.node, call.may_stop && !call.known, !call.known);
        target_.reserve(graph.edges.size());
        for (const flow::Edge& edge : graph.edges) target_.push_back(edge.to);
        sources_.reserve(graph.nodes.size(), graph.edges.size());
        for (flow::NodeId node = 0; node < graph.nodes.size(); ++node) {
            look_at_effects(node);
            for (const flow::EdgeId in : graph.in[node])
                if (analysis.passable(in) && in_one_cycle(graph.edges[in].from, node))
                    sources_.add(graph.edges[in].from);
            sources_.end_list();
        }
    }

    std::vector<Loop> run() {
        std::vector<Loop> loops;
        for (flow::EdgeId edge = 0; edge < graph_.edges.size(); ++edge) {
            if (!leads_back(graph_, analysis_, edge)) continue;
            Loop loop = loop_of(edge);
            if (budget_ == 0) break; // its body is not complete
            loop.changes = LoopChanges(loop, analysis_.facts());
            LoopStops stops(program_, graph_, analysis_, loop);
            for_each_in_body(loop, analysis_.facts().all<CallMade>(), [&](const CallMade& call) {
                loop.can_stop = loop.can_stop || stops.may_stop_later(call);
            });
            loops.push_back(std::move(loop));
        }
        std::ranges::sort(loops, {}, [this](const Loop& loop) {
            return std::tuple(graph_.nodes[loop.head].part.begin, loop.head,
                              graph_.nodes[loop.latch].part.begin, loop.back);
        });
        return loops;
    }

  private:
    /// What a node does to the loops that it is in: bits.
    enum Trait : std::uint8_t { may_stop = 1, has_unknown_effects = 2 };

    void look_at_effects(flow::NodeId node) {
        for (const Effect& effect : program_.effects_in(graph_.nodes[node].effects))
            mark(node, std::holds_alternative<Stop>(effect.what),
                 std::holds_alternative<UnreadableBlock>(effect.what));
    }

    void mark(flow::NodeId node, bool stops, bool unknown) {
        unsigned traits = traits_[node];
        if (stops) traits |= may_stop;
        if (unknown) traits |= has_unknown_effects;
        traits_[node] = static_cast<std::uint8_t>(traits);
    }

    [[nodiscard]] bool in_one_cycle(flow::NodeId a, flow::NodeId b) const {
        return component_[a] == component_[b];
    }

    Loop loop_of(flow::EdgeId back) {
        const flow::Edge& edge = graph_.edges[back];
        Loop loop;
        loop.head = edge.to;
        loop.latch = edge.from;
        loop.back = back;
        collect_body(loop);
        unsigned traits = 0;
        for (const flow::NodeId node : loop.body) {
            for (const flow::EdgeId out : graph_.out[node])
                if (mark_[target_[out]] != round_) loop.exit_edges.push_back(out);
            traits |= traits_[node];
        }
        // Where many computed jumps share a node all its edges leave each of their loops.
        budget_ -= std::min(budget_, loop.exit_edges.size());
        loop.can_stop = (traits & may_stop) != 0;
        loop.has_unknown_effects = (traits & has_unknown_effects) != 0;
        if (edge.kind == flow::EdgeKind::back) {
            const Slice effects = graph_.nodes[loop.head].effects;
            for (Id i = effects.first; i < effects.first + effects.count; ++i)
                if (const auto id = regions_.with(i); id && regions_.all[*id].open == i) loop.region = id;
        }
        return loop;
    }

    /// Everything from which the latch is reached without passing the head, and which the head reaches: a
    /// path into the middle of a loop does not belong to it.
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
            for (const flow::NodeId source : sources_[node]) add(source);
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

    const Program& program_;
    const flow::Regions& regions_;
    const flow::Graph& graph_;
    const Analysis& analysis_;
    const std::vector<std::uint32_t>& component_; ///< of every node
    std::size_t budget_;
    // What the search looks at again and again lies close together.
    std::vector<std::uint8_t> traits_; ///< of every node
    std::vector<flow::NodeId> target_; ///< of every edge
    flow::SliceTable sources_;         ///< for each node those of its cycle that lead to it
    std::vector<std::uint32_t> mark_;
    std::vector<flow::NodeId> stack_;
    std::uint32_t round_ = 0;
};

} // namespace

bool Loop::holds(flow::NodeId node) const { return std::ranges::binary_search(body, node); }

std::vector<Loop> find_loops(const Program& program, const flow::Regions& regions, const flow::Graph& graph,
                             const Analysis& analysis, const Cycles& cycles) {
    return LoopSearch(program, regions, graph, analysis, cycles).run();
}

} // namespace maclint::dataflow
