//! Puts the state in front of a node and the words of its blocks together.
#include "analyzer/queries/modal/modes_at.hpp"

#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/values/origins.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>

namespace maclint::queries {
namespace {

/// Whether an effect, or one under its condition, may set the group otherwise than setting_of says.
bool may_set(const Program& program, const Effect& effect, GroupId group) {
    if (const auto* set = std::get_if<SetModal>(&effect.what))
        return !set->group && set->letter == program.control->groups[group].letter;
    if (const auto* guarded = std::get_if<Guarded>(&effect.what))
        return std::ranges::any_of(program.effects_in(guarded->effects), [&](const Effect& inner) {
            const auto setting = setting_of(program, inner);
            return setting ? setting->group == group : may_set(program, inner, group);
        });
    return std::holds_alternative<UnreadableBlock>(effect.what);
}

bool is_modal_call(const ControlModel& control, std::optional<double> code) {
    return std::ranges::any_of(control.calls, [&](const CallKind& kind) {
        return kind.trigger != CallTrigger::once && kind.modal_code == code;
    });
}

} // namespace

Span span_of(const ProgramAnalysis& analysis, const Mode& mode) {
    return mode.block.empty() ? span_of_origin(analysis, mode.origin) : mode.block;
}

std::optional<double> Modes::sure_code() const {
    if (unknown || possible.empty()) return std::nullopt;
    const std::optional<double> code = possible.front().code;
    return std::ranges::all_of(possible, [&](const Mode& mode) { return mode.code == code; }) ? code
                                                                                              : std::nullopt;
}

bool Modes::is_surely_one_of(std::span<const double> codes) const {
    return !unknown && !possible.empty() && std::ranges::all_of(possible, [&](const Mode& mode) {
        return mode.code && std::ranges::find(codes, *mode.code) != codes.end();
    });
}

bool Modes::can_be(double code) const {
    return std::ranges::any_of(possible, [&](const Mode& mode) { return mode.code == code; });
}

bool BlockModes::reached() const { return modes_->state_ != nullptr; }
Modes BlockModes::before(GroupId group) const { return modes_->before(*block_, group); }
Modes BlockModes::with_words(GroupId group) const { return modes_->with_words(*block_, group); }

ModesAt::ModesAt(const ProgramAnalysis& analysis)
    : analysis_(analysis)
    , ended_groups_(analysis.control().ended_groups)
    , modal_call_group_(analysis.control().group_with(ModalRole::macro_call))
    , at_node_(analysis.control().groups.size())
    , set_(analysis.control().groups.size()) {}

BlockModes ModesAt::operator()(const BlockView& block) {
    const bool goes_on = node_ && analysis_.graph().nodes[*node_].is_run && read_to_ <= block.span.begin &&
                         block.span.end <= analysis_.graph().nodes[*node_].part.end;
    if (!goes_on) enter(analysis_.graph().node_of(block.span));
    return {*this, block};
}

void ModesAt::enter(std::optional<flow::NodeId> node) {
    ++visit_;
    node_ = node;
    state_ = nullptr;
    moved_ = false;
    last_block_ = {};
    if (!node) return;
    read_to_ = analysis_.graph().nodes[*node].part.begin;
    if (!analysis_.data().reached(*node)) return;
    const auto states = analysis_.facts().all<dataflow::BeforeNode>();
    state_ = &*std::prev(std::ranges::upper_bound(states, *node, {}, &dataflow::BeforeNode::node));
}

/// What is known in front of the node.
const Modes& ModesAt::before_node(GroupId group) {
    AtNode& known = at_node_[group];
    if (known.visit == visit_) return known.modes;
    known = {visit_, {}};
    const dataflow::ModalValue value = analysis_.data().modal(state_->state, *node_, group);
    known.modes.unknown = value.unknown;
    for (const dataflow::ModalPart& part : value.parts) known.modes.possible.push_back(mode_of(group, part));
    return known.modes;
}

Mode ModesAt::mode_of(GroupId group, const dataflow::ModalPart& part) const {
    if (part.origin == 0)
        return {analysis_.data().table().number_of(part.symbol), Mode::SetBy::nobody, 0, part.origin};
    const Program& program = analysis_.program();
    const auto effect = effect_of_origin(analysis_, part.origin);
    const auto* call = effect ? std::get_if<Call>(&program.effects[*effect].what) : nullptr;
    const bool lasts = call != nullptr && group == modal_call_group_ &&
                       program.control->calls[call->kind].trigger != CallTrigger::once;
    Mode mode{analysis_.data().table().number_of(part.symbol),
              call == nullptr || lasts ? Mode::SetBy::word : Mode::SetBy::call,
              node_of_origin(analysis_, part.origin), part.origin};
    // A word that gives the code which the caller is known to have.
    if (!mode.code && analysis_.data().table().entry_group_of(part.symbol) == group) {
        const auto setting = effect ? setting_of(program, program.effects[*effect])
                                    : last_setting_in(analysis_, mode.node, group);
        if (setting && setting->group == group) mode.code = setting->value;
    }
    return mode;
}

/// Whether a block of the run can set the group.
bool ModesAt::is_set_in_node(GroupId group) const {
    const Program& program = analysis_.program();
    const auto& run = std::get<PlainRun>(program.items[analysis_.graph().nodes[*node_].item]);
    const auto net = std::span(program.settings).subspan(run.net.first, run.net.count);
    return std::ranges::any_of(net, [&](const ModalSetting& setting) {
        return setting.group == group || end_of(group, setting.group) != nullptr;
    });
}

/// Whether a program that moves of the run call may change the group.
bool ModesAt::calls_may_change(GroupId group) {
    if (!modal_call_group_ || group == *modal_call_group_) return false;
    return std::ranges::any_of(before_node(*modal_call_group_).possible, [&](const Mode& mode) {
        const auto effect = effect_of_origin(analysis_, mode.origin);
        if (!effect || !std::holds_alternative<Call>(analysis_.program().effects[*effect].what)) return false;
        return mode.set_by == Mode::SetBy::call ? is_modal_call(analysis_.control(), mode.code)
                                                : call_may_change(analysis_, *effect, group);
    });
}

Modes ModesAt::before(const BlockView& block, GroupId group) {
    if (state_ == nullptr) return {};
    const flow::Node& node = analysis_.graph().nodes[*node_];
    if (!node.is_run || block.span.begin == node.part.begin) return before_node(group);
    const bool may_be_called = calls_may_change(group);
    const bool may_be_set = is_set_in_node(group);
    if (!may_be_called && !may_be_set) return before_node(group);
    read_up_to(block);
    const Set& set = set_[group];
    Modes modes = set.visit == visit_ ? set_here(set.code, set.block) : before_node(group);
    modes.unknown |= moved_ && may_be_called;
    return modes;
}

Modes ModesAt::with_words(const BlockView& block, GroupId group) {
    if (state_ == nullptr) return {};
    // What was in force before is not asked where a word says what is from here on.
    std::optional<Modes> set;
    std::size_t computed = 0; // words after that, which are ignored where their variables are vacant
    bool may_be_ended = false;
    for (const BlockSetting& setting : block.settings) {
        std::optional<double> code;
        if (setting.group == group) {
            code = setting.value;
            computed += code ? 0U : 1U;
        } else if (const EndedGroup* ended = end_of(group, setting.group)) {
            if (setting.value) code = ended->code;
            may_be_ended |= !code;
        }
        if (!code) continue;
        set = set_here(*code, block.span);
        computed = 0;
        may_be_ended = false;
    }
    Modes modes = set ? *std::move(set) : before(block, group);
    for (; computed != 0; --computed)
        modes.possible.push_back({std::nullopt, Mode::SetBy::word, *node_, 0, block.span});
    modes.unknown |=
        may_be_ended ||
        std::ranges::any_of(analysis_.program().effects_in(block.effects), [&](const Effect& effect) {
            return may_set(analysis_.program(), effect, group);
        });
    return modes;
}

/// How a code of `by` ends the group; nullptr where it does not.
const EndedGroup* ModesAt::end_of(GroupId group, GroupId by) const {
    const auto found = std::ranges::find_if(
        ended_groups_, [&](const EndedGroup& ended) { return ended.group == group && ended.by == by; });
    return found == ended_groups_.end() ? nullptr : &*found;
}

/// What a word of the node has set. A channel of which it is not known that it comes here may pass it by.
Modes ModesAt::set_here(double code, Span block) const {
    Modes modes;
    modes.possible.push_back({code, Mode::SetBy::word, *node_, 0, block});
    modes.unknown = analysis_.graph().channels_at(*node_).uncertain != 0;
    return modes;
}

/// Passes the blocks of the run between the one that was asked about last and this one.
void ModesAt::read_up_to(const BlockView& block) {
    const flow::Node& node = analysis_.graph().nodes[*node_];
    if (block.span.begin == read_to_) return;
    if (!last_block_.empty()) {
        for (const ModalSetting& setting : last_) set(setting.group, setting.value, last_block_);
        moved_ |= last_moves_;
        read_to_ = last_block_.end;
    }
    const Program& program = analysis_.program();
    blocks::visit_part(program, std::get<PlainRun>(program.items[node.item]), {read_to_, block.span.begin},
                       [&](const BlockView& passed) {
                           for (const BlockSetting& setting : passed.settings)
                               set(setting.group, *setting.value, passed.span);
                           moved_ |= passed.moves;
                       });
    read_to_ = block.span.begin;
    last_.clear();
    for (const BlockSetting& setting : block.settings) last_.push_back({setting.group, *setting.value});
    last_block_ = block.span;
    last_moves_ = block.moves;
}

void ModesAt::set(GroupId group, double code, Span block) {
    set_[group] = {visit_, code, block};
    for (const EndedGroup& ended : ended_groups_)
        if (ended.by == group) set_[ended.group] = {visit_, ended.code, block};
}

std::optional<BlockSetting> last_setting_in(const ProgramAnalysis& analysis, flow::NodeId node,
                                            GroupId group) {
    const Program& program = analysis.program();
    const flow::Node& there = analysis.graph().nodes[node];
    std::optional<BlockSetting> last;
    const auto look_at = [&](const BlockSetting& setting) {
        if (setting.group == group) last = setting;
        for (const EndedGroup& ended : program.control->ended_groups)
            if (ended.group == group && ended.by == setting.group)
                last = {group, setting.value ? std::optional(ended.code) : std::nullopt};
    };
    if (there.is_run)
        for_each_last_setting(program, there.stretch(), [&](const ModalSetting& setting) {
            look_at({setting.group, setting.value});
        });
    for (const BlockSetting& setting : BlockSettings(program, program.effects_in(there.effects)))
        look_at(setting);
    return last;
}

} // namespace maclint::queries
