//! Groups numbered blocks by their numbers.
#include "analyzer/queries/structure/repeated_numbers.hpp"

#include "analyzer/program/section_kinds.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <ranges>
#include <set>
#include <span>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

namespace maclint::queries {
namespace {

using Copies = std::span<const flow::LabelledBlock>;

/// The jumps of a program, gathered once for all numbers.
class Jumps {
  public:
    explicit Jumps(const ProgramAnalysis& analysis)
        : analysis_(analysis) {
        for (const flow::ResolvedJump& jump : analysis.graph().jumps) {
            if (!jump.label)
                computed_[search_of(jump)].push_back(place_of(jump));
            else if (const auto* number = std::get_if<std::int64_t>(&*jump.label))
                naming_[*number].push_back(&jump);
        }
        for (auto& [search, places] : computed_) std::ranges::sort(places);
    }

    /// In text order.
    [[nodiscard]] std::span<const flow::ResolvedJump* const> naming(std::int64_t number) const {
        const auto found = naming_.find(number);
        return found == naming_.end() ? std::span<const flow::ResolvedJump* const>{} : found->second;
    }

    /// Whether a computed jump finds this block first, of those that bear the label. If any does, it is the
    /// next one before or behind it, or, of those that go on at the other end, the last.
    [[nodiscard]] bool some_computed_finds(const flow::LabelledBlock& copy) const {
        return std::ranges::any_of(computed_, [&](const auto& entry) {
            const auto& [search, places] = entry;
            const auto next = std::ranges::lower_bound(places, copy.block.begin);
            const auto finds = [&, search = search](Offset place) {
                const auto* found = analysis_.graph().find_label(copy.label, place, search);
                return found != nullptr && found->node == copy.node;
            };
            return (next != places.begin() && finds(*std::prev(next))) ||
                   (next != places.end() && finds(*next)) || finds(places.back());
        });
    }

  private:
    [[nodiscard]] LabelSearch search_of(const flow::ResolvedJump& jump) const {
        return std::get<Jump>(analysis_.program().effects[jump.jump].what).search;
    }
    [[nodiscard]] Offset place_of(const flow::ResolvedJump& jump) const {
        return analysis_.graph().nodes[jump.node].part.begin;
    }

