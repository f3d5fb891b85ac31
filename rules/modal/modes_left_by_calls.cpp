//! Holds the modes at cuts against those before the last call.
#include "rules/modal/modes_left_by_calls.hpp"

#include "analyzer/machine/states.hpp"
#include "analyzer/program/machine_words.hpp"
#include "analyzer/program/tables.hpp"
#include "rules/machine/feed_size.hpp"
#include "rules/modal/modal_leak.hpp"
#include "rules/path.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace maclint::rules {
namespace {

using machine::Known;
using machine::Step;

constexpr std::array roles = {ModalRole::feed_mode, ModalRole::speed_mode};

/// Of a block that calls a program, in the order of `roles`: the modes that its program has written itself
/// before, and the first call since then.
struct Calling {
    std::array<Known, roles.size()> modes;
    std::array<Span, roles.size()> first_since;
};

class LeftModes {
  public:
    LeftModes(const ProgramAnalysis& analysis, Reporter& reporter)
        : analysis_(analysis)
        , letters_(*analysis.control().machine_words)
        , reporter_(reporter) {}

    void see(const Step& step) {
        for (std::size_t i = 0; i < roles.size(); ++i)
            if (step.move == machine::Move::feed || step.move == machine::Move::cycle) look_at(step, i);
        if (!step.calls) return;
        Calling calling;
        for (std::size_t i = 0; i < roles.size(); ++i) {
            const Known& mode = step.after.of(roles[i]);
            const auto before = mode.by_call ? calls_.find(mode.block) : calls_.end();
            const bool is_first = before == calls_.end();
            calling.modes[i] = is_first ? mode : before->second.modes[i];
            calling.first_since[i] = is_first ? step.block.span : before->second.first_since[i];
        }
        calls_[step.block.span.begin] = calling;
    }

  private:
    void look_at(const Step& step, std::size_t i) {
        const Known& mode = step.after.of(roles[i]);
        if (!mode.is_known() || !mode.by_call) return;
        const auto call = calls_.find(mode.block);
        if (call == calls_.end()) return;
        const Known& own = call->second.modes[i];
        if (!own.is_known() || own.by_call || own.value == mode.value) return;
        if (roles[i] == ModalRole::feed_mode && !is_feed_of(step, own, mode)) return;
        if (!told_.insert({own.block, i}).second) return;
        report(step, call->second.first_since[i], roles[i], own);
    }

    /// Whether the feed is meant for the mode before the call: it was given there, or its size says so.
    [[nodiscard]] bool is_feed_of(const Step& step, const Known& own, const Known& mode) const {
        const Known& feed = step.after.of(ModalRole::feed);
        if (!feed.is_known() || feed.by_call) return false;
        const FeedSize size(step.before, letters_);
        return (own.block < feed.block && feed.block < mode.block) ||
               (mode.value == letters_.feed_per_minute ? size.is_too_little_for_a_minute(feed.value)
                                                       : size.is_too_much_for_a_turn(feed.value));
    }

    void report(const Step& step, Span call, ModalRole role, const Known& own) {
        const GroupId group = *analysis_.control().group_with(role);
        const auto code = [&](double number) { return analysis_.control().spell(group, number); };
        const std::string line = line_number(analysis_.file(), step.block.span.begin);
        const std::string left = code(step.after.of(role).value);
        Finding& finding = reporter_.report(
            {analysis_, call}, call, "by-call",
            {capital_name(analysis_, group), left, quoted(analysis_.program(), call), line, code(own.value)});
        const std::string_view text = analysis_.program().text;
        const auto end = static_cast<Offset>(std::min(text.find_first_of("\r\n", own.block), text.size()));
        finding.path = {{analysis_.source(), {own.block, end}, code(own.value) + " is in force from here on"},
                        {analysis_.source(), call, "the called program leaves " + left}};
        finding.related.push_back({analysis_.source(), step.block.span, "this program cuts so here"});
    }

    const ProgramAnalysis& analysis_;
    const MachineWords& letters_;
    Reporter& reporter_;
    std::map<Offset, Calling> calls_;
    std::set<std::pair<Offset, std::size_t>> told_;
};

} // namespace

void report_modes_left_by_calls(const ProgramAnalysis& analysis, Reporter& reporter) {
    const MachineWords* letters = analysis.control().machine_words;
    if (letters == nullptr || !letters->x_is_diameter || analysis.calls().empty()) return;
    LeftModes search(analysis, reporter);
    analysis.machine().for_each_step([&](const Step& step) { search.see(step); });
}

} // namespace maclint::rules
