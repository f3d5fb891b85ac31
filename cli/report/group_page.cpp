//! Made from the rows of the modal groups.
#include "cli/report/group_page.hpp"

#include "cli/report/code_page.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <vector>

namespace maclint::cli {
namespace {

bool equal_without_case(std::string_view a, std::string_view b) {
    const auto in_capital = [](char c) {
        return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    };
    return std::ranges::equal(a, b, {}, in_capital, in_capital);
}

/// Its group, what ends it.
std::vector<std::string> lines_of(const ControlModel& control, GroupId id, const ModalMember& member) {
    const ModalGroup& group = control.groups[id];
    std::vector<std::string> lines;
    std::string others;
    for (const ModalMember& other : group.members)
        if (other.number != member.number)
            others.append(others.empty() ? "" : " ").append(control.spell(id, other.number));
    constexpr std::size_t most_listed = 16;
    const std::string until =
        group.members.size() > most_listed ? "another code of its group" : either_of(others);
    lines.push_back(std::string(group.name) + (others.empty() ? "" : ", until " + until));
    if (group.cancel == member.number)
        lines.emplace_back("it cancels the others of its group");
    else if (group.cancel)
        lines.push_back("cancelled by " + (group.cancel_words.empty() ? control.spell(id, *group.cancel)
                                                                      : std::string(group.cancel_words)));
    if (group.reset == member.number) lines.emplace_back("in force when a program begins");
    return lines;
}

std::string page_of(const ControlModel& control, GroupId id, const ModalMember& member,
                    const PageStyle& style) {
    const ModalGroup& group = control.groups[id];
    PlainPage out(style);
    out.add_title(control.spell(id, member.number), control.description);
    out.add_heading("In force:");
    for (const std::string& line : lines_of(control, id, member)) out.add_item(line);
    out.add_heading("Source:");
    out.add_source(group.source);
    return out.take();
}

} // namespace

std::string plain_group_page(const ControlModel& control, std::string_view code, const PageStyle& style) {
    if (!books_of(control.language).empty()) return {};
    for (std::size_t i = 0; i < control.groups.size(); ++i)
        for (const ModalMember& member : control.groups[i].members)
            if (!member.spelling.empty() && equal_without_case(member.spelling, code))
                return page_of(control, static_cast<GroupId>(i), member, style);
    return {};
}

std::string short_group_page(const ControlModel& control, std::string_view code) {
    for (std::size_t i = 0; i < control.groups.size(); ++i) {
        const auto id = static_cast<GroupId>(i);
        for (const ModalMember& member : control.groups[i].members) {
            const std::string name = control.spell(id, member.number);
            if (!equal_without_case(name, code)) continue;
            std::string text = "**" + name + "**";
            for (const std::string& line : lines_of(control, id, member)) text += "\n- " + line;
            return text;
        }
    }
    return {};
}

} // namespace maclint::cli