    const ProgramAnalysis& analysis_;
    std::unordered_map<std::int64_t, std::vector<const flow::ResolvedJump*>> naming_;
    std::map<LabelSearch, std::vector<Offset>> computed_; ///< where they stand
};

/// In the sections in which a reference or a restart is looked for.
void add_references(const ProgramAnalysis& analysis, std::vector<RepeatedNumber>& found) {
    using Wanted = std::pair<std::int64_t, SectionKind::Role>;
    std::map<Wanted, EffectId> users;
    std::set<std::int64_t> numbers;
    for (const BlockUser& user : find_block_users(analysis.program())) {
        users.emplace(Wanted(user.number, user.target), user.effect);
        numbers.insert(user.number);
    }
    std::map<Wanted, std::vector<Span>> places;
    for (const NumberedBlock& block : find_blocks(analysis.file(), numbers)) {
        if (block.section == nullptr) continue;
        const Wanted wanted(block.number, block.section->role);
        if (users.contains(wanted)) places[wanted].push_back(block.number_span);
    }
    for (auto& [wanted, blocks] : places)
        if (blocks.size() > 1)
            found.push_back({wanted.first, std::move(blocks), users.at(wanted), std::nullopt,
                             Doubling::referenced, std::nullopt});
}

/// The place to which the first jump that names the number goes.
std::optional<Span> taken_by(std::span<const flow::ResolvedJump* const> naming, EffectId jump) {
    const auto found = std::ranges::find(naming, jump, &flow::ResolvedJump::jump);
    return found == naming.end() || !(*found)->target ? std::nullopt : std::optional((*found)->target->span);
}

/// A jump that names the label and goes back, past the block that stands before it.
const flow::ResolvedJump* find_passing(const ProgramAnalysis& analysis,
                                       std::span<const flow::ResolvedJump* const> naming, Copies copies) {
    const auto& effects = analysis.program().effects;
    const auto found = std::ranges::find_if(naming, [&](const flow::ResolvedJump* jump) {
        const Offset place = effects[jump->jump].span.begin;
        return jump->target && place > copies.back().block.begin && jump->target->node != copies.back().node;
    });
    return found == naming.end() ? nullptr : *found;
}

bool is_jumped_to(const ProgramAnalysis& analysis, const flow::LabelledBlock& copy) {
    const flow::Graph& graph = analysis.graph();
    return std::ranges::any_of(graph.in[copy.node], [&](flow::EdgeId id) {
        const flow::Edge& edge = graph.edges[id];
        const bool named = !edge.label || graph.labels[*edge.label].label == copy.label;
        return edge.jump && named && (edge.kind != flow::EdgeKind::computed || analysis.data().passable(id));
    });
}

/// A plain jump that goes on past the end of its part to the block of another one, while its own part has
/// one before it, which no other jump finds. Parts end where nothing runs on into what follows, and where a
/// loop begins.
struct Strayed {
    const flow::ResolvedJump* jump;
    const flow::LabelledBlock* own; ///< that stands before the jump, in its part
};

/// Whether the control never runs on from the block before the node into the node.
bool begins_part(const flow::Graph& graph, flow::NodeId node) {
    return std::ranges::none_of(graph.in[node], [&](flow::EdgeId id) {
        const flow::Edge& edge = graph.edges[id];
        return edge.from + 1 == node && !edge.jump;
    });
}

bool is_in_loop_without(const ProgramAnalysis& analysis, const flow::LabelledBlock& target, Offset jump) {
    const auto& effects = analysis.program().effects;
    const auto holds = [&](const flow::Region& region, Offset place) {
        return region.close && effects[region.open].span.begin < place &&
               place < effects[*region.close].span.begin;
    };
    return std::ranges::any_of(analysis.regions().all, [&](const flow::Region& region) {
        return is_loop(region.region_kind) && holds(region, target.block.begin) && !holds(region, jump);
    });
}

std::optional<Strayed> find_strayed(const ProgramAnalysis& analysis,
                                    std::span<const flow::ResolvedJump* const> naming, Copies copies) {
    const auto is_parted = [&](flow::NodeId from, flow::NodeId to) {
        for (flow::NodeId node = from + 1; node <= to; ++node)
            if (begins_part(analysis.graph(), node)) return true;
        return false;
    };
    for (const flow::ResolvedJump* jump : naming) {
        if (!jump->target || jump->target->node <= jump->node) continue;
        const auto own =
            std::ranges::find_if(copies | std::views::reverse,
                                 [&](const flow::LabelledBlock& copy) { return copy.node < jump->node; });
        if (own == std::ranges::rend(copies) || is_jumped_to(analysis, *own) ||
            is_parted(own->node, jump->node))
            continue;
        const Offset place = analysis.program().effects[jump->jump].span.begin;
        if (is_parted(jump->node, jump->target->node) || is_in_loop_without(analysis, *jump->target, place))
            return Strayed{jump, &*own};
    }
    return std::nullopt;
}

const flow::LabelledBlock* find_unreached(const ProgramAnalysis& analysis, Copies copies) {
    const auto found = std::ranges::find_if(copies, [&](const flow::LabelledBlock& copy) {
        return !analysis.data().reached(copy.node) && !is_jumped_to(analysis, copy);
    });
    return found == copies.end() ? nullptr : &*found;
}

/// Blocks that were copied together with the computed jump above them.
bool have_computed_jumps_of_their_own(const Jumps& jumps, std::int64_t number, Copies copies) {
    return jumps.naming(number).empty() && std::ranges::all_of(copies, [&](const flow::LabelledBlock& copy) {
               return jumps.some_computed_finds(copy);
           });
}

/// Of blocks that bear a label to which `user` leads.
RepeatedNumber judge(const ProgramAnalysis& analysis, const Jumps& jumps, std::int64_t number, Copies copies,
                     EffectId user) {
    const auto naming = jumps.naming(number);
    RepeatedNumber repeated{number, {}, user, taken_by(naming, user), Doubling::harmless, std::nullopt};
    for (const flow::LabelledBlock& copy : copies) repeated.blocks.push_back(copy.span);
    if (const flow::ResolvedJump* jump = find_passing(analysis, naming, copies)) {
        repeated.user = jump->jump;
        repeated.taken = jump->target->span;
        repeated.doubling = Doubling::passed_over;
        repeated.missed = copies.back().span;
    } else if (const auto strayed = find_strayed(analysis, naming, copies)) {
        repeated.user = strayed->jump->jump;
        repeated.taken = strayed->jump->target->span;
        repeated.doubling = Doubling::in_other_part;
        repeated.missed = strayed->own->span;
    } else if (const flow::LabelledBlock* copy = find_unreached(analysis, copies);
               copy != nullptr && repeated.taken) {
        repeated.doubling = Doubling::unreached;
        repeated.missed = copy->span;
    }
    return repeated;
}

void add_jump_targets(const ProgramAnalysis& analysis, std::vector<RepeatedNumber>& found) {
    const Copies labels = analysis.graph().labels; // equal ones stand together
    std::optional<Jumps> jumps;
    for (std::size_t first = 0; first < labels.size();) {
        std::size_t end = first;
        while (end < labels.size() && labels[end].label == labels[first].label) ++end;
        const Copies copies = labels.subspan(first, end - first);
        first = end;
        const auto* number = std::get_if<std::int64_t>(&copies.front().label);
        if (number == nullptr || copies.size() == 1) continue;
        const auto user = analysis.user_of_label(copies.front().label);
        if (!user) continue;
        if (!jumps) jumps.emplace(analysis);
        if (!exemptions::computed_jump_beside_each.is_on() ||
            !have_computed_jumps_of_their_own(*jumps, *number, copies))
            found.push_back(judge(analysis, *jumps, *number, copies, *user));
    }
}

} // namespace

std::vector<RepeatedNumber> find_repeated_numbers(const ProgramAnalysis& analysis) {
    std::vector<RepeatedNumber> found;
    add_references(analysis, found);
    add_jump_targets(analysis, found);
    return found;
}

} // namespace maclint::queries
