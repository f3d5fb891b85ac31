//! Builds the control-flow graph: nodes in text order, then the edges of jumps, loops and returns.
#include "analyzer/flow/graph.hpp"

#include "analyzer/flow/unavoidable_nodes.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/overloaded.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace maclint::flow {
namespace {

/// So many lists of labels are looked into for each block; of others each label is wanted by itself.
constexpr std::size_t most_lists = 8;
/// Beyond so many edges the computed jumps of a program share one node from which all labels are reached.
constexpr std::size_t most_computed_edges = 20'000;

/// Beyond so many loose ends a block that may be skipped, which passes them all on, gets them as one.
constexpr std::size_t most_passed_on = 4;

/// Whether a search that begins in the block at `from` looks at the block at `block`.
bool looks_at(LabelSearch search, Offset from, Offset block) {
    if (search == LabelSearch::forward) return block > from;
    if (search == LabelSearch::backward) return block <= from;
    return true;
}

/// How the label begins that a jump joins of texts: ROW_ of `"ROW_"<<R1`; empty: nothing is known of it.
std::string_view beginning_of_label(const Program& program, ExpressionId target) {
    const auto* joined = std::get_if<Apply>(&program.expressions[target].node);
    while (joined != nullptr && joined->operation == Operation::unknown && joined->operands.count != 0) {
        const auto& first = program.expressions[program.operands_of(*joined).front()].node;
        if (const auto* text = std::get_if<Text>(&first)) return program.slice(text->characters);
        joined = std::get_if<Apply>(&first);
    }
    return {};
}

bool begins_with(std::string_view label, std::string_view beginning) {
    const auto in_capital = [](char c) {
        return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    };
    return label.size() >= beginning.size() &&
           std::ranges::equal(label.substr(0, beginning.size()), beginning, {}, in_capital, in_capital);
}

/// What something in the program may jump to.
struct Wanted {
    std::vector<std::int64_t> numbers; ///< sorted once all are there: files have a million numbered blocks
    std::vector<BlockName> names;      ///< sorted, too
    std::vector<std::span<const Label>> lists; ///< likewise; longer than the program
    bool any = false;                          ///< a computed jump: every label

    void add(const Label& label) {
        std::visit(overloaded{[this](std::int64_t number) { numbers.push_back(number); },
                              [this](BlockName name) { names.push_back(name); }},
                   label);
    }
    void sort() {
        std::ranges::sort(numbers);
        std::ranges::sort(names);
    }
    [[nodiscard]] bool operator()(std::int64_t number) const {
        return any || std::ranges::binary_search(numbers, number) || is_listed(number);
    }
    [[nodiscard]] bool between(std::int64_t lowest, std::int64_t highest) const {
        const auto from = std::ranges::lower_bound(numbers, lowest);
        return any || (from != numbers.end() && *from <= highest) ||
               std::ranges::any_of(lists, [&](std::span<const Label> list) {
                   const auto listed = std::ranges::lower_bound(list, Label{lowest});
                   return listed != list.end() && *listed <= Label{highest};
               });
    }
    [[nodiscard]] bool operator()(BlockName name) const {
        return any || std::ranges::binary_search(names, name) || is_listed(name);
    }

  private:
    [[nodiscard]] bool is_listed(const Label& label) const {
        return std::ranges::any_of(
            lists, [&](std::span<const Label> list) { return std::ranges::binary_search(list, label); });
    }
};

/// An edge whose end is the next node to be made.
struct Loose {
    NodeId from;
    EdgeKind kind;
    std::optional<ExpressionId> condition;
    bool holds;
};

class Building {
  public:
    Building(const Program& program, const Regions& regions, const Returns& returns)
        : program_(program)
        , regions_(regions)
        , returns_(returns) {
        collect_wanted();
        if (program.channels != 0) graph_.all_channels = program.channels;
    }

    Graph run() {
        // What most programs need; what is left over is given back.
        graph_.nodes.reserve(2 * program_.items.size());
        graph_.edges.reserve(2 * program_.items.size());
        for (const Section& section : program_.sections) {
            if (section.executed == Section::Executed::never) continue;
            for_each_stretch(program_, section, wanted_,
                             [this](const StretchView& stretch) { take_stretch(stretch); });
        }
        if (graph_.nodes.empty()) new_node(0, program_.span, {}, false);
        // A loop at the very end is left for nothing: only a node there tells its exit from its body.
        const bool branches =
            std::ranges::any_of(loose_, [](const Loose& l) { return l.condition.has_value(); });
        if (branches) new_node(graph_.nodes.back().item, {program_.span.end, program_.span.end}, {}, false);
        for (const Loose& loose : loose_) graph_.exits.push_back({loose.from, ExitKind::runs_off, {}});
        graph_.nodes_in_text = static_cast<NodeId>(graph_.nodes.size());
        resolve_jumps();
        resolve_returns();
        std::ranges::stable_sort(graph_.exits, {}, &Exit::node); // who runs off the end came last
        graph_.nodes.shrink_to_fit();
        graph_.edges.shrink_to_fit();
        index_effects();
        if (program_.has_several_channels()) find_channels();
        index_edges();
        number_nodes();
        return std::move(graph_);
    }

