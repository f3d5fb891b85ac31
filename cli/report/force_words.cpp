//! Modal groups in words.
#include "cli/report/force_words.hpp"

#include "rules/words/word_list.hpp"

#include <algorithm>

namespace maclint::cli {
namespace {

using Numbers = std::vector<double>;

bool holds(const Numbers& numbers, double number) {
    return std::ranges::find(numbers, number) != numbers.end();
}

/// "G73, G74 or G76", without those given.
std::string members_of(const ControlModel& control, GroupId id, const Numbers& without) {
    std::string codes;
    for (const ModalMember& member : control.groups[id].members)
        if (!holds(without, member.number))
            codes.append(codes.empty() ? "" : " ").append(control.spell(id, member.number));
    return either_of(codes);
}

std::string cancel_of(const ControlModel& control, GroupId id) {
    const ModalGroup& group = control.groups[id];
    return group.cancel_words.empty() ? control.spell(id, *group.cancel) : std::string(group.cancel_words);
}

} // namespace

std::vector<std::string> force_of(const ControlModel& control, std::span<const std::string_view> codes) {
    Numbers numbers;
    for (const std::string_view code : codes) numbers.push_back(code_number_of(code));
    const auto id = control.group_of(codes.front().front(), numbers.front());
    if (!id) return {};
    const ModalGroup& group = control.groups[*id];
    const bool cancels = group.cancel && holds(numbers, *group.cancel) && group.cancel_words.empty();
    std::vector<std::string> lines;
    const std::string others = members_of(control, *id, numbers);
    lines.push_back(std::string(group.name) + (others.empty() ? "" : ", until " + others));
    if (cancels) lines.emplace_back("it cancels the others of its group");
    if (group.cancel && !cancels) lines.push_back("cancelled by " + cancel_of(control, *id));
    if (const auto by = group.ended_by ? control.group_with(*group.ended_by) : std::nullopt; by && !cancels)
        lines.push_back("ended by a code of the " + std::string(control.groups[*by].name) +
                        ", too: " + members_of(control, *by, numbers));
    if (group.reset && holds(numbers, *group.reset)) lines.emplace_back("in force when a program begins");
    return lines;
}

} // namespace maclint::cli
