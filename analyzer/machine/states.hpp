//! The states in front of every node of a program, and what the program leaves.
#pragma once

#include "analyzer/flow/graph.hpp"
#include "analyzer/machine/habits.hpp"
#include "analyzer/machine/one_call.hpp"
#include "analyzer/machine/step.hpp"

#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace maclint::machine {

/// What a program does to the machine, for who calls it.
struct Left {
    State state; ///< not reached: it comes back to nobody
    /// The first block that cuts while the spindle, the feed is as the caller left it.
    std::optional<Span> cuts_with_spindle, cuts_with_feed;
    bool changes_nothing =
        false; ///< no program, but a word that only switches something: `state` says nothing
};

/// What a called program leaves; nullptr: nobody has it.
using LeftByCall = std::function<const Left*(EffectId call)>;

class States {
  public:
    /// Nothing is known of a program whose control has no words for it, or which is too large. With a call
    /// its calculated words are taken for what they then are.
    States(const Program& program, const flow::Graph& graph, LeftByCall left_by_call,
           std::optional<OneCall> only);
    /// The same program, begun by one call.
    [[nodiscard]] States begun_by(OneCall call) const {
        return {*program_, *graph_, left_by_call_, std::move(call)};
    }

    [[nodiscard]] bool empty() const { return before_.empty(); }
    [[nodiscard]] const Left& left() const { return left_; }
    /// When the program begins.
    [[nodiscard]] State at_begin() const;
    /// It is known from elsewhere that the program leaves the mode as it was: it saves it, and puts it back.
    void leaves_as_it_was(ModalRole role);
    /// What the program that the call means leaves; nullptr: nobody has it.
    [[nodiscard]] const Left* left_by_call(EffectId call) const { return left_by_call_(call); }
    [[nodiscard]] const Habits& habits() const { return habits_; }

    /// `visit(Step)` for the blocks that paths lead to, in the order of the text. Of very long runs of plain
    /// blocks only those are seen that begin something, and some blocks behind each.
    template<class Visit>
    void for_each_step(const Visit& visit) const {
        for (flow::NodeId node = 0; node < before_.size(); ++node) for_each_step_of(node, visit);
    }
    /// The same of one node.
    template<class Visit>
    void for_each_step_of(flow::NodeId node, const Visit& visit) const {
        if (!before_[node].is_reached) return;
        State state = before_[node];
        run(node, state, visit);
    }
    /// Whether the edge can be taken, as far as the call tells.
    [[nodiscard]] bool passable(flow::EdgeId edge) const { return !only_ || only_->passable[edge]; }

    /// Of a node: its blocks, then its calls.
    template<class Visit>
    void run(flow::NodeId id, State& state, const Visit& visit) const {
        const flow::Node& node = graph_->nodes[id];
        if (id >= graph_->nodes_in_text) return;
        Stepper stepper = *stepper_;
        if (node.is_run) {
            run_plain(stepper, node.stretch(), state, visit);
        } else {
            for_each_block_with_words(
                *program_, node.stretch(), [&](const BlockView& block, std::span<const Word> words) {
                    // A block of several nodes does in the first what its words say.
                    if (node.effects.count == 0 || node.effects.first == block.effects.first)
                        step(stepper, state, block, words, visit);
                });
            run_calls(node, state);
        }
    }

  private:
    template<class Visit>
    void step(Stepper& stepper, State& state, const BlockView& block, std::span<const Word> words,
              const Visit& visit) const {
        bool is_followed_by_call = false;
        std::vector<Word> known;
        if (only_) words = known = with_numbers(words);
        stepper.run(state, block, words, [&](const Step& one) {
            visit(one);
            is_followed_by_call = one.move != Move::none && calls_after_moves(state);
        });
        if (is_followed_by_call) state.forget();
    }
    template<class Visit>
    void run_plain(Stepper& stepper, const Stretch& stretch, State& state, const Visit& visit) const {
        const auto& run = std::get<PlainRun>(program_->items[stretch.item]);
        blocks::WordReader reader;
        const auto pass = [&](Span part) {
            reader.visit_words(
                *program_, run, part, [](const WordSummary&) { return true; },
                [&](const BlockView& block, std::span<const Word> words, const WordSummary*) {
                    step(stepper, state, block, words, visit);
                });
        };
        if (sees_all_) return pass(stretch.span);
        for (const Span part : parts_that_begin_something(run, stretch.span)) {
            forget_between(state);
            pass(part);
        }
        forget_between(state);
        for_each_last_setting(*program_, stretch, [&](const ModalSetting& setting) {
            state.of(program_->control->groups[setting.group].role) =
                Known::of(setting.value, stretch.span.begin);
        });
    }

    /// Lines with a code or a word that does more than move, and some behind each.
    [[nodiscard]] std::vector<Span> parts_that_begin_something(const PlainRun& run, Span stretch) const;
    /// The words of a block for the one call.
    [[nodiscard]] std::vector<Word> with_numbers(std::span<const Word> words) const;
    static void forget_between(State& state);
    [[nodiscard]] bool calls_after_moves(const State& state) const;
    void run_calls(const flow::Node& node, State& state) const;
    [[nodiscard]] Known passed_by(const Call& call, double variable) const;
    void survey();
    [[nodiscard]] bool is_surely_a_cut(const Step& step) const;

    const Program* program_;
    const flow::Graph* graph_;
    LeftByCall left_by_call_;
    std::optional<OneCall> only_;    ///< nothing: it is looked at for all calls
    std::optional<Stepper> stepper_; ///< nothing: no state is known
    syntax::AddressSet choosing_;    ///< addresses that choose a tool or an offset
    bool sees_all_ = true;           ///< and not only what begins something
    std::vector<State> before_;
    Left left_;
    Habits habits_;
};

} // namespace maclint::machine