  private:
    // ---- what is jumped to ----

    void collect_wanted() {
        for_each_effect(program_, [this](EffectId id) {
            std::visit(overloaded{
                           [this](const Jump& jump) { want(constant_target(program_, jump.target)); },
                           [this](const UnreadableBlock& block) {
                               has_unreadable_ = true;
                               for (const Label& label : program_.labels_of(block)) wanted_.add(label);
                           },
                           [this](const Return& back) { // in a program that nobody called, it goes on there
                               if (const auto label = back.resume_label
                                                          ? constant_target(program_, *back.resume_label)
                                                          : std::nullopt)
                                   want(label);
                           },
                           [this, id](const Call& call) { collect_return_targets(id, call); },
                           [](const auto&) {},
                       },
                       program_.effects[id].what);
        });
        wanted_.sort();
    }

    void collect_return_targets(EffectId id, const Call& call) {
        if (program_.control->calls[call.kind].trigger != CallTrigger::once) return;
        ReturnTargets paths = returns_(id);
        if (paths.to_next_block && paths.labels == nullptr && paths.alarm == AlarmCall::none) return;
        paths.to_next_block |= !surely_runs(program_, call);
        if (paths.labels != nullptr && wanted_lists_.insert(paths.labels.get()).second) {
            // Thousands of short programs may call one that names thousands of labels.
            if (paths.labels->size() > program_.effects.size() && wanted_.lists.size() < most_lists)
                wanted_.lists.emplace_back(*paths.labels);
            else
                for (const Label& label : *paths.labels) wanted_.add(label);
        }
        return_targets_.emplace(id, std::move(paths));
    }

    void want(const std::optional<Label>& label) {
        if (label)
            wanted_.add(*label);
        else
            wanted_.any = true;
    }

    // ---- nodes in text order ----

    NodeId new_node(ItemId item, Span part, Slice effects, bool is_run) {
        const auto id = static_cast<NodeId>(graph_.nodes.size());
        graph_.nodes.push_back({item, part, effects, is_run});
        for (const Loose& loose : loose_) tie(loose, id);
        loose_.assign(1, {id, EdgeKind::next, {}, true});
        return id;
    }

    void tie(const Loose& loose, NodeId to) {
        add_edge({loose.from, to, loose.kind, loose.condition, loose.holds, {}, {}});
    }

    void add_edge(const Edge& edge) { graph_.edges.push_back(edge); }

    void take_stretch(const StretchView& view) {
        if (!view.plain) return take_block(view.stretch.item, *view.first);
        if (view.first != nullptr) add_label(*view.first, static_cast<NodeId>(graph_.nodes.size()));
        new_node(view.stretch.item, view.stretch.span, {}, true);
    }

    void add_label(const BlockView& block, NodeId node) {
        graph_.labels.push_back({*block.number, node, block.number_span, block.span});
    }

    void take_block(ItemId item, const BlockView& block) {
        // A program does not begin with a choice: somewhere the path past the block must begin, too. And a
        // jump to the block may find it skipped.
        const bool nowhere_yet = graph_.nodes.empty();
        const auto first = static_cast<NodeId>(graph_.nodes.size());
        const std::size_t labels_before = graph_.labels.size();
        if (block.number && wanted_(*block.number)) add_label(block, first);
        if (block.name && wanted_(*block.name))
            graph_.labels.push_back({*block.name, first, block.name_span, block.span});
        const bool is_target = graph_.labels.size() > labels_before;
        if (block.skip_levels != 0 && (is_target || nowhere_yet || loose_.size() > most_passed_on))
            new_node(item, {block.span.begin, block.span.begin}, {}, false);
        const std::vector<Loose> before = block.skip_levels != 0 ? loose_ : std::vector<Loose>{};
        const std::size_t nodes_before = graph_.nodes.size();
        item_ = item;
        part_ = block.span;
        take_effects(block.effects);
        if (graph_.nodes.size() == nodes_before) new_node(item, block.span, {block.effects.first, 0}, false);
        for (Loose loose : before) {
            if (loose.kind == EdgeKind::next) loose.kind = EdgeKind::skip;
            loose_.push_back(loose);
        }
    }

