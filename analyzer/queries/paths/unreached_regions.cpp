//! The flow graph says which blocks are reached; what stands before and in the others says why they are not.
#include "analyzer/queries/paths/unreached_regions.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>

namespace maclint::queries {
namespace {

bool is_reached(const flow::Graph& graph, flow::NodeId node) {
    return graph.order[node] != flow::Graph::no_order;
}

bool is_end(const Effect& effect) {
    const auto* stop = std::get_if<Stop>(&effect.what);
    return std::holds_alternative<Return>(effect.what) ||
           (stop != nullptr && (stop->kind == Stop::Kind::end || stop->kind == Stop::Kind::restart));
}

bool is_alarm(const Effect& effect) {
    const auto* stop = std::get_if<Stop>(&effect.what);
    return stop != nullptr && stop->kind == Stop::Kind::alarm;
}

bool moves_or_calls(const Effect& effect) {
    return std::holds_alternative<Motion>(effect.what) || std::holds_alternative<Call>(effect.what) ||
           std::holds_alternative<ToolChange>(effect.what);
}

bool does_more_than_switch(const Effect& effect) {
    return moves_or_calls(effect) || std::holds_alternative<Assign>(effect.what);
}

bool works(const Effect& effect) {
    return does_more_than_switch(effect) || std::holds_alternative<SetModal>(effect.what);
}

/// Nodes of loops that nothing ends, which have rules of their own.
std::vector<bool> nodes_of_endless_loops(const ProgramAnalysis& analysis) {
    std::vector<bool> endless(analysis.graph().nodes.size(), false);
    for (const dataflow::Loop& loop : analysis.inescapable_cycles())
        for (const flow::NodeId node : loop.body) endless[node] = true;
    return endless;
}

/// What ends the node before the region and always leaves it: a jump, a stop, a return.
std::optional<EffectId> ender_before(const ProgramAnalysis& analysis, flow::NodeId first,
                                     const std::vector<bool>& endless) {
    if (first == 0) return std::nullopt;
    const Slice effects = analysis.graph().nodes[first - 1].effects;
    if (effects.count == 0) return std::nullopt;
    const EffectId last = effects.first + effects.count - 1;
    const Effect& effect = analysis.program().effects[last];
    const bool jumps = std::holds_alternative<Jump>(effect.what) && !endless[first - 1];
    return jumps || is_end(effect) || is_alarm(effect) ? std::optional(last) : std::nullopt;
}

/// Behind the jump its block goes on with a remark: `GOTO4(DELETE TO ENABLE)`.
bool is_passed_on_purpose(const ProgramAnalysis& analysis, const UnreachedRegion& region) {
    const Effect& effect = analysis.program().effects[*region.ender];
    const std::string_view behind =
        analysis.program().slice({effect.span.end, analysis.graph().nodes[region.first - 1].part.end});
    return exemptions::remark_behind_jump.is_on() && std::holds_alternative<Jump>(effect.what) &&
           std::ranges::any_of(behind, is_letter);
}

/// Where nothing jumps, no block is kept for a jump to come: whatever it does is lost.
bool does_anything(const Program& program, const Effect& effect) {
    return !program.control->has(Capability::jumps) && !is_end(effect) &&
           !std::holds_alternative<RegionMark>(effect.what);
}

UnreachedRegion region_at(flow::NodeId node, Span part) {
    UnreachedRegion region{};
    region.first = region.last = node;
    region.text = part;
    return region;
}

/// A number that stands behind an N.
struct NumberInText {
    std::int64_t number;
    Offset word;
};

/// The number that the text begins with.
std::optional<std::int64_t> number_at(std::string_view text) {
    std::int64_t number = 0;
    const bool is_number = std::from_chars(text.data(), text.data() + text.size(), number).ec == std::errc();
    return is_number ? std::optional(number) : std::nullopt;
}

/// The numbers that stand behind an N, sorted.
std::vector<NumberInText> numbers_of_blocks(const Program& program) {
    const std::string text = in_capitals(program.slice(program.span));
    std::vector<NumberInText> numbers;
    for (auto at = text.find('N'); at != std::string::npos; at = text.find('N', at + 1))
        if (const auto number = number_at(std::string_view(text).substr(at + 1)))
            numbers.push_back({*number, static_cast<Offset>(program.span.begin + at)});
    std::ranges::sort(numbers, {}, &NumberInText::number);
    return numbers;
}

/// What the text says of block numbers.
class NamedBlocks {
  public:
    explicit NamedBlocks(const ProgramAnalysis& analysis)
        : program_(analysis.program()) {}

