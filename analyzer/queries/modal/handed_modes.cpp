//! A search forward from each call, until a block sets the group.
#include "analyzer/queries/modal/handed_modes.hpp"

#include "analyzer/flow/walk.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/overloaded.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/source/budget.hpp"
#include "analyzer/workspace/workspace.hpp"

#include <algorithm>
#include <optional>
#include <variant>
#include <vector>

namespace maclint::queries {
namespace {

/// Nodes that are looked at for all callers; who cancels only beyond them is not found.
constexpr std::size_t most_looked_at = 2000;

/// What blocks say of a group.
enum class Said : std::uint8_t { nothing, cancelled, otherwise };

class Ends {
  public:
    Ends(const ProgramAnalysis& caller, GroupId group)
        : caller_(caller)
        , group_(group) {}

    /// Whether all paths from the call on come to where the group is cancelled, among `left` nodes, which are
    /// counted down.
    [[nodiscard]] bool after(EffectId call, std::size_t& left) {
        const auto from = caller_.graph().node_of(call);
        if (!from) return false;
        bool cancelled = false, lost = leaves_at(*from);
        flow::walk<flow::Direction::forward>(
            caller_.graph(), {*from}, [&](flow::EdgeId edge, flow::NodeId to) {
                if (!caller_.data().passable(edge)) return flow::Step::refuse;
                const Said said = left != 0 && Budget::allows() ? said_at(to) : Said::otherwise;
                left -= std::min<std::size_t>(left, 1);
                cancelled |= said == Said::cancelled;
                lost |= said == Said::otherwise || (said == Said::nothing && leaves_at(to));
                return lost                    ? flow::Step::end
                       : said == Said::nothing ? flow::Step::go_on
                                               : flow::Step::refuse;
            });
        return cancelled && !lost;
    }

  private:
    [[nodiscard]] bool leaves_at(flow::NodeId node) const {
        return std::ranges::any_of(caller_.graph().exits_at(node),
                                   [](const flow::Exit& exit) { return exit.kind != flow::ExitKind::alarm; });
    }

    [[nodiscard]] Said said_at(flow::NodeId id) const {
        const flow::Node& node = caller_.graph().nodes[id];
        for (const Effect& effect : caller_.program().effects_in(node.effects))
            if (const auto* call = std::get_if<Call>(&effect.what); call != nullptr)
                if (const Said said = said_by_call(effect); said != Said::nothing) return said;
        return said_by_blocks(caller_.program(), node.stretch());
    }

    [[nodiscard]] Said said_by_call(const Effect& effect) const {
        const auto id = static_cast<EffectId>(&effect - caller_.program().effects.data());
        const CallSite* site = caller_.call_at(id);
        const ProgramAnalysis* callee = site == nullptr ? nullptr : called_program(caller_, *site);
        if (callee == nullptr) {
            const auto& call = std::get<Call>(effect.what);
            const bool leaves_all = caller_.control().calls[call.kind].brought_by_control ||
                                    !call_may_change(caller_, id, group_);
            return leaves_all ? Said::nothing : Said::otherwise;
        }
        if (!call_may_change(caller_, id, group_)) return Said::nothing;
        Said said = Said::otherwise;
        for_each_block(callee->program(), [&](const BlockView& block) {
            const Said here = said_by(callee->program(), block);
            if (here != Said::nothing) said = here; // the last in the text
            return true;
        });
        return said;
    }

    [[nodiscard]] Said said_by_blocks(const Program& program, const Stretch& stretch) const {
        Said said = Said::nothing;
        for_each_block(program, stretch, [&](const BlockView& block) {
            said = said_by(program, block);
            return said == Said::nothing;
        });
        return said;
    }

    [[nodiscard]] Said said_by(const Program& program, const BlockView& block) const {
        const auto& groups = program.control->groups;
        std::optional<double> code;
        std::size_t cancelled = 0;
        for (const BlockSetting& setting : block.settings) {
            if (!setting.value) continue;
            if (setting.group == group_) code = setting.value;
            // ROT alone ends all parts of the frame: they are cancelled by one word.
            const bool by_the_same_word = setting.group != group_ && !groups[group_].cancel_words.empty() &&
                                          groups[setting.group].cancel_words == groups[group_].cancel_words;
            cancelled += groups[setting.group].cancel == setting.value && !by_the_same_word ? 1U : 0U;
        }
        if (!code) return Said::nothing;
        return code == groups[group_].cancel && cancelled == 1 ? Said::cancelled : Said::otherwise;
    }

    const ProgramAnalysis& caller_;
    GroupId group_;
};

} // namespace

bool only_sets_modes(const Program& program) {
    const auto stores_for_others = [&](const Assign& assign) {
        const auto* variable = std::get_if<Variable>(&assign.target);
        if (variable == nullptr) return false;
        const Scope scope = program.control->spaces[variable->space].scope;
        return scope == Scope::shared || scope == Scope::retained;
    };
    const auto does_more = [&](const Effect& effect) {
        return std::visit(overloaded{
                              [&](const Assign& assign) { return stores_for_others(assign); },
                              [](const Motion&) { return true; },
                              [](const Call&) { return true; },
                              [](const ToolChange&) { return true; },
                              [](const UnreadableBlock&) { return true; },
                              [](const auto&) { return false; },
                          },
                          effect.what);
    };
    bool only_sets = true;
    for_each_block(program, [&](const BlockView& block) {
        only_sets &= !block.moves && std::ranges::none_of(program.effects_in(block.effects), does_more);
        return only_sets;
    });
    return only_sets;
}

bool callers_cancel(const ProgramAnalysis& analysis, GroupId group) {
    const auto [callers, all] = known_or_possible_callers(analysis);
    std::size_t left = most_looked_at;
    return all && !callers.empty() && std::ranges::all_of(callers, [&](const Caller& caller) {
               return Ends(analysis.workspace().programs()[caller.program], group).after(caller.effect, left);
           });
}

} // namespace maclint::queries
