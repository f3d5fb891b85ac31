//! Goes back from a node over the blocks that set a group.
#include "analyzer/queries/modal/own_settings.hpp"

#include "analyzer/execution/path_search.hpp"
#include "analyzer/flow/walk.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/modal/modes_at.hpp"
#include "analyzer/queries/paths/feasible_paths.hpp"
#include "analyzer/queries/values/origins.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <variant>

namespace maclint::queries {
namespace {

/// Whether a call in the node may set the group.
bool calls_change(const ProgramAnalysis& analysis, flow::NodeId node, GroupId group) {
    const Slice effects = analysis.graph().nodes[node].effects;
    for (EffectId id = effects.first; id < effects.first + effects.count; ++id)
        if (std::holds_alternative<Call>(analysis.program().effects[id].what) &&
            call_may_change(analysis, id, group))
            return true;
    return false;
}

/// Calls the visitor with the last nodes before this one that set the group, and with what their words give.
template<class Visit>
void for_each_setting_before(const ProgramAnalysis& analysis, flow::NodeId node, GroupId group,
                             const Visit& visit) {
    flow::walk<flow::Direction::backward>(analysis.graph(), {node},
                                          [&](flow::EdgeId edge, flow::NodeId from) {
                                              if (!analysis.data().passable(edge)) return flow::Step::refuse;
                                              const auto setting = last_setting_in(analysis, from, group);
                                              if (setting) visit(from, setting->value);
                                              return setting ? flow::Step::end : flow::Step::go_on;
                                          });
}

} // namespace

std::vector<std::optional<double>> last_settings_before(const ProgramAnalysis& analysis, flow::NodeId node,
                                                        GroupId group) {
    std::vector<std::optional<double>> found;
    for_each_setting_before(analysis, node, group,
                            [&](flow::NodeId, std::optional<double> setting) { found.push_back(setting); });
    return found;
}

bool is_set_on_a_path_to(const ProgramAnalysis& analysis, flow::NodeId node, GroupId group) {
    constexpr std::size_t most_searches = 8; // of so many one will do
    std::vector<flow::NodeId> setting;
    for_each_setting_before(analysis, node, group,
                            [&](flow::NodeId at, std::optional<double>) { setting.push_back(at); });
    return setting.size() > most_searches ||
           std::ranges::any_of(setting, [&](flow::NodeId at) { return can_follow(analysis, at, node); });
}

bool stays_at(const ProgramAnalysis& analysis, flow::NodeId node, GroupCode code) {
    std::vector<std::optional<double>> now = last_settings_before(analysis, node, code.group);
    if (const auto setting = last_setting_in(analysis, node, code.group)) now = {setting->value};
    bool by_a_call = false;
    flow::walk<flow::Direction::forward>(analysis.graph(), {node}, [&](flow::EdgeId edge, flow::NodeId to) {
        if (!analysis.data().passable(edge)) return flow::Step::refuse;
        if (const auto setting = last_setting_in(analysis, to, code.group)) now.push_back(setting->value);
        by_a_call = by_a_call || calls_change(analysis, to, code.group);
        return by_a_call ? flow::Step::end : flow::Step::go_on;
    });
    return !by_a_call && !now.empty() && std::ranges::all_of(now, [&](const std::optional<double>& setting) {
        return setting == code.code;
    });
}

bool is_given_on_the_way(const ProgramAnalysis& analysis, flow::NodeId from, flow::NodeId to,
                         GroupCode code) {
    std::vector<flow::NodeId> giving; // sorted
    for (flow::NodeId node = 0; node < analysis.graph().nodes.size(); ++node) {
        if (!analysis.data().reached(node)) continue;
        const auto setting = last_setting_in(analysis, node, code.group);
        if (setting && setting->value == code.code && stays_at(analysis, node, code)) giving.push_back(node);
    }
    if (giving.empty()) return false;
    execution::PathSearch search(analysis);
    const auto around = search.find(std::array{execution::Leg{from, {}}, execution::Leg{to, giving}});
    return !around.path && !around.gave_up;
}

bool stands_beside(const ProgramAnalysis& analysis, dataflow::OriginId set, GroupCode code) {
    const Span block = span_of_origin(analysis, set);
    const auto gives = [&](const BlockSetting& setting) {
        return setting.group == code.group && setting.value == code.code;
    };
    bool found = false;
    for_each_block(analysis.program(), analysis.graph().nodes[node_of_origin(analysis, set)].stretch(),
                   [&](const BlockView& view) {
                       const bool sets = view.span.begin <= block.begin && block.end <= view.span.end;
                       found |= sets && std::ranges::any_of(view.settings, gives);
                   });
    return found;
}

ModalMove modal_move_in(const ProgramAnalysis& analysis, const Stretch& block) {
    const ControlModel& control = analysis.control();
    const auto motion = control.group_with(ModalRole::motion);
    const auto feed = control.group_with(ModalRole::feed);
    if (!motion || !feed) return {false, false};
    ModalMove move{false, false};
    const auto letter = [](const Word& word, char name) {
        return word.address.size() == 1 && word.address.front() == name;
    };
    const auto says_how = [&](const Word& word) {
        if (!letter(word, control.groups[*motion].letter)) return false;
        const auto* code = std::get_if<Literal>(&word.value);
        const auto group =
            code == nullptr ? std::nullopt : control.group_of(word.address.front(), code->value);
        if (!group) return true;
        const ModalGroup& row = control.groups[*group];
        return row.role == ModalRole::motion || row.role == ModalRole::macro_call ||
               (row.role == ModalRole::cycle && code->value != row.cancel);
    };
    for_each_block_with_words(analysis.program(), block,
                              [&](const BlockView& view, std::span<const Word> words) {
                                  if (view.span != block.span) return;
                                  move.relies = std::ranges::none_of(words, says_how);
                                  move.gives_feed = std::ranges::any_of(words, [&](const Word& word) {
                                      return letter(word, control.groups[*feed].letter) && word.has_value();
                                  });
                              });
    return move;
}

} // namespace maclint::queries
