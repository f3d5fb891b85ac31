//! The control-flow graph of one program, with the jump rules of the control.
#pragma once

#include "analyzer/flow/regions.hpp"
#include "analyzer/program/model.hpp"

#include <functional>
#include <span>
#include <vector>

namespace maclint::flow {

using NodeId = std::uint32_t;
using EdgeId = std::uint32_t;

/// Effects that run one after the other; a plain run (or a part of one) is one node.
struct Node {
    ItemId item;
    Span part;     ///< of the file: the block, or the part of the run
    Slice effects; ///< Program::effects; empty for runs
    bool is_run;
};

enum class EdgeKind : std::uint8_t {
    next,     ///< the following block
    branch,   ///< decided by `condition`
    jump,     ///< GOTO
    computed, ///< GOTO to one of several sequence numbers
    back,     ///< from the end of a loop to its condition
    skip,     ///< optional block skip
    resume,   ///< a called program returns to a sequence number (M99 P)
};

struct Edge {
    NodeId from, to;
    EdgeKind kind;
    std::optional<ExpressionId> condition; ///< must be `holds` for this edge to be taken
    bool holds;
    std::optional<EffectId> jump;      ///< the jump or call that makes the edge
    std::optional<std::int64_t> label; ///< computed: the value that the target must have
};

enum class ExitKind : std::uint8_t {
    returns,  ///< M99
    ends,     ///< M30
    restarts, ///< it begins again, every modal group as it is
    alarm,    ///< #3000
    runs_off, ///< past the last block
};

struct Exit {
    NodeId node;
    ExitKind kind;
    std::optional<EffectId> effect; ///< the return or stop; empty for runs_off
};

/// A block that a jump can name.
struct Label {
    std::int64_t number;
    NodeId node;
    Span span; ///< of the sequence number
    Span block;
};

/// A jump and where it goes.
struct ResolvedJump {
    EffectId jump;
    NodeId node;
    std::optional<std::int64_t> number; ///< empty: computed
    std::optional<Label> target;        ///< empty: no such sequence number, or computed
};

/// The edges at each node, in the order of their ids: all in one list, with the place where each node's
/// begin.
class EdgesByNode {
  public:
    EdgesByNode() = default;
    /// Sorts `edges` by the node that `node_of` takes from an edge.
    EdgesByNode(std::size_t nodes, std::span<const Edge> edges, NodeId Edge::*node_of);

    [[nodiscard]] std::span<const EdgeId> operator[](NodeId node) const {
        return std::span(ids_).subspan(begin_[node], begin_[node + 1] - begin_[node]);
    }

  private:
    std::vector<EdgeId> ids_;
    std::vector<EdgeId> begin_; ///< one more than there are nodes
};

struct Graph {
    std::vector<Node> nodes; ///< in text order; node 0 is the entry; at least one
    std::vector<Edge> edges;
    EdgesByNode out, in;
    std::vector<Exit> exits;
    std::vector<Label> labels;       ///< those that something may name, by number, then in text order
    std::vector<ResolvedJump> jumps; ///< in text order
    std::vector<std::uint32_t>
        order; ///< place of a node in reverse postorder from the entry; unreached: no_order
    static constexpr std::uint32_t no_order = 0xFFFFFFFF;
    std::vector<NodeId> with_effects; ///< nodes that have effects, in the order of these

    /// The first label `number` from `from` on, else from the top: where the control's search stops.
    [[nodiscard]] const Label* find_label(std::int64_t number, Offset from) const;
    /// The node in which the effect runs; nothing in parts that are never executed.
    [[nodiscard]] std::optional<NodeId> node_of(EffectId effect) const;
    /// Edges on a shortest way from `from` to `to`, or nothing when there is none or the search has met
    /// `most_nodes` nodes. An edge that `usable` refuses is not taken.
    [[nodiscard]] std::optional<std::vector<EdgeId>>
    path(NodeId from, NodeId to, const std::function<bool(EdgeId)>& usable, std::size_t most_nodes) const;
};

/// How a called program may come back.
struct ReturnTargets {
    bool to_next_block = true;
    std::vector<std::int64_t> labels; ///< sequence numbers of the caller
};
using Returns = std::function<ReturnTargets(EffectId call)>;

/// Whether who leaves the program there goes on behind the call, not at a sequence number.
[[nodiscard]] bool returns_behind_call(const Program& program, const Exit& exit);

[[nodiscard]] Graph build_graph(const Program& program, const Regions& regions, const Returns& returns);

/// Whether the called program runs at least once: a count may be 0, or vacant.
[[nodiscard]] bool surely_runs(const Program& program, const Call& call);

/// The number that a jump's target expression names when it is a plain constant.
[[nodiscard]] std::optional<std::int64_t> constant_target(const Program& program, ExpressionId target);

} // namespace maclint::flow