    /// Whether the region's number stands behind an N elsewhere.
    [[nodiscard]] bool names(const UnreachedRegion& region) {
        if (!region.number) return false;
        if (!numbers_) numbers_ = numbers_of_blocks(program_);
        return std::ranges::any_of(
            std::ranges::equal_range(*numbers_, *region.number, {}, &NumberInText::number),
            [&](const NumberInText& named) {
                return !region.text.contains(named.word) && region.head.begin != named.word;
            });
    }

  private:
    const Program& program_;
    std::optional<std::vector<NumberInText>> numbers_; ///< nothing: nobody has asked
};

/// Whether a jump, or a called program when it returns, looks for a number that no block bears.
bool misses_a_number(const ProgramAnalysis& analysis) {
    const auto is_lost = [](const flow::ResolvedJump& jump) { return jump.label && !jump.target; };
    const auto returns_nowhere = [&](const CallSite& site) {
        const ProgramAnalysis* called = called_program(analysis, site);
        if (called == nullptr) return false;
        const auto& labels = called->summary().resume_labels;
        return labels != nullptr && !analysis.graph().has_all(*labels);
    };
    return std::ranges::any_of(analysis.graph().jumps, is_lost) ||
           std::ranges::any_of(analysis.calls(), returns_nowhere);
}

/// Unreadable text in it tells why, or a number that is missing or stands twice.
bool is_explained(const ProgramAnalysis& analysis, const UnreachedRegion& region, bool misses) {
    return !analysis.file().syntax_errors_in(region.text).empty() ||
           (region.number && (misses || analysis.graph().with_label(*region.number).size() > 1));
}

void look_at_block(const Program& program, const BlockView& block, UnreachedRegion& region) {
    const auto effects = program.effects_in(block.effects);
    region.leaves |= std::ranges::any_of(effects, is_end);
    region.moves |= block.moves || std::ranges::any_of(effects, moves_or_calls);
    const bool works_here =
        block.moves || !block.settings.empty() || std::ranges::any_of(effects, [&](const Effect& effect) {
            return works(effect) || does_anything(program, effect);
        });
    if (works_here && !region.work) region.work = block.span;
    if (block.moves || std::ranges::any_of(effects, does_more_than_switch)) region.only_switches = false;
    if (region.head.empty()) {
        region.head = block.span;
        region.number = block.number;
    }
}

void look_at(const ProgramAnalysis& analysis, UnreachedRegion& region) {
    const Program& program = analysis.program();
    const flow::Graph& graph = analysis.graph();
    bool straight = true;
    for (flow::NodeId node = region.first; node <= region.last; ++node) {
        if (node == region.first || graph.nodes[node].part != graph.nodes[node - 1].part)
            for_each_block(program, graph.nodes[node].stretch(),
                           [&](const BlockView& block) { look_at_block(program, block, region); });
        const Slice effects = graph.nodes[node].effects;
        for (Id id = effects.first; id < effects.first + effects.count; ++id) {
            const Effect& effect = program.effects[id];
            if (is_alarm(effect)) {
                region.is_alarm |= straight;
                region.alarms.push_back(id);
            }
            straight &= !is_alarm(effect) && !is_end(effect) && !std::holds_alternative<Jump>(effect.what) &&
                        !std::holds_alternative<Guarded>(effect.what);
        }
    }
    region.text.end = std::max(region.text.end, graph.nodes[region.last].part.end);
}

} // namespace

std::vector<UnreachedRegion> unreached_regions(const ProgramAnalysis& analysis) {
    const flow::Graph& graph = analysis.graph();
    std::vector<UnreachedRegion> found;
    if (analysis.regions().balance_unknown || !analysis.regions().faults.empty()) return found;
    for (flow::NodeId node = 1; node < graph.nodes.size(); ++node) {
        if (is_reached(graph, node)) continue;
        // What follows in the block of the jump itself is another matter.
        if (graph.nodes[node].part == graph.nodes[node - 1].part && is_reached(graph, node - 1)) continue;
        const Span part = graph.nodes[node].part;
        if (!found.empty() && found.back().last + 1 == node)
            found.back().last = node;
        else
            found.push_back(region_at(node, part));
    }
    const std::vector<bool> endless = nodes_of_endless_loops(analysis);
    std::erase_if(found, [&](UnreachedRegion& region) {
        region.ender = ender_before(analysis, region.first, endless);
        return !region.ender;
    });
    if (found.empty()) return found;
    NamedBlocks named(analysis);
    const bool misses = misses_a_number(analysis);
    for (UnreachedRegion& region : found) {
        look_at(analysis, region);
        region.is_meant = is_passed_on_purpose(analysis, region);
        region.is_explained = is_explained(analysis, region, misses);
        region.is_named = region.is_alarm && named.names(region);
    }
    return found;
}

} // namespace maclint::queries
