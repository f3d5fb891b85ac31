//! Solves the states of a program along its paths.
#include "analyzer/machine/states.hpp"

#include "analyzer/flow/solve.hpp"
#include "analyzer/program/lines_with.hpp"

#include <algorithm>
#include <utility>

namespace maclint::machine {
namespace {

/// A state of a node has some 600 bytes.
constexpr std::size_t most_nodes = 20'000;
/// A program with more plain blocks comes from a CAM system. A block takes some 200 ns.
constexpr std::size_t most_plain_blocks = 50'000;

/// The states in front of nodes, gathered in place.
class Domain {
  public:
    using State = machine::State;

    explicit Domain(const States& states)
        : states_(states) {}
    [[nodiscard]] State at_begin(flow::NodeId node) const { return node == 0 ? states_.at_begin() : State(); }
    [[nodiscard]] bool is_reached(const State& state) const { return state.is_reached; }
    [[nodiscard]] bool add(State& set, const State& more) const { return set.add(more); }
    void run(flow::NodeId node, State& set) const {
        states_.run(node, set, [](const Step&) {});
    }
    [[nodiscard]] bool is_passable(flow::EdgeId edge) const { return states_.passable(edge); }

  private:
    const States& states_;
};

/// A file of definitions is never run.
bool is_never_run(const Program& program) {
    return std::ranges::all_of(program.sections, [](const Section& section) {
        return section.executed == Section::Executed::never;
    });
}

} // namespace

States::States(const Program& program, const flow::Graph& graph, LeftByCall left_by_call,
               std::optional<OneCall> only)
    : program_(&program)
    , graph_(&graph)
    , left_by_call_(std::move(left_by_call))
    , only_(std::move(only)) {
    if (program.control->machine_words == nullptr || program.has_several_channels() || graph.nodes.empty() ||
        graph.nodes.size() > most_nodes || is_never_run(program)) {
        left_.state.is_reached = true;
        left_.state.forget();
        return;
    }
    stepper_.emplace(program, *program.control->machine_words);
    const MachineWords& machine = *program.control->machine_words;
    for (const char letter : {machine.tool, machine.length_offset, machine.cutter_offset})
        if (letter != 0) choosing_.add(addresses_named(program, std::string_view(&letter, 1)));
    std::size_t plain_blocks = 0;
    for (const Item& item : program.items)
        if (const auto* run = std::get_if<PlainRun>(&item)) plain_blocks += run->blocks;
    sees_all_ = plain_blocks <= most_plain_blocks;
    before_ = flow::solve<flow::Direction::forward>(graph, Domain(*this));
    survey();
}

State States::at_begin() const {
    State state;
    state.is_reached = true;
    if (only_ && only_->plane) state.of(ModalRole::plane) = Known::of(*only_->plane, 0);
    return state;
}

void States::leaves_as_it_was(ModalRole role) {
    Known& mode = left_.state.of(role);
    if (mode.kind == Known::Kind::unknown) mode = Known();
}

std::vector<Span> States::parts_that_begin_something(const PlainRun& run, Span stretch) const {
    const bool begins_something =
        run.words.codes.any_common(run.words.codes, [](syntax::CodeSet::Kind kind) { return kind > 3; }) ||
        run.words.addresses.meets(choosing_);
    if (!begins_something) return {};
    CodeNumbers any, other_than_motion;
    any.add_beyond();
    other_than_motion.add_beyond();
    for (int code = 0; code < static_cast<int>(CodeNumbers::capacity); ++code) {
        any.add(code);
        if (code > 3) other_than_motion.add(code);
    }
    const MachineWords& machine = *program_->control->machine_words;
    std::vector<LetterCodes> wanted = {{'G', other_than_motion}, {'M', any}, {machine.tool, any}};
    for (const char letter : {machine.length_offset, machine.cutter_offset})
        if (letter != 0) wanted.push_back({letter, any});
    constexpr Offset some_lines = 2000; // bytes
    std::vector<Span> parts;
    for_each_line_with(wanted, program_->text, stretch, [&](Span line) {
        const std::size_t after = program_->text.find('\n', std::min(line.end + some_lines, stretch.end));
        const auto end = static_cast<Offset>(std::min<std::size_t>(after, stretch.end));
        if (!parts.empty() && parts.back().end >= line.begin)
            parts.back().end = end;
        else
            parts.push_back({line.begin, end});
    });
    return parts;
}

std::vector<Word> States::with_numbers(std::span<const Word> words) const {
    std::vector<Word> known(words.begin(), words.end());
    for (Word& word : known) {
        const auto* id = std::get_if<ExpressionId>(&word.value);
        const auto number = id == nullptr ? only_->numbers.end() : only_->numbers.find(*id);
        if (number != only_->numbers.end()) word.value = Literal{number->second, true};
    }
    return known;
}

void States::forget_between(State& state) {
    state.forget_position();
    for (const ModalRole role : {ModalRole::motion, ModalRole::feed}) state.of(role) = Known::nothing();
}

bool States::calls_after_moves(const State& state) const {
    return may_be_on(state, *program_->control, ModalRole::macro_call);
}

void States::run_calls(const flow::Node& node, State& state) const {
    for (Id id = node.effects.first; id < node.effects.first + node.effects.count; ++id) {
        const auto& what = program_->effects[id].what;
        const auto* guarded = std::get_if<Guarded>(&what);
        const bool may_call =
            guarded != nullptr &&
            std::ranges::any_of(program_->effects_in(guarded->effects), [](const Effect& effect) {
                const auto* stop = std::get_if<Stop>(&effect.what);
                const bool is_alarm = stop != nullptr && stop->kind == Stop::Kind::alarm;
                return !is_alarm && !std::holds_alternative<Assign>(effect.what) &&
                       !std::holds_alternative<Jump>(effect.what);
            });
        if (const auto* call = std::get_if<Call>(&what)) {
            const Left* left = left_by_call_(id);
            if (left != nullptr && left->changes_nothing) continue;
            if (left == nullptr && program_->control->calls[call->kind].brought_by_control) {
                state.forget_position();
                state.of(ModalRole::feed) = Known::nothing();
            } else if (left == nullptr || !left->state.is_reached)
                state.forget();
            else {
                state.go_on_with(left->state, node.part.begin);
                state.resolve_passed([&](double variable) { return passed_by(*call, variable); });
            }
        } else if (may_call) {
            state.forget();
        }
    }
}

/// The number that the call passes for the variable; nothing where it passes none, or calculates it.
Known States::passed_by(const Call& call, double variable) const {
    for (const Argument& argument : program_->arguments_of(call)) {
        const auto* given = std::get_if<Variable>(&argument.given);
        const auto* number = std::get_if<Literal>(&program_->expressions[argument.value].node);
        if (given != nullptr && number != nullptr && static_cast<double>(given->number) == variable)
            return Known::of(number->value, 0);
    }
    return Known::nothing();
}

/// Whether nothing but a cut can be meant: a tool that stands may bring a stop or a bar to its place.
bool States::is_surely_a_cut(const Step& step) const {
    const MachineWords& machine = *program_->control->machine_words;
    if (step.move == Move::cycle) return true;
    return machine.tool_word_holds_offset
               ? step.after.of(ModalRole::feed_mode).is(machine.feed_per_revolution)
               : step.axes[0] || step.axes[1];
}

void States::survey() {
    for (const flow::Exit& exit : graph_->exits) {
        if (exit.kind != flow::ExitKind::returns && exit.kind != flow::ExitKind::runs_off) continue;
        State state = before_[exit.node];
        if (!state.is_reached) continue;
        run(exit.node, state, [](const Step&) {});
        (void)left_.state.add(state);
    }
    for_each_step([&](const Step& step) {
        habits_.see(step, *program_);
        if (step.move != Move::feed && step.move != Move::cycle) return;
        if (!left_.cuts_with_spindle && is_surely_a_cut(step) &&
            step.after.of(ModalRole::spindle).is_callers())
            left_.cuts_with_spindle = step.block.span;
        if (!left_.cuts_with_feed && takes_feed(step, *program_->control->machine_words) &&
            step.after.of(ModalRole::feed).is_callers())
            left_.cuts_with_feed = step.block.span;
    });
}

} // namespace maclint::machine
