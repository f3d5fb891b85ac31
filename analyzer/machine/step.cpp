//! Runs a block: codes first, then the tool and its offsets, then the move.
#include "analyzer/machine/step.hpp"

#include "analyzer/machine/demands.hpp"
#include "analyzer/program/overloaded.hpp"
#include "analyzer/program/shop_demands.hpp"

#include <algorithm>
#include <cmath>

namespace maclint::machine {
namespace {

/// A position counts from elsewhere when one of these changes.
constexpr std::array of_coordinates = {
    ModalRole::work_offset,       ModalRole::local_offset,
    ModalRole::offset_suspension, ModalRole::units,
    ModalRole::scaling,           ModalRole::rotation,
    ModalRole::mirror_image,      ModalRole::tilted_plane,
    ModalRole::polar_coordinates, ModalRole::polar_interpolation,
};

constexpr std::size_t z_axis = 2;

bool is_zero(const Words& words, char letter) {
    const auto number = words.number(letter);
    return number && number->value == 0;
}

bool contains(std::span<const double> numbers, double number) {
    return std::ranges::find(numbers, number) != numbers.end();
}

} // namespace

Words::Words(std::span<const Word> words, const MachineWords& machine)
    : lengths_without_point_(machine.lengths_without_point) {
    if (!words.empty()) span_ = {words.front().span.begin, words.back().span.end};
    for (const Word& word : words) {
        only_count_ &= word.address == "P";
        if (!machine.radius_address.empty() && word.address == machine.radius_address)
            words_[index(machine.radius)] = &word;
        has_clamp_ |= !machine.clamp_address.empty() && word.address == machine.clamp_address;
        has_other_target_ |=
            std::ranges::find(machine.other_targets, word.address) != machine.other_targets.end();
        if (word.address.size() != 1 || word.address.front() < 'A' || word.address.front() > 'Z') continue;
        const Word*& first = words_[index(word.address.front())];
        if (first == nullptr) first = &word;
        if (word.address.front() != 'G' && word.address.front() != 'M') continue;
        const auto* literal = std::get_if<Literal>(&word.value);
        if (literal == nullptr)
            (word.address.front() == 'G' ? has_computed_code_ : has_computed_function_) = true;
        else
            (word.address.front() == 'G' ? g_codes_ : m_codes_).add(literal->value);
    }
}

std::optional<Number> Words::number(char letter) const {
    if (letter == 0 || !has(letter)) return std::nullopt;
    const Word& found = *word(letter);
    const auto* literal = std::get_if<Literal>(&found.value);
    if (literal == nullptr || found.absolute) return std::nullopt;
    return Number{literal->value, literal->decimal_point || lengths_without_point_, found.span};
}

std::optional<double> Words::absolute(char letter) const {
    if (letter == 0 || !has(letter) || !word(letter)->absolute) return std::nullopt;
    const auto* literal = std::get_if<Literal>(&word(letter)->value);
    return literal == nullptr ? std::nullopt : std::optional(literal->value);
}

bool Words::has_g(double code) const { return contains(g_codes(), code); }
bool Words::has_m(double code) const { return contains(m_codes(), code); }

bool Words::has_one_of(std::span<const double> wanted) const {
    return std::ranges::any_of(g_codes(), [&](double code) { return contains(wanted, code); });
}

std::optional<double> code_off(const ControlModel& control, ModalRole role) {
    const auto group = control.group_with(role);
    return group ? control.groups[*group].cancel : std::nullopt;
}

bool is_surely_on(const State& state, const ControlModel& control, ModalRole role) {
    return state.of(role).is_known() && state.of(role).value != code_off(control, role);
}

bool may_be_on(const State& state, const ControlModel& control, ModalRole role) {
    const Known& mode = state.of(role);
    return control.group_with(role) && !mode.is_callers() &&
           !(mode.is_known() && mode.value == code_off(control, role));
}

bool spindle_runs_into(const Step& step, const ControlModel& control) {
    const auto off = code_off(control, ModalRole::spindle);
    return off && is_surely_on(step.before, control, ModalRole::spindle) &&
           !step.before.of(ModalRole::spindle).by_call && !step.words.has_m(*off);
}

bool coolant_runs_into(const Step& step, const ControlModel& control) {
    const MachineWords& machine = *control.machine_words;
    const Known& coolant = step.before.coolant;
    return coolant.is_known() && !coolant.by_call && contains(machine.coolant_on, coolant.value) &&
           !step.words.has_m(machine.coolant_off);
}

bool counts_from_elsewhere(const State& state, const ControlModel& control) {
    constexpr std::array roles = {ModalRole::local_offset,       ModalRole::scaling,
                                  ModalRole::rotation,           ModalRole::mirror_image,
                                  ModalRole::polar_coordinates,  ModalRole::tilted_plane,
                                  ModalRole::polar_interpolation};
    return std::ranges::any_of(roles, [&](ModalRole role) { return may_be_on(state, control, role); });
}

bool moves_on_circle(const Step& step, const ControlModel& control) {
    const auto motion = control.group_with(ModalRole::motion);
    const Known& mode = step.after.of(ModalRole::motion);
    return motion && mode.is_known() && step.move == Move::feed &&
           contains(control.groups[*motion].circles, mode.value);
}

bool moves_on_shape(const Step& step, const ControlModel& control) {
    return step.move == Move::cycle || moves_on_circle(step, control);
}

bool takes_feed(const Step& step, const MachineWords& machine) {
    if (step.words.has_one_of(machine.returning)) return false;
    const Known& motion = step.after.of(ModalRole::motion);
    return !motion.is_known() || !contains(machine.threads, motion.value);
}

bool sets(const ControlModel& control, const BlockView& block, ModalRole role) {
    const auto group = control.group_with(role);
    return group && std::ranges::any_of(block.settings,
                                        [&](const BlockSetting& setting) { return setting.group == *group; });
}

Stepper::Stepper(const Program& program, const MachineWords& machine)
    : program_(&program)
    , control_(program.control)
    , machine_(&machine)
    , demands_(control_->demands != nullptr && !control_->demands->blocks.empty() ? control_->demands.get()
                                                                                  : nullptr)
    , stored_(std::make_shared<const StoredVariables>(program))
    , spindle_(control_->group_with(ModalRole::spindle))
    , cycle_(control_->group_with(ModalRole::cycle))
    , has_distance_(control_->group_with(ModalRole::distance).has_value())
    , has_level_(control_->group_with(ModalRole::return_level).has_value()) {
    spindle_off_ = code_off(*control_, ModalRole::spindle);
    cycle_off_ = code_off(*control_, ModalRole::cycle);
}

void Stepper::begin(const BlockView& block) {
    move_ = Move::none;
    axes_ = {};
    changes_tool_ = calls_ = passes_words_ = without_feed_ = to_reference_ = has_applied_code_ = false;
    moves_ = block.moves;
}

void Stepper::apply(State& state, const BlockView& block, const Words& words) {
    apply_effects(state, block, words);
    if (words.has_computed_function() || (words.has_computed_code() && !has_applied_code_)) {
        state.forget_modes();
        state.forget_position();
    }
    apply_functions(state, words, block.span.begin);
    apply_settings(state, block);
    if (words.has('S') && words.has_one_of(machine_->clamping)) {
        const auto speed = words.number('S');
        state.speed_clamp = speed ? Known::of(speed->value, block.span.begin) : Known::nothing();
    }
    if (words.has_clamp()) state.speed_clamp = Known::nothing();
    if (!passes_words_) { // else H and T are arguments
        change_tool(state, block, words);
        choose_offsets(state, block, words);
    }
    if (words.has_one_of(machine_->resetting)) state.forget_position();
    if (moves_ && words.only_count())
        run_blocks_elsewhere(state);
    else if (moves_)
        move(state, words, block.span.begin);
    if (words.has_other_target()) state.forget_position();
    watch_tapping(state, block, words);
    run_profile(state, block, words);
    if (demands_ != nullptr) watch_demands(state, words);
}

/// G#1 after #1=#4003 sets the group that #1 holds a code of, to one that nobody knows here. Any other may
/// set whatever it likes, but for a modal macro call, which names its program.
void Stepper::apply_computed_code(State& state, ExpressionId code, const Words& words) {
    has_applied_code_ = true;
    const auto group = stored_->saved_group(*program_, code);
    const ModalRole role = group ? control_->groups[*group].role : ModalRole::other;
    if (!group) {
        const Known calls = state.of(ModalRole::macro_call);
        state.forget_modes();
        if (!words.has('P')) state.of(ModalRole::macro_call) = calls;
    }
    if (!group || std::ranges::find(of_coordinates, role) != of_coordinates.end()) state.forget_position();
    if (role != ModalRole::other) state.of(role) = Known::nothing();
}

void Stepper::watch_demands(State& state, const Words& words) const {
    const bool begins_anew = changes_tool_ || move_ == Move::feed || move_ == Move::cycle;
    for (std::size_t i = 0; i < demands_->blocks.size(); ++i) {
        const DemandedBlock& block = demands_->blocks[i];
        const std::uint64_t bit = std::uint64_t{1} << i;
        if (begins_anew && block.place != DemandedBlock::Place::start) state.demands_met &= ~bit;
        if (says(words, state, *control_, block)) state.demands_met |= bit;
    }
}

/// A block without words of its own moves by blocks that stand elsewhere: nobody can say where they end.
void Stepper::run_blocks_elsewhere(State& state) {
    move_ = Move::unknown;
    state.forget_position();
    for (Known* known : {&state.moved_in_z, &state.plunged, &state.cut, &state.cycle_level, &state.coolant})
        *known = Known::nothing();
}

/// The blocks of a profile stand behind the cycle that reads them. The control goes on behind the last, with
/// the tool where it was before.
void Stepper::run_profile(State& state, const BlockView& block, const Words& words) const {
    const auto last = words.number('Q');
    if (words.has_one_of(machine_->returning) && words.has('P') && last) {
        state.cut = Known::of(1, block.span.begin);
        if (words.has_one_of(machine_->roughing)) {
            state.profile_end = Known::of(last->value, block.span.begin);
            state.cycle_start = before_.position;
        }
        return;
    }
    if (!block.number || *block.number == 0 || !state.profile_end.is(static_cast<double>(*block.number)))
        return;
    state.position = state.cycle_start;
    state.profile_end = Known::of(0, block.span.begin);
}

void Stepper::apply_effects(State& state, const BlockView& block, const Words& words) {
    for (const Effect& effect : program_->effects_in(block.effects))
        std::visit(
            overloaded{
                [&](const Motion& motion) {
                    moves_ = true;
                    without_feed_ |= motion.without_feed || motion.to_reference;
                    to_reference_ |= motion.to_reference;
                },
                [&](const ToolChange& change) { changes_tool_ |= change.kind == ToolChange::Kind::change; },
                [&](const Call& call) {
                    calls_ = true;
                    passes_words_ |= call.arguments.count != 0;
                },
                [&](const Stop&) { // behind a stop somebody may push a part to the tool
                    if (state.plunged.is_known()) state.plunged = Known::of(0, block.span.begin);
                },
                [&](const UnreadableBlock&) { state.forget(); },
                [&](const SetModal& set) {
                    if (!set.group) apply_computed_code(state, set.value, words);
                },
                [](const auto&) {},
            },
            effect.what);
}

/// A function of the machine that no table knows may start its spindle or coolant, or stop it.
void Stepper::apply_functions(State& state, const Words& words, Offset here) const {
    for (const double function : words.m_codes()) {
        const bool is_of_coolant =
            contains(machine_->coolant_on, function) || function == machine_->coolant_off;
        if (is_of_coolant) state.coolant = Known::of(function, here);
        if (contains(machine_->aside, function) ||
            (spindle_ && control_->group_of('M', function) == spindle_))
            continue;
        state.of(ModalRole::spindle) = Known::nothing();
        if (!is_of_coolant) state.coolant = Known::nothing();
    }
    if (contains(words.m_codes(), machine_->rigid_tapping)) state.rigid_tapping = Known::of(1, here);
}

void Stepper::apply_settings(State& state, const BlockView& block) const {
    for (const BlockSetting setting : block.settings) {
        const ModalRole role = control_->groups[setting.group].role;
        if (role == ModalRole::other) continue;
        Known& mode = state.of(role);
        const bool changes = !setting.value || !mode.is(*setting.value);
        if (changes && std::ranges::find(of_coordinates, role) != of_coordinates.end())
            state.forget_position();
        if (role == ModalRole::distance)
            state.distance_for_return = Known::of(to_reference_ ? 1 : 0, block.span.begin);
        if (role == ModalRole::spindle && changes) state.plunged = Known::of(0, block.span.begin);
        // Where a value is given again, the block that gave it first is named.
        if (changes || mode.by_call)
            mode = setting.value ? Known::of(*setting.value, block.span.begin) : Known::nothing();
        for (const EndedGroup& ended : control_->ended_groups)
            if (ended.by == setting.group)
                state.of(control_->groups[ended.group].role) = Known::of(ended.code, block.span.begin);
    }
}

void Stepper::change_tool(State& state, const BlockView& block, const Words& words) const {
    const auto tool = words.number(machine_->tool);
    const Offset here = block.span.begin;
    if (!changes_tool_) {
        if (words.has(machine_->tool)) state.prepared = chosen(words, machine_->tool, here);
        return;
    }
    constexpr double offsets = 100;
    if (machine_->tool_word_holds_offset && tool && state.tool.is(std::floor(tool->value / offsets)) &&
        std::fmod(tool->value, offsets) == 0) {
        state.length_offset = Known::of(0, here); // T0100 behind T0101: nothing turns
        return;
    }
    state.changed = Known::of(0, here);
    state.moved_in_z = state.plunged = state.cut = Known::of(0, here);
    state.forget_position();
    if (machine_->tool_word_holds_offset) {
        if (!tool || tool->value < offsets) {
            state.tool = state.length_offset = Known::nothing();
            return;
        }
        state.tool = Known::of(std::floor(tool->value / offsets), here);
        state.length_offset = Known::of(std::fmod(tool->value, offsets), here);
        return;
    }
    // `M6 T2`: where another tool was prepared, some machines change to that one and prepare this one.
    const bool is_doubtful = tool && state.prepared.is_known() && !state.prepared.is(none_prepared) &&
                             !state.prepared.is(tool->value);
    if (is_doubtful)
        state.tool = Known::nothing();
    else
        state.tool = words.has(machine_->tool) ? chosen(words, machine_->tool, here) : state.prepared;
    if (state.tool.is(none_prepared)) state.tool = Known::nothing(); // it brings the one before back
    if (state.tool.is_known()) state.tool.block = here;
    state.prepared = Known::of(none_prepared, here);
    state.rigid_tapping = Known::of(0, here);
    if (!state.cutter_offset.is(0)) state.cutter_offset = Known::of(not_since_change, here);
    if (!state.length_offset.is(0)) {
        state.choose_length_offset(Known::of(not_since_change, here));
        state.without_offset_since = here;
    }
    if (machine_->change_stops_spindle && spindle_off_)
        state.of(ModalRole::spindle) = Known::of(*spindle_off_, here);
}

/// No move, no speed and no plane may stand between the function and its cycle.
void Stepper::watch_tapping(State& state, const BlockView& block, const Words& words) const {
    const Offset here = block.span.begin;
    if (!state.rigid_tapping.is(1) || state.rigid_tapping.block == here) return;
    if (words.has_one_of(machine_->tapping_cycles)) {
        state.rigid_tapping = Known::of(0, here);
        return;
    }
    const bool moves = move_ != Move::none && move_ != Move::elsewhere;
    if (moves || words.has('S') || sets(*control_, block, ModalRole::plane))
        state.rigid_tapping = Known::of(2, here);
}

void Stepper::choose_offsets(State& state, const BlockView& block, const Words& words) const {
    const Offset here = block.span.begin;
    if (machine_->length_offset != 0 && words.has(machine_->length_offset))
        state.choose_length_offset(chosen(words, machine_->length_offset, here));
    if (machine_->cutter_offset != 0 && words.has(machine_->cutter_offset))
        state.cutter_offset = chosen(words, machine_->cutter_offset, here);
}

/// The number of a word that chooses something: as it stands there, or as a call passes it.
Known Stepper::chosen(const Words& words, char letter, Offset here) const {
    if (const auto number = words.number(letter)) return Known::of(number->value, here);
    const auto* value = std::get_if<ExpressionId>(&words.word(letter)->value);
    const auto passed = value == nullptr ? std::nullopt : stored_->passed(*program_, *value);
    return passed ? Known::passed_in(*passed, here) : Known::nothing();
}

Move Stepper::kind_of_move(const State& state, const Words& words) const {
    if (without_feed_ || words.has_one_of(machine_->of_machine)) return Move::elsewhere;
    if (words.has_one_of(machine_->returning)) return Move::cycle;
    const Known& cycle = state.of(ModalRole::cycle);
    if (cycle_ && cycle.is_known() && cycle.value != cycle_off_) return Move::cycle;
    if (cycle_ && cycle.kind == Known::Kind::unknown) return Move::unknown;
    const Known& motion = state.of(ModalRole::motion);
    if (!motion.is_known()) return Move::unknown;
    if (motion.is(machine_->rapid)) return Move::rapid;
    return contains(machine_->passes, motion.value) ? Move::cycle : Move::feed;
}

std::optional<double> Stepper::target(const State& state, const Words& words, std::size_t axis) const {
    const auto usable = [](const std::optional<Number>& number) { return number && number->is_length(); };
    const auto absolute = words.number(machine_->axes[axis]);
    const auto increment = words.number(machine_->increments[axis]);
    const double from = state.position[axis];
    if (machine_->increments[axis] != 0 && words.has(machine_->increments[axis]))
        return usable(increment) ? from + increment->value : nowhere;
    if (machine_->axes[axis] == 0 || !words.has(machine_->axes[axis])) return std::nullopt;
    if (!usable(absolute)) return nowhere;
    if (!has_distance_) return absolute->value;
    const Known& distance = state.of(ModalRole::distance);
    if (!distance.is_known()) return nowhere;
    return distance.is(machine_->absolute) ? absolute->value : from + absolute->value;
}

/// U0 W0 beside the code of a straight cut: the axes stay where they are. A circle may be a whole one.
bool Stepper::stays_there(const State& state, const Words& words) const {
    bool stays = false;
    for (std::size_t axis = 0; axis < state.position.size(); ++axis) {
        const char letter = machine_->axes[axis], increment = machine_->increments[axis];
        if (letter != 0 && words.has(letter)) {
            const bool counts_on = has_distance_ && state.of(ModalRole::distance).is_known() &&
                                   !state.of(ModalRole::distance).is(machine_->absolute);
            if (!counts_on || !is_zero(words, letter)) return false;
            stays = true;
        }
        if (increment != 0 && words.has(increment)) {
            if (!is_zero(words, increment)) return false;
            stays = true;
        }
    }
    if (!stays) return false;
    const auto motion = control_->group_with(ModalRole::motion);
    return motion && !contains(control_->groups[*motion].circles, state.of(ModalRole::motion).value);
}

void Stepper::move(State& state, const Words& words, Offset here) {
    move_ = kind_of_move(state, words);
    const double z_before = state.position[z_axis];
    const bool is_turning_cycle =
        move_ == Move::cycle && (words.has_one_of(machine_->returning) || !has_level_);
    if ((move_ == Move::feed || is_turning_cycle) && !words.has_other_target() && stays_there(state, words)) {
        move_ = Move::none;
        return;
    }
    for (std::size_t axis = 0; axis < state.position.size(); ++axis) {
        const std::optional<double> to = target(state, words, axis);
        if (!to) continue;
        axes_[axis] = true;
        state.is_moved[axis] = true;
        if (is_turning_cycle) continue;
        // In a canned cycle Z is the depth; the tool comes back to where the return level says.
        const bool is_depth = move_ == Move::cycle && axis == z_axis;
        if (is_depth) continue;
        state.position[axis] = move_ == Move::elsewhere || move_ == Move::unknown ? nowhere : *to;
    }
    if (axes_[z_axis] && state.moved_in_z.is_known()) state.moved_in_z = Known::of(1, here);
    if (move_ == Move::feed || move_ == Move::cycle) state.cut = Known::of(1, here);
    if (axes_[z_axis] && state.position[z_axis] > z_before) state.plunged = Known::of(0, here);
    if (move_ == Move::feed && axes_[z_axis] && state.position[z_axis] < z_before)
        state.plunged = Known::of(1, here);
    if (move_ == Move::cycle && !is_turning_cycle) move_in_cycle(state, words);
}

void Stepper::move_in_cycle(State& state, const Words& words) const {
    if (words.has(machine_->radius)) {
        const auto level = words.number(machine_->radius);
        const bool is_absolute = state.of(ModalRole::distance).is(machine_->absolute);
        state.cycle_level = level && is_absolute && level->is_length()
                                ? Known::of(level->value, words.word(machine_->radius)->span.begin)
                                : Known::nothing();
    }
    const Known& level = state.of(ModalRole::return_level);
    if (level.is(machine_->to_level))
        state.position[z_axis] = state.cycle_level.is_known() ? state.cycle_level.value : nowhere;
    else if (!level.is(machine_->to_start))
        state.position[z_axis] = nowhere;
}

} // namespace maclint::machine