    /// Cuts a sequence of effects into nodes wherever the flow can leave it.
    void take_effects(Slice slice) {
        Id begin = slice.first;
        const Id end = slice.first + slice.count;
        for (Id i = slice.first; i < end; ++i) {
            const auto& what = program_.effects[i].what;
            if (!leaves_line(what) && !return_targets_.contains(i)) continue;
            // The effect itself ends its node, so that rules find the state in front of it.
            const bool header = std::holds_alternative<RegionMark>(what);
            if (header && i > begin) flush(begin, i);
            std::vector<Loose> falling_in = header ? divert_before_case(i) : std::vector<Loose>{};
            const NodeId node = flush(header ? i : begin, i + 1);
            begin = i + 1;
            leave(node, i);
            if (falling_in.empty()) continue;
            // Of many cases one after the other each falls into the next: they are not copied.
            falling_in.insert(falling_in.end(), loose_.begin(), loose_.end());
            loose_ = std::move(falling_in);
        }
        if (begin < end) flush(begin, end);
    }

    NodeId flush(Id begin, Id end) { return new_node(item_, part_, {begin, end - begin}, false); }

    static bool leaves_line(const decltype(Effect::what)& what) {
        if (const auto* stop = std::get_if<Stop>(&what)) return stop->kind != Stop::Kind::pause;
        return std::holds_alternative<Jump>(what) || std::holds_alternative<Guarded>(what) ||
               std::holds_alternative<RegionMark>(what) || std::holds_alternative<Return>(what);
    }

    void leave(NodeId node, EffectId id) {
        std::visit(overloaded{
                       [&](const Stop& stop) { exit(node, exit_of(stop.kind), id); },
                       [&](const Return&) { exit(node, ExitKind::returns, id); },
                       [&](const Jump& jump) {
                           graph_.jumps.push_back({id, node, constant_target(program_, jump.target), {}});
                           // Where nothing bears the label the program goes on: resolve_jumps knows.
                           if (jump.missing == MissingLabel::alarm) loose_.clear();
                       },
                       [&](const Guarded& guarded) {
                           loose_ = {{node, EdgeKind::branch, guarded.condition, true}};
                           take_effects(guarded.effects);
                           loose_.push_back({node, EdgeKind::branch, guarded.condition, false});
                       },
                       [&](const RegionMark& mark) { leave_region(node, id, mark); },
                       [&](const Call&) { calls_.emplace_back(node, id); },
                       [](const auto&) {},
                   },
                   program_.effects[id].what);
        if (!is_region_mark_or_guard(program_.effects[id].what) && some_channels_pass())
            loose_.push_back({node, EdgeKind::pass, {}, true});
    }

    static bool is_region_mark_or_guard(const decltype(Effect::what)& what) {
        return std::holds_alternative<Guarded>(what) || std::holds_alternative<RegionMark>(what);
    }

    /// Whether the block that is being built is not run by all channels of the program.
    [[nodiscard]] bool some_channels_pass() const {
        return program_.has_several_channels() && program_.channels_of(item_) != program_.channels;
    }

    static ExitKind exit_of(Stop::Kind stop) {
        if (stop == Stop::Kind::alarm) return ExitKind::alarm;
        return stop == Stop::Kind::restart ? ExitKind::restarts : ExitKind::ends;
    }

    void exit(NodeId node, ExitKind kind, EffectId effect) {
        graph_.exits.push_back({node, kind, effect});
        loose_.clear();
    }

    // ---- structures ----

    /// The open structure while its body is being built.
    struct Open {
        NodeId header;
        std::optional<ExpressionId> condition;
        std::vector<Loose> to_close; ///< ends of the branches of a choice
        std::optional<Loose>
            otherwise; ///< the path when the condition does not hold, until a middle or the close takes it
        std::optional<NodeId> fallback; ///< DEFAULT, wherever it stands: all tests come first
    };

    void leave_region(NodeId node, EffectId id, const RegionMark& mark) {
        const auto found = regions_.with(id);
        if (!found) return; // a stray END: the control goes on
        const Region& region = regions_.all[*found];
        switch (mark.part) {
        case RegionMark::Part::open: {
            // Without its END, or crossing another, the loop is read as plain text.
            if (!region.close || region.crossed) return;
            Open open{node, region.condition, {}, {}, {}};
            loose_.clear();
            if (region.condition) {
                loose_.push_back({node, EdgeKind::branch, region.condition, true});
                open.otherwise = Loose{node, EdgeKind::branch, region.condition, false};
            } else if (mark.region_kind == RegionKind::selection) {
                open.otherwise = Loose{node, EdgeKind::next, {}, true};
            } else {
                loose_.push_back({node, EdgeKind::next, {}, true});
            }
            open_.emplace(*found, std::move(open));
            break;
        }
        case RegionMark::Part::begin: break;
        case RegionMark::Part::middle: middle(*found, node, mark); break;
        case RegionMark::Part::leave: leave_selection(*found); break;
        case RegionMark::Part::close: close(*found, node, mark.condition); break;
        }
    }

