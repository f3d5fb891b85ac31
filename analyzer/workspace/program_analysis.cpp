//! Questions about one program that need graph and data flow together.
#include "analyzer/workspace/program_analysis.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/machine/given_words.hpp"
#include "analyzer/machine/states.hpp"
#include "analyzer/machine/switch_states.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <iterator>
#include <ranges>
#include <unordered_map>
#include <variant>

namespace maclint {
namespace {

/// Whether the effect is all that its block does.
bool stands_alone(const Program& program, EffectId effect) {
    const Offset place = program.effects[effect].span.begin;
    const auto after =
        std::ranges::partition_point(std::views::iota(ItemId{0}, static_cast<ItemId>(program.items.size())),
                                     [&](ItemId item) { return program.span_of(item).begin <= place; });
    const auto block = *after == 0 ? std::nullopt : stored_block(program, *after - 1);
    return block && block->effects.count == 1 && block->words.empty();
}

} // namespace

ProgramAnalysis::ProgramAnalysis(const Workspace& workspace, ProgramIndex index, const WorkspaceFile& file,
                                 const Program& program)
    : workspace_(&workspace)
    , index_(index)
    , file_(&file)
    , program_(&program) {}
ProgramAnalysis::~ProgramAnalysis() = default;

std::optional<std::vector<flow::EdgeId>> ProgramAnalysis::path_from_start(flow::NodeId node) const {
    const flow::ShortestPaths& paths = paths_.get([this] {
        return flow::ShortestPaths(graph_, [this](flow::EdgeId id) { return data_->passable(id); });
    });
    return paths.to(graph_, node);
}

const dataflow::Liveness& ProgramAnalysis::liveness() const {
    return liveness_.get([this] {
        using Locals = dataflow::Liveness::Locals;
        const bool own = (is_main() || is_macro_) && !locals_are_callers_;
        return dataflow::Liveness(*program_, graph_, own ? Locals::end_with_it : Locals::outlive_it);
    });
}

const GivenWord* ProgramAnalysis::word_at(EffectId call) const {
    const auto* made = std::get_if<Call>(&program_->effects[call].what);
    const Text* name = made == nullptr ? nullptr : std::get_if<Text>(&made->program);
    const auto& words = names_elsewhere().words;
    if (name == nullptr || words == nullptr || words->empty()) return nullptr;
    const GivenWord* word = names_elsewhere().word(in_capitals(program_->slice(name->characters)));
    if (word == nullptr || !word->is_known) return nullptr;
    return word->only_switches() || stands_alone(*program_, call) ? word : nullptr;
}

const ProgramAnalysis* ProgramAnalysis::followed(const CallSite* site) const {
    if (site == nullptr || !site->target || site->in_cycle) return nullptr;
    const ProgramAnalysis& called = workspace_->programs()[*site->target];
    return called.is_too_deep() ? nullptr : &called;
}

const machine::States& ProgramAnalysis::machine() const {
    return *machine_.get([this] {
        const auto words = std::make_shared<std::unordered_map<EffectId, machine::Left>>();
        for (const CallSite& site : calls_)
            if (const GivenWord* word = word_at(site.effect))
                words->emplace(site.effect, machine::left_by(*word, control()));
        auto states = std::make_unique<machine::States>(
            *program_, graph_,
            [this, words](EffectId call) -> const machine::Left* {
                if (const auto word = words->find(call); word != words->end()) return &word->second;
                const ProgramAnalysis* called = followed(call_at(call));
                return called == nullptr ? nullptr : &called->machine().left();
            },
            std::nullopt);
        for (const dataflow::GroupChange& change : summary().groups)
            if (change.may_keep && change.codes.empty() && !change.other)
                states->leaves_as_it_was(control().groups[change.group].role);
        return std::unique_ptr<const machine::States>(std::move(states));
    });
}

const machine::SwitchStates& ProgramAnalysis::switches() const {
    return *switches_.get([this] {
        return std::make_unique<const machine::SwitchStates>(
            *program_, graph_, [this](EffectId call, std::uint8_t channel) -> const machine::SwitchState* {
                const CallSite* site = call_at(call);
                const ProgramAnalysis* program = followed(site);
                const auto* called = program == nullptr ? nullptr : program->switches().of(channel);
                return called == nullptr ? nullptr : &called->left();
            });
    });
}

std::vector<flow::LabelledBlock> ProgramAnalysis::targets_of(const flow::ResolvedJump& jump) const {
    if (jump.target) return {*jump.target};
    std::vector<flow::LabelledBlock> targets;
    for (const flow::EdgeId id : graph_.out[jump.node]) {
        const flow::Edge& edge = graph_.edges[id];
        if (edge.kind != flow::EdgeKind::computed || edge.jump != jump.jump || !data_->passable(id)) continue;
        if (!edge.label) return {};
        targets.push_back(graph_.labels[*edge.label]);
    }
    return targets;
}

PossibleCallers ProgramAnalysis::possible_callers() const {
    PossibleCallers possible{{}, true};
    for (const auto& calls : undecided_) {
        const std::size_t room = PossibleCallers::most - possible.first.size();
        possible.all &= calls->callers.size() <= room;
        std::ranges::copy(calls->callers | std::views::take(room), std::back_inserter(possible.first));
    }
    return possible;
}

std::optional<EffectId> ProgramAnalysis::user_of_label(const Label& label) const {
    std::optional<EffectId> user;
    for (const flow::LabelledBlock& labelled : graph_.with_label(label))
        for (const flow::EdgeId id : graph_.in[labelled.node]) {
            const flow::Edge& edge = graph_.edges[id];
            const bool stated = edge.kind == flow::EdgeKind::jump;
            const bool possible = (edge.kind == flow::EdgeKind::computed && edge.label &&
                                   graph_.labels[*edge.label].label == label) ||
                                  edge.kind == flow::EdgeKind::resume;
            if (!edge.jump || !(stated || (possible && data_->passable(id)))) continue;
            if (!user || program_->effects[*edge.jump].span.begin < program_->effects[*user].span.begin)
                user = edge.jump;
        }
    return user;
}

std::vector<dataflow::OriginId> ProgramAnalysis::own_modal_calls(const dataflow::State& state,
                                                                 flow::NodeId node) const {
    std::vector<dataflow::OriginId> calls;
    const std::optional<GroupId> group = control().group_with(ModalRole::macro_call);
    if (!group) return calls;
    const dataflow::ModalValue value = data_->modal(state, node, *group);
    if (value.unknown) return calls;
    for (const dataflow::ModalPart& part : value.parts) {
        const dataflow::Origin& origin = data_->origin(part.origin);
        if (origin.kind != dataflow::Origin::Kind::effect) continue;
        const auto* call = std::get_if<Call>(&program_->effects[origin.id].what);
        if (call != nullptr && control().calls[call->kind].trigger != CallTrigger::once)
            calls.push_back(part.origin);
    }
    return calls;
}

} // namespace maclint
