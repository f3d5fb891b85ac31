//! Asks the switches at each return.
#include "rules/timing/look_ahead_limit_left_on_finder.hpp"

#include "analyzer/machine/switch_states.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/queries/machine/switches_at.hpp"
#include "analyzer/queries/machine/unfinished_moves.hpp"
#include "analyzer/queries/paths/feasible_paths.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace maclint::rules {
namespace {

/// Where the program switches the limit, and leaves.
class Limit {
  public:
    Limit(const ProgramAnalysis& analysis, std::size_t of, const machine::SwitchesOfChannel& switches)
        : analysis_(analysis)
        , of_(of)
        , switches_(switches) {
        const machine::SwitchStepper stepper(analysis.control(), false);
        // A block that stops look-ahead has effects of its own, and is none of the plain ones.
        for_each_block_with_words(
            analysis.program(), [](const WordSummary&) { return false; },
            [&](const BlockView& block, std::span<const Word> words, const WordSummary*) {
                machine::SwitchState state;
                stepper.run(block, words, state);
                if (state.all[of].is_surely_on()) on_.emplace(block.span.begin, block.span);
                if (state.all[of].is_surely_off()) ends_.emplace(block.span.begin, block.span);
                if (state.all[of].can_be == machine::Switched::unknown) may_end_.push_back(block.span);
            });
    }

    [[nodiscard]] std::optional<LimitLeftOn> left_on() const {
        std::optional<Span> end = unreached_end();
        std::vector<flow::NodeId> returns;
        Offset limit = machine::Switched::nowhere;
        for (const flow::Exit& exit : analysis_.graph().exits) {
            machine::SwitchState state = switches_.before(exit.node);
            if (!state.is_reached || !analysis_.data().reached(exit.node)) continue;
            switches_.run(exit.node, state);
            const machine::Switched& at_exit = state.all[of_];
            const auto ended = ends_.find(at_exit.off_at);
            if (at_exit.is_surely_off() && ended != ends_.end() && !end) end = ended->second;
            if (exit.kind != flow::ExitKind::returns || at_exit.is_surely_off()) continue;
            const auto under = at_exit.is_surely_on() ? on_.find(at_exit.on_at) : passed_over_ends(exit.node);
            if (under == on_.end()) continue;
            if (!at_exit.is_surely_on() && !end) end = ends_.begin()->second;
            if (returns.empty()) limit = under->first;
            returns.push_back(exit.node);
        }
        if (!end || returns.empty()) return std::nullopt;
        return LimitLeftOn{limit, *end, std::move(returns)};
    }

  private:
    using Blocks = std::map<Offset, Span>;

    /// The limit that is still on where the control comes to the node on a way around all blocks that end it,
    /// or may (G103 P#1), and around all calls, which may.
    [[nodiscard]] Blocks::const_iterator passed_over_ends(flow::NodeId node) const {
        const flow::Graph& graph = analysis_.graph();
        if (ends_.empty()) return on_.end();
        std::vector<flow::NodeId> barred;
        const auto bar = [&](Span block) {
            if (const auto ending = graph.node_of(block)) barred.push_back(*ending);
        };
        for (const auto& [begin, block] : ends_) bar(block);
        std::ranges::for_each(may_end_, bar);
        for (const flow::NodeId with : graph.with_effects)
            if (std::ranges::any_of(analysis_.program().effects_in(graph.nodes[with].effects), calls))
                barred.push_back(with);
        std::ranges::sort(barred);
        return std::ranges::find_if(on_, [&](const auto& limit) {
            const auto from = graph.node_of(limit.second);
            return from && analysis_.data().reached(*from) &&
                   queries::can_follow(analysis_, *from, node, barred);
        });
    }

    static bool calls(const Effect& effect) { return std::holds_alternative<Call>(effect.what); }

    /// A block that was to end it, and that no path leads to.
    [[nodiscard]] std::optional<Span> unreached_end() const {
        for (const auto& [begin, block] : ends_)
            if (const auto node = analysis_.graph().node_of(block); node && !analysis_.data().reached(*node))
                return block;
        return std::nullopt;
    }

    const ProgramAnalysis& analysis_;
    std::size_t of_;
    const machine::SwitchesOfChannel& switches_;
    Blocks on_, ends_;
    std::vector<Span> may_end_;
};

} // namespace

std::optional<LimitLeftOn> limit_left_on(const ProgramAnalysis& analysis) {
    const auto of = queries::find_switch(analysis.control(), "limit of look-ahead");
    if (!of || !queries::limits_look_ahead(analysis.program())) return std::nullopt;
    const machine::SwitchesOfChannel* switches = analysis.switches().of(0);
    return switches == nullptr ? std::nullopt : Limit(analysis, *of, *switches).left_on();
}

} // namespace maclint::rules