    void middle(RegionId id, NodeId node, const RegionMark& mark) {
        const auto found = open_.find(id);
        if (found == open_.end()) return;
        Open& open = found->second;
        if (regions_.all[id].region_kind == RegionKind::selection) {
            // The test stands in this node; the next CASE takes over when it fails.
            if (mark.condition) {
                loose_ = {{node, EdgeKind::branch, mark.condition, true}};
                open.otherwise = Loose{node, EdgeKind::branch, mark.condition, false};
            } else {
                open.fallback = node;
            }
            return;
        }
        open.to_close.insert(open.to_close.end(), loose_.begin(), loose_.end());
        loose_.clear();
        if (open.otherwise) loose_.push_back(*std::exchange(open.otherwise, std::nullopt));
    }

    /// A CASE is reached by the tests before it, DEFAULT when the last of them has failed, none by the branch
    /// above; that one falls into what follows the test.
    std::vector<Loose> divert_before_case(EffectId id) {
        const auto& mark = std::get<RegionMark>(program_.effects[id].what);
        const auto found = regions_.with(id);
        if (!found || mark.part != RegionMark::Part::middle) return {};
        const auto open = open_.find(*found);
        if (open == open_.end() || regions_.all[*found].region_kind != RegionKind::selection) return {};
        std::vector<Loose> falling = std::exchange(loose_, {});
        if (mark.condition && open->second.otherwise)
            loose_.push_back(*std::exchange(open->second.otherwise, std::nullopt));
        return falling;
    }

    void leave_selection(RegionId id) {
        const auto found = open_.find(id);
        if (found == open_.end()) return;
        found->second.to_close.insert(found->second.to_close.end(), loose_.begin(), loose_.end());
        loose_.clear();
    }

    void close(RegionId id, NodeId node, std::optional<ExpressionId> test) {
        const auto found = open_.find(id);
        if (found == open_.end()) return;
        Open& open = found->second;
        const RegionKind region_kind = regions_.all[id].region_kind;
        if (region_kind == RegionKind::until_loop && test) {
            add_edge({node, open.header, EdgeKind::back, test, false, {}, {}});
            loose_ = {{node, EdgeKind::branch, test, true}};
        } else if (is_loop(region_kind)) {
            add_edge({node, open.header, EdgeKind::back, {}, true, {}, {}});
            loose_.clear();
        }
        loose_.insert(loose_.end(), open.to_close.begin(), open.to_close.end());
        if (open.otherwise && open.fallback)
            tie(*open.otherwise, *open.fallback);
        else if (open.otherwise)
            loose_.push_back(*open.otherwise);
        open_.erase(found);
    }

    // ---- channels ----

    /// Which channels run each node: those that its block or section names. A condition in a block of some
    /// channels concerns only these; no manual says whether the others run what it guards.
    void find_channels() {
        struct Around {
            Channels deciding; ///< channels of which it is known whether they come here
            Offset end;
        };
        std::vector<Around> around{{program_.channels, program_.span.end + 1}};
        auto region = regions_.all.begin();
        graph_.channels.reserve(graph_.nodes.size());
        for (const Node& node : graph_.nodes) {
            const Offset begin = node.part.begin;
            while (around.size() > 1 && begin >= around.back().end) around.pop_back();
            for (; region != regions_.all.end() && begin_of(region->open) < begin; ++region)
                if (region->close && begin_of(*region->close) > begin)
                    around.push_back({deciding(*region, around.back().deciding), begin_of(*region->close)});
            const Channels running = program_.channels_of(node.item);
            graph_.channels.push_back({running, static_cast<Channels>(running & ~around.back().deciding)});
        }
    }

    [[nodiscard]] Channels deciding(const Region& region, Channels channels) const {
        const auto also = [&](EffectId effect) {
            if (const auto node = graph_.node_of(effect))
                channels = static_cast<Channels>(channels & program_.channels_of(graph_.nodes[*node].item));
        };
        also(region.open);
        std::ranges::for_each(region.parts, also);
        return channels;
    }

    [[nodiscard]] Offset begin_of(EffectId effect) const { return program_.effects[effect].span.begin; }

    // ---- jumps ----

