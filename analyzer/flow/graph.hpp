//! The control-flow graph of one program, with the jump rules of the control.
#pragma once

#include "analyzer/flow/regions.hpp"
#include "analyzer/program/model.hpp"

#include <functional>
#include <memory>
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
    bool is_run;   ///< plain blocks, see Stretch

    [[nodiscard]] Stretch stretch() const { return {item, part}; }
};

enum class EdgeKind : std::uint8_t {
    next,     ///< the following block
    branch,   ///< decided by `condition`
    jump,     ///< GOTO
    computed, ///< GOTO to one of several labels
    back,     ///< from the end of a loop to its condition
    skip,     ///< optional block skip
    resume,   ///< a called program returns to a label of its caller (M99 P)
    pass,     ///< the channels that do not run the block go on after it
};

struct Edge {
    NodeId from, to;
    EdgeKind kind;
    std::optional<ExpressionId> condition; ///< must be `holds` for this edge to be taken
    bool holds;
    std::optional<EffectId> jump; ///< the jump or call that makes the edge
    /// Computed: the place in Graph::labels of the label that the target must be; nothing: of any.
    std::optional<std::uint32_t> label;
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

/// Which channels come to a node, in a program that runs in several.
struct NodeChannels {
    Channels running;   ///< those that run its effects
    Channels uncertain; ///< of these, those of which no manual says whether they come here: the node stands
                        ///< in a loop or choice that other channels decide
};

/// A block that a jump can name. A block with a number and a name is there twice.
struct LabelledBlock {
    Label label;
    NodeId node;
    Span span; ///< of the label
    Span block;
};

/// A jump and where it goes.
struct ResolvedJump {
    EffectId jump;
    NodeId node;
    std::optional<Label> label;          ///< empty: computed
    std::optional<LabelledBlock> target; ///< empty: no block bears the label, or computed
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
    std::vector<Node> nodes;  ///< in text order; node 0 is the entry; at least one
    NodeId nodes_in_text = 0; ///< those after so many are for edges to meet in, and hold no block
    std::vector<Edge> edges;
    EdgesByNode out, in;
    std::vector<Exit> exits;           ///< sorted by node
    std::vector<LabelledBlock> labels; ///< those that something may name, by label, then in text order
    std::vector<ResolvedJump> jumps;   ///< in text order
    std::vector<std::uint32_t>
        order; ///< place of a node in reverse postorder from the entry; unreached: no_order
    static constexpr std::uint32_t no_order = 0xFFFFFFFF;
    /// Nodes with a call that may end in an alarm, but that was not made for it: every path through the
    /// program comes by, or work stands behind it that only the call leads to. Sorted.
    std::vector<NodeId> returns_expected;
    std::vector<NodeId> with_effects;   ///< nodes that have effects, in the order of these
    std::vector<NodeChannels> channels; ///< of every node; empty for a program of one channel
    Channels all_channels = 1;          ///< of the program; bit 0 where it names none

    [[nodiscard]] NodeChannels channels_at(NodeId node) const {
        return channels.empty() ? NodeChannels{all_channels, 0} : channels[node];
    }
    /// The first of the nodes that a block, or a plain stretch with it, is; nothing in parts that are never
    /// executed.
    [[nodiscard]] std::optional<NodeId> node_of(Span block) const;
    /// The block at which the control's search for the label stops that begins in the block at `from`.
    [[nodiscard]] const LabelledBlock* find_label(const Label& label, Offset from, LabelSearch search) const;
    /// Whether each of the labels (sorted, each once) is that of a block.
    [[nodiscard]] bool has_all(std::span<const Label> sought) const;
    /// Whether any block bears the label.
    [[nodiscard]] bool has_label(const Label& label) const;
    /// All blocks that bear the label, in text order.
    [[nodiscard]] std::span<const LabelledBlock> with_label(const Label& label) const;
    /// The node in which the effect runs; nothing in parts that are never executed.
    [[nodiscard]] std::optional<NodeId> node_of(EffectId effect) const;
    /// Whether the node is one of `returns_expected`.
    [[nodiscard]] bool expects_return(NodeId node) const;
    /// Those where the program may be left after the node.
    [[nodiscard]] std::span<const Exit> exits_at(NodeId node) const;
    /// Edges on a shortest path from `from` to `to`, or nothing when there is none or the search has met
    /// `most_nodes` nodes. An edge that `usable` refuses is not taken.
    [[nodiscard]] std::optional<std::vector<EdgeId>>
    path(NodeId from, NodeId to, const std::function<bool(EdgeId)>& usable, std::size_t most_nodes) const;
};

/// Sorted, each once.
using LabelList = std::vector<Label>;

/// What a call of a program that may end in an alarm is for.
enum class AlarmCall : std::uint8_t {
    none,    ///< the program ends in none, or comes back as well
    perhaps, ///< the program ends in one for some of what it may be given
    always,  ///< the program always does: a call that was not made for it is taken for one that comes back
};

/// How a called program may come back.
struct ReturnTargets {
    bool to_next_block = true;
    /// Of the caller; nullptr: none. One list serves all calls of a program.
    std::shared_ptr<const LabelList> labels = nullptr;
    AlarmCall alarm = AlarmCall::none;
};
using Returns = std::function<ReturnTargets(EffectId call)>;

/// Whether who leaves the program there goes on after the call, not at a label.
[[nodiscard]] bool returns_after_call(const Program& program, const Exit& exit);

[[nodiscard]] Graph build_graph(const Program& program, const Regions& regions, const Returns& returns);

/// Whether the called program runs at least once: a count may be 0, or vacant.
[[nodiscard]] bool surely_runs(const Program& program, const Call& call);

/// The number that an expression is when it is a plain constant.
[[nodiscard]] std::optional<std::int64_t> constant_number(const Program& program, ExpressionId expression);
/// The label that a jump's target expression names when it is a plain constant.
[[nodiscard]] std::optional<Label> constant_target(const Program& program, ExpressionId target);

} // namespace maclint::flow
