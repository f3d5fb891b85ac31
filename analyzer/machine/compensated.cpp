//! Follows the compensation from block to block in the order of the text.
#include "analyzer/machine/compensated.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace maclint::machine {
namespace {

/// The code of compensation that is surely on, by a block of the program.
const Known* in_force(const State& state, const ControlModel& control) {
    constexpr ModalRole role = ModalRole::cutter_compensation;
    return is_surely_on(state, control, role) ? &state.of(role) : nullptr;
}

/// Whether the block moves in the plane of the compensation, or may do so.
bool moves_in_plane(const Step& step, const ControlModel& control) {
    const auto plane = control.group_with(ModalRole::plane);
    const bool is_in_z_x_or_y_z =
        plane && step.after.of(ModalRole::plane).kind != Known::Kind::callers &&
        !step.after.of(ModalRole::plane).is(control.groups[*plane].members.front().number);
    const bool is_lathe = control.machine_words->x_is_diameter;
    return step.axes[0] || step.axes[1] || (step.axes[2] && (is_lathe || is_in_z_x_or_y_z)) ||
           step.words.has_other_target() ||
           step.words.has_one_of(control.machine_words->returning); // the moves of a profile
}

bool has_words(const Words& words) {
    for (char letter = 'A'; letter <= 'Z'; ++letter)
        if (words.has(letter) && letter != 'N' && letter != 'O') return true;
    return false;
}

/// Whether the program switches compensation on at all.
bool has_compensation(const Program& program) {
    const auto group = program.control->group_with(ModalRole::cutter_compensation);
    if (!group) return false;
    bool is_found = false;
    for_each_block_that_sets(program, *group, [&](const BlockView& block) {
        for (const BlockSetting setting : block.settings)
            is_found |= setting.group == *group && setting.value &&
                        *setting.value != program.control->groups[*group].cancel;
    });
    return is_found;
}

/// A stretch from the block that switches the compensation on.
struct Stretch {
    Span begins, ends;
    double code;
    bool moves, has_end;
};

} // namespace

std::vector<CompensationWithoutMove> compensation_without_move(const Program& program, const States& states) {
    if (!has_compensation(program)) return {};
    std::map<Offset, Stretch> stretches;
    const ControlModel& control = *program.control;
    states.for_each_step([&](const Step& step) {
        if (const Known* code = in_force(step.after, control)) {
            const auto [found, is_new] = stretches.try_emplace(
                code->block, Stretch{step.block.span, step.block.span, code->value, false, false});
            found->second.moves |= step.calls || step.move == Move::cycle || step.move == Move::unknown ||
                                   moves_in_plane(step, control);
        }
        const Known* before = in_force(step.before, control);
        if (before == nullptr) return;
        const auto found = stretches.find(before->block);
        if (found == stretches.end()) return;
        const Known* after = in_force(step.after, control);
        if (after != nullptr && after->block == before->block && !step.changes_tool) return;
        found->second.ends = step.block.span;
        found->second.has_end = true;
        // The other side, or its end in a move, is a move of this one too.
        found->second.moves |= step.after.of(ModalRole::cutter_compensation).kind == Known::Kind::unknown;
    });
    std::vector<CompensationWithoutMove> found;
    for (const auto& [block, stretch] : stretches)
        if (stretch.has_end && !stretch.moves && stretch.begins.begin == block)
            found.push_back({stretch.begins, stretch.code, stretch.ends});
    return found;
}

std::vector<StandingBlocks> standing_blocks(const Program& program, const States& states) {
    if (!has_compensation(program)) return {};
    const ControlModel& control = *program.control;
    std::vector<StandingBlocks> found;
    std::optional<Offset> moved_under; ///< the compensation under which the last moves were
    int moves = 0;                     ///< so many: the first leads to the path
    std::optional<StandingBlocks> standing;
    states.for_each_step([&](const Step& step) {
        const Known* code = in_force(step.after, control);
        const Known* before = in_force(step.before, control);
        if (code == nullptr || step.calls || step.move == Move::elsewhere ||
            (before != nullptr && before->block != code->block)) {
            moved_under.reset();
            standing.reset();
            return;
        }
        if (moves_in_plane(step, control)) {
            if (moved_under != code->block) moves = 0;
            if (standing && moves > 1) {
                standing->next = step.block.span;
                found.push_back(*standing);
            }
            moved_under = code->block;
            ++moves;
            standing.reset();
        } else if (moved_under == code->block && has_words(step.words)) {
            if (!standing) standing = StandingBlocks{step.block.span, {}, 0, {}, code->value};
            standing->last = step.block.span;
            ++standing->count;
        }
    });
    return found;
}

} // namespace maclint::machine