    void resolve_jumps() {
        index_labels();
        const auto computed = static_cast<std::size_t>(
            std::ranges::count_if(graph_.jumps, [](const ResolvedJump& j) { return !j.label; }));
        const bool share = computed * graph_.labels.size() > most_computed_edges;
        std::optional<NodeId> shared;
        for (ResolvedJump& jump : graph_.jumps) {
            const auto& effect = std::get<Jump>(program_.effects[jump.jump].what);
            const Offset from = graph_.nodes[jump.node].part.begin;
            if (jump.label) {
                if (const LabelledBlock* found = graph_.find_label(*jump.label, from, effect.search)) {
                    jump.target = *found;
                    add_edge({jump.node, found->node, EdgeKind::jump, {}, true, jump.jump, {}});
                    if (effect.missing == MissingLabel::skip) goes_elsewhere_.push_back(jump.node);
                }
            } else if (!share) {
                const std::string_view beginning = beginning_of_label(program_, effect.target);
                for (std::uint32_t i = 0; i < graph_.labels.size(); ++i)
                    if (looks_at(effect.search, from, graph_.labels[i].block.begin) &&
                        (beginning.empty() || begins_with(program_.spell(graph_.labels[i].label), beginning)))
                        add_edge(
                            {jump.node, graph_.labels[i].node, EdgeKind::computed, {}, true, jump.jump, i});
            } else {
                if (!shared) shared = make_shared_target(jump.node);
                add_edge({jump.node, *shared, EdgeKind::computed, {}, true, jump.jump, {}});
            }
        }
        if (!has_unreadable_) return;
        for (NodeId node = 0; node < graph_.nodes.size(); ++node) resolve_unreadable(node);
    }

    NodeId add_node_without_effects(NodeId like) {
        Node node = graph_.nodes[like];
        node.effects.count = 0;
        graph_.nodes.push_back(node);
        return static_cast<NodeId>(graph_.nodes.size() - 1);
    }

    NodeId make_shared_target(NodeId like) {
        const NodeId id = add_node_without_effects(like);
        for (const LabelledBlock& labelled : graph_.labels)
            add_edge({id, labelled.node, EdgeKind::computed, {}, true, {}, {}});
        return id;
    }

    void resolve_unreadable(NodeId node) {
        for (const Effect& effect : program_.effects_in(graph_.nodes[node].effects)) {
            const auto* block = std::get_if<UnreadableBlock>(&effect.what);
            if (block == nullptr) continue;
            for (const Label& label : program_.labels_of(*block))
                if (const LabelledBlock* found = graph_.find_label(label, graph_.nodes[node].part.begin,
                                                                   LabelSearch::forward_then_top))
                    add_edge({node, found->node, EdgeKind::jump, {}, true, {}, {}});
        }
    }

    void resolve_returns() {
        if (calls_.empty() && goes_elsewhere_.empty()) return;
        std::vector<bool> goes_elsewhere(graph_.nodes.size(), false);
        for (const NodeId node : goes_elsewhere_) goes_elsewhere[node] = true;
        std::size_t edges = 0;
        for (const auto& [node, call] : calls_) {
            const auto& labels = return_targets_.at(call).labels;
            if (labels != nullptr) edges += std::min(labels->size(), graph_.labels.size());
        }
        SharedReturns shared;
        for (const auto& [node, call] : calls_) {
            const ReturnTargets& paths = return_targets_.at(call);
            bool all_there = true; // otherwise the control stops: what follows is not judged by that
            if (paths.labels == nullptr) {
                // it comes back to no label
            } else if (edges > most_computed_edges) {
                const SharedReturn& targets = shared_return(shared, *paths.labels, node);
                all_there = targets.all_there;
                add_edge({node, targets.node, EdgeKind::resume, {}, true, call, {}});
            } else {
                all_there = add_returns(node, call, *paths.labels);
            }
            goes_elsewhere[node] = !paths.to_next_block && all_there;
        }
        find_expected_returns();
        for (const auto& [node, call] : calls_)
            if (return_targets_.at(call).alarm == AlarmCall::always && graph_.expects_return(node))
                goes_elsewhere[node] = false;
        goes_elsewhere.resize(graph_.nodes.size(), false);
        std::erase_if(graph_.edges, [&](const Edge& edge) {
            return goes_elsewhere[edge.from] && edge.kind != EdgeKind::resume &&
                   edge.kind != EdgeKind::jump && edge.kind != EdgeKind::pass;
        });
        std::erase_if(graph_.exits, [&](const Exit& exit) { return goes_elsewhere[exit.node]; });
    }

