//! Counts over the steps of a program.
#include "analyzer/machine/habits.hpp"

#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace maclint::machine {
namespace {

/// Its centre or radius and its ends do not make a circle.
bool has_odd_numbers(const Arc& arc) {
    return arc.fault == ArcFault::radii || arc.fault == ArcFault::chord ||
           arc.fault == ArcFault::centre_at_start;
}

} // namespace

void Habits::see(const Step& step, const Program& program) {
    const ControlModel& control = *program.control;
    see_arc(step, program);
    kept_modes_.see(step, control);
    lifts_.see(step);
    constexpr ModalRole length_mode = ModalRole::length_compensation;
    if (step.before.of(length_mode).is_known() && step.after.of(length_mode).is_known() &&
        step.before.of(length_mode).value != step.after.of(length_mode).value &&
        !is_surely_on(step.after, control, length_mode))
        last_end_of_length_offset_ = step.block.span.begin;
    moves_ = moves_ || step.move != Move::none;
    has_shapes_ = has_shapes_ || moves_on_shape(step, control);
    if (step.changes_tool) {
        const Known& offset = step.before.length_offset;
        const bool had_one = offset.is_known() && offset.value > 0 && step.before.cut.is(1);
        if (changes_ == 0 && had_one) ++tools_with_length_offset_; // the tool of the start
        ++changes_;
        waits_for_offset_ = waits_for_start_ = true;
        see_change(step, control);
    }
    const Known& length = step.after.length_offset;
    if (length.is_known() && length.value > 0 && length.block == step.block.span.begin) {
        if (waits_for_offset_) ++tools_with_length_offset_;
        waits_for_offset_ = false;
        if (step.after.tool.is_known()) ++pairs_[{step.after.tool.value, length.value}];
    }
    const bool turns = is_surely_on(step.after, control, ModalRole::spindle);
    if (turns && step.after.of(ModalRole::spindle).block == step.block.span.begin) {
        turns_spindle_ = true;
        if (waits_for_start_) ++changes_with_start_;
        waits_for_start_ = false;
    }
    gives_feed_ = gives_feed_ || step.words.has('F');
    const auto speed = step.words.number('S');
    gives_speed_ = gives_speed_ || (step.words.has('S') && !(speed && speed->value == 0));
    names_tools_ = names_tools_ || step.words.has(control.machine_words->tool);
    if (control.machine_words->tool_word_holds_offset) see_lathe(step, control);
}

void Habits::see_change(const Step& step, const ControlModel& control) {
    if (!step.before.cut.is(1)) return;
    const auto count = [](AtChanges& changes, bool is_off, bool is_running) {
        changes.off += is_off ? 1 : 0;
        changes.running += is_running ? 1 : 0;
    };
    const Known& spindle = step.before.of(ModalRole::spindle);
    const auto spindle_off = code_off(control, ModalRole::spindle);
    const bool stops = spindle_off && (spindle.is(*spindle_off) || step.words.has_m(*spindle_off));
    count(spindle_at_changes_, stops, spindle_runs_into(step, control));
    const double coolant_off = control.machine_words->coolant_off;
    const bool closes = step.before.coolant.is(coolant_off) || step.words.has_m(coolant_off);
    count(coolant_at_changes_, closes, coolant_runs_into(step, control));
}

void Habits::see_arc(const Step& step, const Program& program) {
    std::optional<Arc> arc = arc_of(step, program);
    if (!arc) return;
    ++arcs_;
    if (has_odd_numbers(*arc)) ++odd_arcs_;
    if (arc->fault != ArcFault::none) wrong_arcs_.insert({step.block.span.begin, std::move(*arc)});
}

const Arc* Habits::wrong_arc(Offset block) const {
    const auto found = wrong_arcs_.find(block);
    if (found == wrong_arcs_.end()) return nullptr;
    // Where so many are wrong, the numbers mean something else.
    constexpr std::size_t some = 4, part = 4;
    if (has_odd_numbers(found->second) && odd_arcs_ >= some && odd_arcs_ * part > arcs_) return nullptr;
    return &found->second;
}

void Habits::see_lathe(const Step& step, const ControlModel& control) {
    constexpr std::size_t x = 0, z = 2;
    constexpr double far = 20; // mm
    const bool is_inch = step.before.of(ModalRole::units).is(control.machine_words->inch);
    if (step.changes_tool && step.before.cut.is(1)) {
        const double height = step.before.position[z] * (is_inch ? millimetres_of_inch : 1);
        if (std::isnan(height) || height >= far) ++retreats_;
    }
    if (step.move != Move::feed && step.move != Move::cycle) return;
    for (const double place : {step.before.position[x], step.after.position[x]})
        if (!std::isnan(place)) widest_cut_ = std::max(place, widest_cut_.value_or(place));
    const Known& tool = step.after.tool;
    const Known& offset = step.after.length_offset;
    if (!tool.is_known() || !offset.is_known()) return;
    ++(offset.value > 0 ? cuts_[tool.value].with_offset : cuts_[tool.value].without);
}

bool Habits::cuts_with_offset(double tool) const {
    const auto found = cuts_.find(tool);
    return found != cuts_.end() && found->second.with_offset > 0;
}

int Habits::others_with_offset(double tool) const {
    return static_cast<int>(std::ranges::count_if(
        cuts_, [&](const auto& one) { return one.first != tool && one.second.with_offset > 0; }));
}

bool Habits::have_all_others_offset(double tool) const {
    return std::ranges::none_of(cuts_,
                                [&](const auto& one) { return one.first != tool && one.second.without > 0; });
}

int Habits::uses(double tool, double offset) const {
    const auto found = pairs_.find({tool, offset});
    return found == pairs_.end() ? 0 : found->second;
}

std::optional<double> Habits::difference_beside(double tool) const {
    std::optional<double> difference;
    for (const auto& [pair, count] : pairs_) {
        if (pair.first == tool) continue;
        if (difference && *difference != pair.second - pair.first) return std::nullopt;
        difference = pair.second - pair.first;
    }
    return difference;
}

int Habits::tools() const {
    std::set<double> tools;
    for (const auto& [pair, count] : pairs_) tools.insert(pair.first);
    return static_cast<int>(tools.size());
}

bool Habits::has_tool(double tool) const {
    const auto first = pairs_.lower_bound({tool, 0});
    return first != pairs_.end() && first->first.first == tool;
}

bool Habits::has_several_offsets(double tool) const {
    int offsets = 0;
    for (const auto& [pair, count] : pairs_) offsets += pair.first == tool ? 1 : 0;
    return offsets > 1;
}

} // namespace maclint::machine
