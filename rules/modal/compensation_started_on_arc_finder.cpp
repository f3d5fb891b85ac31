//! Looks at the blocks that set the compensation.
#include "rules/modal/compensation_started_on_arc_finder.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/machine_words.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/own_settings.hpp"

#include <algorithm>
#include <variant>

namespace maclint::rules {
namespace {

/// The only code that the block's words give the group; nothing where it is computed, or given twice.
std::optional<double> only_code(const BlockView& block, GroupId group) {
    std::optional<double> code;
    std::size_t given = 0;
    for (const BlockSetting& setting : block.settings) {
        if (setting.group != group) continue;
        code = setting.value;
        ++given;
    }
    return given == 1 ? code : std::nullopt;
}

class Changes {
  public:
    Changes(const ProgramAnalysis& analysis, GroupId compensation, GroupId motion)
        : analysis_(analysis)
        , control_(analysis.control())
        , compensation_(compensation)
        , motion_(motion)
        , modes_at_(analysis) {}

    [[nodiscard]] std::optional<CompensationChange> in(const BlockView& block) {
        const auto code = only_code(block, compensation_);
        if (!code || !moves(block)) return std::nullopt;
        const queries::BlockModes modes = modes_at_(block);
        const queries::Modes motion = modes.with_words(motion_);
        const auto moved = motion.sure_code();
        const auto& circles = control_.groups[motion_].circles;
        if (!moved) return std::nullopt;
        const bool in_arc = std::ranges::find(circles, *moved) != circles.end();
        if (!in_arc && !(control_.machine_words != nullptr && control_.machine_words->side_by_off))
            return std::nullopt;
        const auto node = *analysis_.graph().node_of(block.span);
        const bool states_it = std::ranges::any_of(
            block.settings, [&](const BlockSetting& setting) { return setting.group == motion_; });
        const Stretch stretch{analysis_.graph().nodes[node].item, block.span};
        if (!states_it && !queries::modal_move_in(analysis_, stretch).relies) return std::nullopt;
        const queries::Modes before = modes.before(compensation_);
        auto kind = kind_of(*code, before, states_it);
        if (!kind) return std::nullopt;
        if (!in_arc) {
            if (kind != CompensationChange::Kind::over) return std::nullopt;
            kind = CompensationChange::Kind::side;
        }
        CompensationChange change{*kind, compensation_, *code, motion_, *moved, block.span, node, {}};
        const queries::Mode& begins = states_it ? before.possible.front() : motion.possible.front();
        if (begins.set_by != queries::Mode::SetBy::nobody) change.begins = begins;
        return change;
    }

  private:
    [[nodiscard]] bool moves(const BlockView& block) const {
        const auto effects = analysis_.program().effects_in(block.effects);
        return block.moves || std::ranges::any_of(effects, [](const Effect& effect) {
                   return std::holds_alternative<Motion>(effect.what);
               });
    }

    /// Whether the program finds compensation off: who switches it off himself lets nobody hand it to him.
    [[nodiscard]] bool begins_with_it(const queries::Modes& before) {
        const double off = *control_.groups[compensation_].cancel;
        const auto is_off_or_callers = [&](const queries::Mode& mode) {
            return mode.code ? *mode.code == off : mode.set_by == queries::Mode::SetBy::nobody;
        };
        return !before.unknown && !before.possible.empty() &&
               std::ranges::all_of(before.possible, is_off_or_callers) && switches_off();
    }

    [[nodiscard]] bool switches_off() {
        if (switches_off_) return *switches_off_;
        switches_off_ = false;
        for_each_block_that_sets(analysis_.program(), compensation_, [&](const BlockView& block) {
            *switches_off_ |= only_code(block, compensation_) == control_.groups[compensation_].cancel;
        });
        return *switches_off_;
    }

    [[nodiscard]] std::optional<CompensationChange::Kind> kind_of(double code, const queries::Modes& before,
                                                                  bool states_it) {
        using Kind = CompensationChange::Kind;
        const double off = *control_.groups[compensation_].cancel;
        if (before.sure_code() == off || (states_it && begins_with_it(before)))
            return code == off ? std::nullopt : std::optional(Kind::on);
        std::vector<double> on;
        for (const ModalMember& member : control_.groups[compensation_].members)
            if (member.number != off && member.number != code) on.push_back(member.number);
        if (!before.is_surely_one_of(on)) return std::nullopt;
        return code == off ? Kind::off : Kind::over;
    }

    const ProgramAnalysis& analysis_;
    const ControlModel& control_;
    GroupId compensation_, motion_;
    queries::ModesAt modes_at_;
    std::optional<bool> switches_off_; ///< in some block; nothing: not looked for
};

} // namespace

void for_each_compensation_change_in_arc(const ProgramAnalysis& analysis,
                                         const std::function<void(const CompensationChange&)>& visit) {
    const ControlModel& control = analysis.control();
    const auto compensation = control.group_with(ModalRole::cutter_compensation);
    const auto motion = control.group_with(ModalRole::motion);
    if (!compensation || !motion || !control.groups[*compensation].cancel) return;
    Changes changes(analysis, *compensation, *motion);
    for_each_block_that_sets(analysis.program(), *compensation, [&](const BlockView& block) {
        if (const auto change = changes.in(block)) visit(*change);
    });
}

} // namespace maclint::rules
