//! Solves the switches of a program along its paths.
#include "analyzer/machine/switch_states.hpp"

#include "analyzer/flow/solve.hpp"
#include "analyzer/program/channels.hpp"
#include "analyzer/program/code_key.hpp"
#include "analyzer/program/section_blocks.hpp"
#include "analyzer/program/word_condition.hpp"

#include <algorithm>
#include <charconv>
#include <variant>

namespace maclint::machine {
namespace {

/// A state of a node has some 800 bytes.
constexpr std::size_t most_nodes = 20'000;

/// Any number of the letter.
std::int64_t any_code_of(char letter) { return -static_cast<std::int64_t>(letter); }

class Domain {
  public:
    using State = SwitchState;

    Domain(const SwitchesOfChannel& switches, std::size_t count)
        : switches_(switches)
        , count_(count) {}
    [[nodiscard]] State at_begin(flow::NodeId node) const {
        State state;
        state.is_reached = node == 0;
        for (std::size_t i = 0; state.is_reached && i < count_; ++i) state.all[i].can_be = Switched::callers;
        return state;
    }
    [[nodiscard]] bool is_reached(const State& state) const { return state.is_reached; }
    [[nodiscard]] bool add(State& set, const State& more) const { return set.add(more); }
    void run(flow::NodeId node, State& set) const { switches_.run(node, set); }

  private:
    const SwitchesOfChannel& switches_;
    std::size_t count_;
};

} // namespace

bool SwitchState::add(const SwitchState& other) {
    if (!other.is_reached) return false;
    bool has_changed = !is_reached;
    is_reached = true;
    for (std::size_t i = 0; i < all.size(); ++i) {
        Switched& mine = all[i];
        const Switched& its = other.all[i];
        const Switched both{static_cast<std::uint8_t>(mine.can_be | its.can_be),
                            std::min(mine.on_at, its.on_at), std::min(mine.off_at, its.off_at)};
        has_changed |= both.can_be != mine.can_be || both.on_at != mine.on_at || both.off_at != mine.off_at;
        mine = both;
    }
    return has_changed;
}

void SwitchState::go_on_with(const SwitchState& end_of_called, Offset block) {
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Switched& its = end_of_called.all[i];
        if (its.can_be == Switched::callers) continue;
        const bool keeps = (its.can_be & Switched::callers) != 0;
        Switched after{static_cast<std::uint8_t>(its.can_be & ~unsigned{Switched::callers}),
                       Switched::nowhere, Switched::nowhere};
        if ((its.can_be & Switched::on) != 0) after.on_at = block;
        if ((its.can_be & Switched::off) != 0) after.off_at = block;
        if (keeps) {
            after.can_be = static_cast<std::uint8_t>(after.can_be | all[i].can_be);
            after.on_at = std::min(after.on_at, all[i].on_at);
            after.off_at = std::min(after.off_at, all[i].off_at);
        }
        all[i] = after;
    }
}

void SwitchState::forget() {
    for (Switched& one : all) one = {Switched::unknown, Switched::nowhere, Switched::nowhere};
}

SwitchStepper::SwitchStepper(const ControlModel& control, bool of_sections) {
    for (std::size_t i = 0; i < control.switches.size(); ++i) {
        const Switch& one = control.switches[i];
        if ((one.where == Switch::Where::section) != of_sections) continue;
        add(i, one.on, Switched::on);
        add(i, one.off, Switched::off);
        add(i, one.either, Switched::unknown);
    }
    std::ranges::stable_sort(actions_, {}, &Action::code);
}

void SwitchStepper::add(std::size_t of, std::string_view codes, std::uint8_t makes) {
    for_each_part(codes, ',', [&](std::string_view code) {
        const std::size_t end = std::min(code.find(' '), code.size());
        double number = 0;
        const bool any = std::from_chars(code.data() + 1, code.data() + end, number).ec != std::errc{};
        const std::string_view when = end < code.size() ? code.substr(end + 1) : std::string_view{};
        const std::string_view but = code.substr(1).starts_with('!') ? code.substr(2, end - 2) : "";
        actions_.push_back(
            {any ? any_code_of(code.front()) : code_key(code.front(), number), but, when, of, makes});
        auto letter = std::ranges::find(letters_, code.front(), &LetterCodes::letter);
        if (letter == letters_.end()) letter = letters_.insert(letter, {code.front(), {}});
        for (int each = 0; any && each < static_cast<int>(CodeNumbers::capacity); ++each)
            letter->codes.add(each);
        letter->codes.add(number);
        if (any || number >= CodeNumbers::capacity) letter->codes.add_beyond();
    });
}