    /// As though all calls came back.
    void find_expected_returns() {
        const auto may_alarm = [this](const auto& call) {
            return return_targets_.at(call.second).alarm != AlarmCall::none;
        };
        if (std::ranges::none_of(calls_, may_alarm)) return;
        const EdgesByNode out(graph_.nodes.size(), graph_.edges, &Edge::from);
        const EdgesByNode in(graph_.nodes.size(), graph_.edges, &Edge::to);
        const auto unavoidable = unavoidable_nodes(graph_.nodes.size(), graph_.edges, out, graph_.exits);
        // A program that does nothing but call it is there to stop as well.
        const bool is_more = has_other_work();
        for (const auto& call : calls_)
            if (may_alarm(call) &&
                ((is_more && unavoidable[call.first]) || goes_on_with_work(call.first, out, in)))
                graph_.returns_expected.push_back(call.first);
        std::ranges::sort(graph_.returns_expected);
    }

    /// Whether the program ends by itself, or works elsewhere than in calls that may stop.
    [[nodiscard]] bool has_other_work() const {
        std::vector<bool> calls(graph_.nodes.size(), false);
        for (const auto& [node, call] : calls_) calls[node] = true;
        for (NodeId node = 0; node < graph_.nodes.size(); ++node)
            if (!calls[node] && works(graph_.nodes[node])) return true;
        return std::ranges::any_of(graph_.exits,
                                   [](const Exit& exit) { return exit.kind == ExitKind::ends; });
    }

    /// Whether the blocks that only the call leads to do work: who wrote them expects it to come back. Jumps,
    /// ends and flags that are set may stand behind a call that is made to stop.
    [[nodiscard]] bool goes_on_with_work(NodeId call, const EdgesByNode& out, const EdgesByNode& in) const {
        constexpr int most_blocks = 16;
        NodeId node = call;
        for (int i = 0; i < most_blocks; ++i) {
            const auto edges = out[node];
            const bool goes_on = edges.size() == 1 && graph_.edges[edges[0]].kind == EdgeKind::next;
            if (!goes_on || in[graph_.edges[edges[0]].to].size() != 1) return false;
            node = graph_.edges[edges[0]].to;
            if (works(graph_.nodes[node])) return true;
        }
        return false;
    }

    [[nodiscard]] bool works(const Node& node) const {
        if (node.is_run) { // moves() tells of the whole run, of which this may be a part
            bool moves = false;
            for_each_block(program_, node.stretch(), [&](const BlockView& block) { moves |= block.moves; });
            return moves;
        }
        return std::ranges::any_of(program_.effects_in(node.effects), [this](const Effect& effect) {
            const auto* assign = std::get_if<Assign>(&effect.what);
            if (assign == nullptr)
                return std::holds_alternative<Motion>(effect.what) ||
                       std::holds_alternative<ToolChange>(effect.what) ||
                       std::holds_alternative<Call>(effect.what);
            return std::holds_alternative<Apply>(program_.expressions[assign->value].node);
        });
    }

    /// Whether all labels are there.
    bool add_returns(NodeId node, std::optional<EffectId> call, std::span<const Label> labels) {
        const auto add = [&](const LabelledBlock* found) {
            if (found != nullptr) add_edge({node, found->node, EdgeKind::resume, {}, true, call, {}});
        };
        if (labels.size() <= graph_.labels.size()) {
            bool all_there = true;
            for (const Label& label : labels) {
                const LabelledBlock* found = graph_.find_label(label, 0, LabelSearch::forward_then_top);
                all_there &= found != nullptr;
                add(found);
            }
            return all_there;
        }
        const Label* last = nullptr;
        for (const LabelledBlock& own : graph_.labels) { // the first of each label
            if ((last == nullptr || *last != own.label) && std::ranges::binary_search(labels, own.label))
                add(&own);
            last = &own.label;
        }
        return false;
    }

    /// A node from which calls that come back at the same labels go on, where edges of their own would be too
    /// many.
    struct SharedReturn {
        NodeId node;
        bool all_there;
    };
    using SharedReturns = std::unordered_map<const LabelList*, SharedReturn>; ///< by their list
    const SharedReturn& shared_return(SharedReturns& shared, const LabelList& labels, NodeId like) {
        const auto known = shared.find(&labels);
        if (known != shared.end()) return known->second;
        const NodeId node = add_node_without_effects(like);
        return shared.emplace(&labels, SharedReturn{node, add_returns(node, {}, labels)}).first->second;
    }

    void index_labels() {
        std::ranges::stable_sort(graph_.labels, {},
                                 [](const LabelledBlock& l) { return std::pair(l.label, l.block.begin); });
    }

    // ---- after all edges are there ----

