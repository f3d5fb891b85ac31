//! Looks at the words that are given saved codes, and at what the program sets.
#include "rules/modal/restore_from_wrong_variable_finder.hpp"

#include "analyzer/dataflow/facts/call_made.hpp"
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/queries/modal/modal_parts.hpp"
#include "analyzer/queries/modal/own_settings.hpp"
#include "analyzer/queries/paths/feasible_paths.hpp"
#include "analyzer/queries/values/copies.hpp"
#include "analyzer/queries/values/origins.hpp"
#include "analyzer/source/budget.hpp"

#include <algorithm>

namespace maclint::rules {
namespace {

/// A G word with a copy of what was in force in a group when the program began.
struct PutBack {
    const dataflow::ModalWrite* write;
    const dataflow::Store* save;
    GroupId group;
};

bool is_code_group(const ModalGroup& group) {
    return group.letter == 'G' &&
           (group.restore_policy == RestorePolicy::state || group.restore_policy == RestorePolicy::motion ||
            group.restore_policy == RestorePolicy::offset);
}

std::vector<PutBack> find_put_back(const ProgramAnalysis& analysis) {
    std::vector<PutBack> all;
    for (const dataflow::ModalWrite& write : analysis.facts().all<dataflow::ModalWrite>()) {
        const auto variable = queries::plain_variable(analysis.program(), write.expression);
        if (write.stated || !variable) continue;
        const dataflow::Store* save = queries::only_store_of(analysis, *variable, write.value);
        if (save == nullptr) continue;
        const auto group = queries::saved_group(analysis, *save);
        if (group && queries::last_settings_before(analysis, save->node, *group).empty())
            all.push_back({&write, save, *group});
    }
    return all;
}

class MisplacedSaves {
  public:
    explicit MisplacedSaves(const ProgramAnalysis& analysis)
        : analysis_(analysis)
        , put_back_(find_put_back(analysis)) {}

    std::vector<MisplacedSave> run() const {
        std::vector<MisplacedSave> found;
        const auto add = [&](const PutBack& back, MisplacedSave::Kind kind,
                             const std::optional<Span>& other) {
            if (other && std::ranges::find(found, back.group, &MisplacedSave::group) == found.end())
                found.push_back({kind, back.write, back.save, back.group, *other});
        };
        for (const PutBack& back : put_back_) add(back, MisplacedSave::Kind::twice, other_save(back));
        for (const PutBack& back : put_back_) add(back, MisplacedSave::Kind::beside, code_beside(back));
        const auto left = put_back_.empty() ? std::nullopt : first_left();
        for (const PutBack& back : put_back_)
            if (left && !may_change(back.group)) add(back, MisplacedSave::Kind::unchanged, left);
        return found;
    }

  private:
    /// An earlier save of the same group in another variable, which a word on the same path puts back.
    [[nodiscard]] std::optional<Span> other_save(const PutBack& back) const {
        const auto found = std::ranges::find_if(put_back_, [&](const PutBack& other) {
            return Budget::allows() && other.group == back.group &&
                   !(other.save->variable == back.save->variable) && other.save->effect < back.save->effect &&
                   queries::can_follow(analysis_, other.save->node, back.save->node) &&
                   (other.write->node == back.write->node ||
                    queries::can_follow(analysis_, other.write->node, back.write->node) ||
                    queries::can_follow(analysis_, back.write->node, other.write->node));
        });
        return found == put_back_.end()
                   ? std::nullopt
                   : std::optional(analysis_.program().effects[found->save->effect].span);
    }

    /// A literal code of the same group in the block of the word.
    [[nodiscard]] std::optional<Span> code_beside(const PutBack& back) const {
        const Program& program = analysis_.program();
        for (const Effect& effect : program.effects_in(analysis_.graph().nodes[back.write->node].effects)) {
            const auto setting = setting_of(program, effect);
            if (setting && setting->value && setting->group == back.group) return effect.span;
        }
        return std::nullopt;
    }

    /// What changes a group that the program leaves changed at a return and saves nowhere: the motion mode,
    /// or another group at a code that is no custom.
    [[nodiscard]] std::optional<Span> first_left() const {
        const auto& groups = analysis_.control().groups;
        for (const dataflow::ExitState& exit : analysis_.facts().all<dataflow::ExitState>()) {
            if (exit.exit.kind != flow::ExitKind::returns) continue;
            for (std::size_t i = 0; i < groups.size(); ++i) {
                const auto group = static_cast<GroupId>(i);
                if (!is_code_group(groups[i]) || queries::saves_group(analysis_, group)) continue;
                const dataflow::ModalValue value = analysis_.data().modal(exit, group);
                for (const dataflow::ModalPart& part : value.parts)
                    if (part.origin != 0 && !queries::is_made_by_call(analysis_, part.origin) &&
                        (groups[i].role == ModalRole::motion
                             ? queries::own_code(analysis_, part).has_value()
                             : queries::is_switched_on(analysis_, groups[i], part)))
                        return queries::span_of_origin(analysis_, part.origin);
            }
        }
        return std::nullopt;
    }

    /// Whether a word of the program, or a program that it calls, may change the group.
    [[nodiscard]] bool may_change(GroupId group) const {
        bool found = false;
        for_each_block_that_sets(analysis_.program(), group, [&](const BlockView&) { found = true; });
        const auto is_other_write = [&](const dataflow::ModalWrite& write) {
            const bool puts_back = std::ranges::find(put_back_, &write, &PutBack::write) != put_back_.end();
            return !puts_back && (!write.group || *write.group == group) && !write.stated;
        };
        return found || std::ranges::any_of(analysis_.facts().all<dataflow::ModalWrite>(), is_other_write) ||
               std::ranges::any_of(analysis_.facts().all<dataflow::CallMade>(),
                                   [&](const dataflow::CallMade& call) {
                                       return queries::call_may_change(analysis_, call.effect, group);
                                   });
    }

    const ProgramAnalysis& analysis_;
    std::vector<PutBack> put_back_;
};

} // namespace

std::vector<MisplacedSave> find_misplaced_saves(const ProgramAnalysis& analysis) {
    return MisplacedSaves(analysis).run();
}

} // namespace maclint::rules