void SwitchStepper::run(const BlockView& block, std::span<const Word> words, SwitchState& state) const {
    const auto act = [&](const Word& word, std::int64_t code) {
        for (const Action& action : std::ranges::equal_range(actions_, code, {}, &Action::code)) {
            const Fits applies = fits_beside(words, word, action.when);
            if (applies == Fits::no || (!action.but.empty() && fits(word, action.but) == Fits::yes)) continue;
            const std::uint8_t makes = applies == Fits::yes ? action.makes : Switched::unknown;
            state.all[action.of] = {makes, makes == Switched::on ? block.span.begin : Switched::nowhere,
                                    makes == Switched::off ? block.span.begin : Switched::nowhere};
        }
    };
    for (const Word& word : words) {
        if (word.address.size() != 1) continue;
        act(word, any_code_of(word.address.front()));
        if (const auto* number = std::get_if<Literal>(&word.value))
            act(word, code_key(word.address.front(), number->value));
    }
}

SwitchesOfChannel::SwitchesOfChannel(const Program& program, const flow::Graph& graph,
                                     const SwitchStepper& stepper, std::uint8_t channel,
                                     SwitchesLeftByCall left_by_call)
    : program_(&program)
    , graph_(&graph)
    , stepper_(&stepper)
    , channel_(channel)
    , left_by_call_(std::move(left_by_call)) {
    before_ = flow::solve<flow::Direction::forward>(graph, Domain(*this, program.control->switches.size()));
    for (const flow::Exit& exit : graph.exits) {
        if (exit.kind != flow::ExitKind::returns && exit.kind != flow::ExitKind::runs_off) continue;
        SwitchState state = before_[exit.node];
        if (!state.is_reached) continue;
        run(exit.node, state);
        (void)left_.add(state);
    }
}

void SwitchesOfChannel::run_part(flow::NodeId id, Span part, SwitchState& state) const {
    const flow::Node& node = graph_->nodes[id];
    if (id >= graph_->nodes_in_text ||
        (program_->has_several_channels() && (graph_->channels_at(id).running >> channel_ & 1U) == 0))
        return;
    const Stretch stretch = node.stretch();
    if (stretch.item >= program_->items.size()) return; // the one node of an empty program
    // A contour's F is one of its element, and no feed.
    const Section* section = section_at(*program_, stretch.span.begin);
    if (section != nullptr && section->executed != Section::Executed::when_reached) return;
    const auto look = [&](const BlockView& block, std::span<const Word> words) {
        // A block of several nodes does in the first what its words say.
        const bool is_first =
            node.is_run || node.effects.count == 0 || node.effects.first == block.effects.first;
        if (is_first && part.begin <= block.span.begin && block.span.begin < part.end)
            stepper_->run(block, words, state);
    };
    if (!node.is_run) {
        for_each_block_with_words(*program_, stretch, look);
        return;
    }
    const Span common{std::max(stretch.span.begin, part.begin), std::min(stretch.span.end, part.end)};
    if (common.begin < common.end)
        for_each_line_with(stepper_->letters(), program_->text, common, [&](Span line) {
            for_each_block_with_words(*program_, Stretch{stretch.item, line}, look);
        });
}

void SwitchesOfChannel::run(flow::NodeId id, SwitchState& state) const {
    run_part(id, {0, Switched::nowhere}, state);
    if (id < graph_->nodes_in_text) run_calls(graph_->nodes[id], state);
}

void SwitchesOfChannel::run_calls(const flow::Node& node, SwitchState& state) const {
    for (EffectId id = node.effects.first; id < node.effects.first + node.effects.count; ++id) {
        const auto& what = program_->effects[id].what;
        if (std::holds_alternative<UnreadableBlock>(what)) state.forget();
        if (!std::holds_alternative<Call>(what)) continue;
        const SwitchState* left = left_by_call_(id, channel_);
        if (left == nullptr || !left->is_reached)
            state.forget();
        else
            state.go_on_with(*left, node.part.begin);
    }
}

SwitchStates::SwitchStates(const Program& program, const flow::Graph& graph,
                           const SwitchesLeftByCall& left_by_call)
    : stepper_(*program.control, false) {
    if (program.control->switches.empty() || graph.nodes.empty() || graph.nodes.size() > most_nodes) return;
    for_each_channel(graph.all_channels, [&](std::uint8_t channel) {
        channels_.emplace_back(std::piecewise_construct, std::forward_as_tuple(channel),
                               std::forward_as_tuple(program, graph, stepper_, channel, left_by_call));
    });
}

const SwitchesOfChannel* SwitchStates::of(std::uint8_t channel) const {
    for (const auto& [number, switches] : channels_)
        if (number == channel || channels_.size() == 1) return &switches;
    return nullptr;
}

} // namespace maclint::machine