    void index_effects() {
        for (NodeId node = 0; node < graph_.nodes.size(); ++node)
            if (graph_.nodes[node].effects.count != 0) graph_.with_effects.push_back(node);
        std::ranges::sort(graph_.with_effects, {},
                          [this](NodeId node) { return graph_.nodes[node].effects.first; });
        graph_.with_effects.shrink_to_fit();
    }

    void index_edges() {
        graph_.out = EdgesByNode(graph_.nodes.size(), graph_.edges, &Edge::from);
        graph_.in = EdgesByNode(graph_.nodes.size(), graph_.edges, &Edge::to);
    }

    /// Reverse postorder, without recursion: programs may have a million blocks.
    void number_nodes() {
        graph_.order.assign(graph_.nodes.size(), Graph::no_order);
        std::vector<NodeId> postorder;
        postorder.reserve(graph_.nodes.size());
        std::vector<bool> seen(graph_.nodes.size(), false);
        std::vector<std::pair<NodeId, std::size_t>> stack;
        stack.reserve(graph_.nodes.size());
        stack.emplace_back(0, 0);
        seen[0] = true;
        while (!stack.empty()) {
            auto& [node, next] = stack.back();
            if (next == graph_.out[node].size()) {
                postorder.push_back(node);
                stack.pop_back();
                continue;
            }
            const NodeId to = graph_.edges[graph_.out[node][next++]].to;
            if (!seen[to]) {
                seen[to] = true;
                stack.emplace_back(to, 0);
            }
        }
        for (std::size_t i = 0; i < postorder.size(); ++i)
            graph_.order[postorder[i]] = static_cast<std::uint32_t>(postorder.size() - 1 - i);
    }

    const Program& program_;
    const Regions& regions_;
    const Returns& returns_;
    Graph graph_;
    Wanted wanted_;
    bool has_unreadable_ = false; ///< some block may jump, whatever it says
    std::unordered_map<EffectId, ReturnTargets>
        return_targets_;                             ///< of calls that may go on elsewhere than after them
    std::unordered_set<const void*> wanted_lists_;   ///< lists of theirs whose labels are wanted
    std::vector<std::pair<NodeId, EffectId>> calls_; ///< these, and the nodes that end with them
    std::vector<NodeId> goes_elsewhere_;             ///< jumps that need not find their label, and did
    std::unordered_map<RegionId, Open> open_;
    std::vector<Loose> loose_;
    ItemId item_{};
    Span part_{};
};

/// The nodes that a search has met, in that order, each with the edge on which it was. Open addressing: many
/// searches look at a few nodes of a large graph.
class Met {
  public:
    void add(NodeId node, EdgeId by) {
        if (2 * (nodes_.size() + 1) > slots_.size()) grow();
        nodes_.emplace_back(node, by);
        slots_[slot_of(node)] = static_cast<std::uint32_t>(nodes_.size());
    }
    [[nodiscard]] bool knows(NodeId node) const { return !slots_.empty() && slots_[slot_of(node)] != 0; }
    [[nodiscard]] EdgeId edge_to(NodeId node) const { return nodes_[slots_[slot_of(node)] - 1].second; }
    [[nodiscard]] std::size_t size() const { return nodes_.size(); }
    [[nodiscard]] NodeId node(std::size_t index) const { return nodes_[index].first; }

  private:
    /// The slot of the node, or the free one where it belongs.
    [[nodiscard]] std::size_t slot_of(NodeId node) const {
        const std::size_t mask = slots_.size() - 1;
        std::size_t slot = (node * std::size_t{0x9E3779B1}) & mask;
        while (slots_[slot] != 0 && nodes_[slots_[slot] - 1].first != node) slot = (slot + 1) & mask;
        return slot;
    }

    void grow() {
        constexpr std::size_t fewest = 64;
        slots_.assign(std::max(fewest, 2 * slots_.size()), 0);
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            slots_[slot_of(nodes_[i].first)] = static_cast<std::uint32_t>(i + 1);
    }

    std::vector<std::pair<NodeId, EdgeId>> nodes_;
    std::vector<std::uint32_t> slots_; ///< 0: free; otherwise one more than the place in `nodes_`
};

} // namespace

