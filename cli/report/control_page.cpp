//! Pages and JSON of controls.
#include "cli/report/control_page.hpp"

#include "analyzer/dialect/dialect.hpp"
#include "cli/report/columns.hpp"
#include "cli/report/control_facts.hpp"
#include "cli/text/shown.hpp"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

namespace maclint::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(text.size() + 1, width), ' ');
    return text;
}

/// "G0, G1", "F" of a group that is a value.
std::string members_of(const ControlModel& control, std::size_t id) {
    const ModalGroup& group = control.groups[id];
    if (group.members.empty()) return group.letter == '#' ? "" : std::string(1, group.letter);
    std::string list;
    for (const ModalMember& member : group.members)
        list.append(list.empty() ? "" : ", ").append(control.spell(static_cast<GroupId>(id), member.number));
    return list;
}

std::string numbers_of(const VariableRange& range) {
    const std::string first = "#" + std::to_string(range.first);
    return range.first == range.last ? first : first + " to #" + std::to_string(range.last);
}

std::string list_of(const std::vector<std::string_view>& codes) {
    std::string list;
    for (const std::string_view code : codes) list.append(list.empty() ? "" : " ").append(code);
    return list;
}

Json summary_of(const ControlModel& control, const ControlFacts& facts) {
    return {{"name", control.name},
            {"description", control.description},
            {"language", control.language},
            {"model", control.model},
            {"machine", control.machine == Machine::mill ? "mill" : "lathe"},
            {"gcode_system", control.code_system == 0 ? "" : std::string(1, control.code_system)},
            {"assumed", control.assumed},
            {"codes", facts.codes},
            {"words", facts.words},
            {"variables", facts.variables.size()},
            {"alarms", {{"list", control.alarms}, {"numbers", facts.alarms}, {"found", facts.alarms_found}}}};
}

} // namespace

std::string plain_controls(std::size_t width) {
    std::size_t widest = 0;
    for (const ControlModel* control : controls()) widest = std::max(widest, control->name.size());
    const std::size_t column = widest + 2;
    const std::string before(column, ' ');
    std::string out;
    for (const ControlModel* control : controls()) {
        const ControlFacts facts = facts_of(*control);
        const std::string what =
            machine_of(*control) + "; " + counted(facts.codes, "code") + " with " +
            counted(facts.words, "word") + "; " + counted(facts.variables.size(), "range") +
            " of variables; " +
            (control->alarms.empty() ? "no alarms" : "alarms of " + std::string(control->alarms));
        std::string name = padded(control->name, column);
        for (const std::string& text : {control->description, what})
            for (const std::string& line : wrapped(text, width - column, width - column))
                out += std::exchange(name, before) + line + "\n";
    }
    out += "\n";
    for (const std::string& line : wrapped("'maclint controls NAME' tells what is known of one; a program's "
                                           "control is named with --control or in the configuration.",
                                           width, width))
        out += line + "\n";
    return out;
}

std::string json_controls() {
    Json list = Json::array();
    for (const ControlModel* control : controls()) list.push_back(summary_of(*control, facts_of(*control)));
    return list.dump(2) + "\n";
}

std::string json_control(const ControlModel& control) {
    const ControlFacts facts = facts_of(control);
    Json json = summary_of(control, facts);
    Json limits = Json::object(), chapters = Json::array(), groups = Json::array(), variables = Json::array();
    for (const auto& [what, limit] : facts.limits) limits[std::string(what)] = limit;
    for (const ChapterFacts& chapter : facts.chapters)
        chapters.push_back(
            {{"chapter", chapter.chapter}, {"codes", chapter.codes}, {"words", chapter.words}});
    for (std::size_t id = 0; id < control.groups.size(); ++id)
        if (const std::string members = members_of(control, id); !members.empty())
            groups.push_back({{"name", control.groups[id].name}, {"members", members}});
    for (const VariableRange* range : facts.variables)
        variables.push_back({{"first", range->first},
                             {"last", range->last},
                             {"what", range->what},
                             {"writable", range->on_write != OnWrite::forbidden},
                             {"source", range->source}});
    Json options = Json::array();
    for (const ControlOption& option : control.options)
        if (option.is_for(control.machine))
            options.push_back({{"name", option.name},
                               {"codes", option.codes},
                               {"what", option.what},
                               {"source", option.source}});
    json["limits"] = std::move(limits);
    json["chapters"] = std::move(chapters);
    json["modal_groups"] = std::move(groups);
    json["variable_ranges"] = std::move(variables);
    json["options"] = std::move(options);
    return json.dump(2) + "\n";
}

std::string plain_control_page(const ControlModel& control, const PageStyle& style) {
    const ControlFacts facts = facts_of(control);
    PlainPage page(style);
    page.add_title(control.name, control.description);
    page.add(machine_of(control) + (control.assumed ? "; assumed where nobody names a control" : ""));
    if (!facts.limits.empty()) page.add_heading("Limits:");
    for (const auto& [what, limit] : facts.limits)
        page.add_item(std::string(what) + ": " + std::to_string(limit));
    page.add_heading("Codes, by chapter ('maclint explain G1 --control " + control.name + "'):");
    for (const ChapterFacts& chapter : facts.chapters)
        page.add_item(std::string(chapter.chapter) + ": " + list_of(chapter.codes));
    if (facts.chapters.empty()) page.add_item("none");
    page.add_heading("Modal groups:");
    for (std::size_t id = 0; id < control.groups.size(); ++id)
        if (const std::string members = members_of(control, id); !members.empty())
            page.add_item(std::string(control.groups[id].name) + ": " + members);
    if (!control.options.empty())
        page.add_heading("Options (which are fitted, \"options\" in the configuration tells):");
    for (const ControlOption& option : control.options)
        if (option.is_for(control.machine))
            page.add_item(std::string(option.name) + ": " + std::string(option.what) + " (" +
                          std::string(option.codes) + ")");
    if (!facts.variables.empty()) page.add_heading("Variables:");
    for (const VariableRange* range : facts.variables)
        page.add_item(numbers_of(*range) + ": " + std::string(range->what) +
                      (range->on_write == OnWrite::forbidden ? ", can only be read" : ""));
    page.add_heading("Alarms:");
    page.add_item(control.alarms.empty()
                      ? std::string("no list is known")
                      : std::string(control.alarms) + ": " + counted(facts.alarms, "number") + ", " +
                            std::to_string(facts.alarms_found) + " of them found");
    return page.take();
}

} // namespace maclint::cli
