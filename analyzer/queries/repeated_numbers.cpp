//! Groups numbered blocks by their numbers.
#include "analyzer/queries/repeated_numbers.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <variant>

namespace maclint::queries {
namespace {

/// The place that the jump takes, where it names a plain label.
std::optional<Span> taken_by(const ProgramAnalysis& analysis, EffectId jump) {
    const auto& jumps = analysis.graph().jumps;
    const auto found = std::ranges::find(jumps, jump, &flow::ResolvedJump::jump);
    return found == jumps.end() || !found->target ? std::nullopt : std::optional(found->target->span);
}

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
            found.push_back({wanted.first, std::move(blocks), users.at(wanted),
                             taken_by(analysis, users.at(wanted)), Doubling::referenced, std::nullopt});
}

using Copies = std::span<const flow::LabelledBlock>;

/// A jump that names the label and goes back, past the block that stands before it.
const flow::ResolvedJump* find_passing(const ProgramAnalysis& analysis, Copies copies) {
    const auto& effects = analysis.program().effects;
    const auto& jumps = analysis.graph().jumps;
    const auto found = std::ranges::find_if(jumps, [&](const flow::ResolvedJump& jump) {
        const Offset place = effects[jump.jump].span.begin;
        return jump.label == copies.front().label && jump.target && place > copies.back().block.begin &&
               jump.target->node != copies.back().node;
    });
    return found == jumps.end() ? nullptr : &*found;
}

bool is_jumped_to(const ProgramAnalysis& analysis, const flow::LabelledBlock& copy) {
    const flow::Graph& graph = analysis.graph();
    return std::ranges::any_of(graph.in[copy.node], [&](flow::EdgeId id) {
        const flow::Edge& edge = graph.edges[id];
        const bool named = !edge.label || graph.labels[*edge.label].label == copy.label;
        return edge.jump && named && (edge.kind != flow::EdgeKind::computed || analysis.data().passable(id));
    });
}

const flow::LabelledBlock* find_unreached(const ProgramAnalysis& analysis, Copies copies) {
    const auto found = std::ranges::find_if(copies, [&](const flow::LabelledBlock& copy) {
        return !analysis.data().reached(copy.node) && !is_jumped_to(analysis, copy);
    });
    return found == copies.end() ? nullptr : &*found;
}

/// Whether a computed jump finds this block first, of those that bear the label.
bool is_found_by_computed_jump(const ProgramAnalysis& analysis, const flow::LabelledBlock& copy) {
    const Program& program = analysis.program();
    const flow::Graph& graph = analysis.graph();
    return std::ranges::any_of(graph.jumps, [&](const flow::ResolvedJump& jump) {
        if (jump.label) return false;
        const Effect& effect = program.effects[jump.jump];
        const flow::LabelledBlock* found = graph.find_label(copy.label, graph.nodes[jump.node].part.begin,
                                                            std::get<Jump>(effect.what).search);
        return found != nullptr && found->node == copy.node;
    });
}

/// Blocks that were copied together with the computed jump above them.
bool have_computed_jumps_of_their_own(const ProgramAnalysis& analysis, Copies copies) {
    const auto& jumps = analysis.graph().jumps;
    const bool named = std::ranges::any_of(
        jumps, [&](const flow::ResolvedJump& jump) { return jump.label == copies.front().label; });
    return !named && std::ranges::all_of(copies, [&](const flow::LabelledBlock& copy) {
        return is_found_by_computed_jump(analysis, copy);
    });
}

/// Of blocks that bear a label to which `user` leads.
RepeatedNumber judge(const ProgramAnalysis& analysis, std::int64_t number, Copies copies, EffectId user) {
    RepeatedNumber repeated{number, {}, user, taken_by(analysis, user), Doubling::harmless, std::nullopt};
    for (const flow::LabelledBlock& copy : copies) repeated.blocks.push_back(copy.span);
    if (const flow::ResolvedJump* jump = find_passing(analysis, copies)) {
        repeated.user = jump->jump;
        repeated.taken = jump->target->span;
        repeated.doubling = Doubling::passed_over;
        repeated.missed = copies.back().span;
    } else if (const flow::LabelledBlock* copy = find_unreached(analysis, copies);
               copy != nullptr && repeated.taken) {
        repeated.doubling = Doubling::unreached;
        repeated.missed = copy->span;
    }
    return repeated;
}

void add_jump_targets(const ProgramAnalysis& analysis, std::vector<RepeatedNumber>& found) {
    const std::span<const flow::LabelledBlock> labels = analysis.graph().labels; // equal ones stand together
    for (std::size_t first = 0; first < labels.size();) {
        std::size_t end = first;
        while (end < labels.size() && labels[end].label == labels[first].label) ++end;
        const Copies copies = labels.subspan(first, end - first);
        first = end;
        const auto* number = std::get_if<std::int64_t>(&copies.front().label);
        if (number == nullptr || copies.size() == 1) continue;
        const auto user = analysis.user_of_label(copies.front().label);
        if (user && !have_computed_jumps_of_their_own(analysis, copies))
            found.push_back(judge(analysis, *number, copies, *user));
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