EdgesByNode::EdgesByNode(std::size_t nodes, std::span<const Edge> edges, NodeId Edge::*node_of)
    : ids_(edges.size())
    , begin_(nodes + 1, 0) {
    for (const Edge& edge : edges) ++begin_[edge.*node_of + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    std::vector<EdgeId> next = begin_;
    for (EdgeId id = 0; id < edges.size(); ++id) ids_[next[edges[id].*node_of]++] = id;
}

std::span<const LabelledBlock> Graph::with_label(const Label& label) const {
    const auto found = std::ranges::equal_range(labels, label, {}, &LabelledBlock::label);
    return {found.begin(), found.end()};
}

bool Graph::expects_return(NodeId node) const { return std::ranges::binary_search(returns_expected, node); }

std::span<const Exit> Graph::exits_at(NodeId node) const {
    const auto found = std::ranges::equal_range(exits, node, {}, &Exit::node);
    return {found.begin(), found.end()};
}

bool Graph::has_all(std::span<const Label> sought) const {
    return sought.size() <= labels.size() &&
           std::ranges::all_of(sought, [this](const Label& label) { return has_label(label); });
}

bool Graph::has_label(const Label& label) const { return !with_label(label).empty(); }

const LabelledBlock* Graph::find_label(const Label& label, Offset from, LabelSearch search) const {
    const auto blocks = with_label(label);
    const auto begin_of = [](const LabelledBlock& labelled) { return labelled.block.begin; };
    const auto own = std::ranges::lower_bound(blocks, from, {}, begin_of);
    const auto after = std::ranges::upper_bound(blocks, from, {}, begin_of);
    const auto at = [&](auto found) { return found == blocks.end() ? nullptr : &*found; };
    const auto last_before = [&](auto end) { return end == blocks.begin() ? nullptr : &*std::prev(end); };
    switch (search) {
    case LabelSearch::forward_then_top: return at(own == blocks.end() ? blocks.begin() : own);
    case LabelSearch::forward: return at(after);
    case LabelSearch::backward: return last_before(after);
    case LabelSearch::forward_then_backward: return after != blocks.end() ? at(after) : last_before(after);
    }
    return nullptr;
}

std::optional<NodeId> Graph::node_of(Span block) const {
    const auto in_text = std::span(nodes).first(nodes_in_text);
    const auto node = std::ranges::partition_point(
        in_text, [&](const Node& before) { return before.part.end < block.end; });
    if (node == in_text.end() || node->part.begin > block.begin) return std::nullopt;
    return static_cast<NodeId>(node - in_text.begin());
}

std::optional<NodeId> Graph::node_of(EffectId effect) const {
    const auto after = std::ranges::upper_bound(with_effects, effect, {},
                                                [this](NodeId node) { return nodes[node].effects.first; });
    if (after == with_effects.begin()) return std::nullopt;
    const Slice& effects = nodes[*(after - 1)].effects;
    return effect < effects.first + effects.count ? std::optional(*(after - 1)) : std::nullopt;
}

std::optional<std::vector<EdgeId>>
Graph::path(NodeId from, NodeId to, const std::function<bool(EdgeId)>& usable, std::size_t most_nodes) const {
    Met met;
    const auto spread_from = [&](NodeId node) {
        for (const EdgeId id : out[node]) {
            const NodeId next = edges[id].to;
            if (!met.knows(next) && usable(id)) met.add(next, id);
            if (next == to && met.knows(to)) return;
        }
    };
    spread_from(from);
    for (std::size_t i = 0; i < met.size() && !met.knows(to) && met.size() < most_nodes; ++i)
        spread_from(met.node(i));
    if (!met.knows(to)) return std::nullopt;
    std::vector<EdgeId> path;
    for (NodeId node = to; path.empty() || node != from; node = edges[path.back()].from)
        path.push_back(met.edge_to(node));
    std::ranges::reverse(path);
    return path;
}

std::optional<std::int64_t> constant_number(const Program& program, ExpressionId expression) {
    const auto* literal = std::get_if<Literal>(&program.expressions[expression].node);
    constexpr double most = 9e15; // beyond it a double does not hold every whole number
    if (literal == nullptr) return std::nullopt;
    if (!(std::abs(literal->value) < most)) return std::numeric_limits<std::int64_t>::max();
    return std::llround(literal->value);
}

bool surely_runs(const Program& program, const Call& call) {
    if (!call.repeat) return true;
    const auto times = constant_number(program, *call.repeat);
    return times && *times > 0;
}

std::optional<Label> constant_target(const Program& program, ExpressionId target) {
    if (const auto* name = std::get_if<BlockName>(&program.expressions[target].node)) return *name;
    return constant_number(program, target);
}

bool returns_after_call(const Program& program, const Exit& exit) {
    if (exit.kind == ExitKind::runs_off) return true;
    if (exit.kind != ExitKind::returns) return false;
    const auto& label = std::get<Return>(program.effects[*exit.effect].what).resume_label;
    return !label || !constant_target(program, *label);
}

Graph build_graph(const Program& program, const Regions& regions, const Returns& returns) {
    return Building(program, regions, returns).run();
}

} // namespace maclint::flow
