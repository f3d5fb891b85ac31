//! Made from the families of variables that controls have.
#include "cli/report/variable_page.hpp"

#include "analyzer/dialect/dialect.hpp"
#include "cli/report/speaking_rules.hpp"
#include "rules/listed.hpp"

#include <algorithm>
#include <charconv>
#include <utility>
#include <vector>

namespace maclint::cli {
namespace {

const VariableRange* range_on(const ControlModel& control, std::int64_t number) {
    for (const VariableFamily& family : control.families)
        if (family.name == "#") return family.find(number);
    return nullptr;
}

std::string what_it_is(const ControlModel& control, const VariableRange& range) {
    switch (range.meaning) {
    case Meaning::null: return "always vacant";
    case Meaning::absent: return "no control that is known has it";
    case Meaning::variable: return scope_of(control.spaces[range.space]);
    case Meaning::modal: return "reads what is in force of: " + std::string(control.groups[range.group].name);
    case Meaning::machine: return "a value of the machine";
    }
    return {};
}

std::string writing(const ControlModel& control, const VariableRange& range) {
    switch (range.on_write) {
    case OnWrite::store: return "may be written";
    case OnWrite::set_modal:
        return "may be written, which sets: " + std::string(control.groups[range.group].name);
    case OnWrite::alarm: return "writing it stops the program with an alarm";
    case OnWrite::pause: return "writing it stops the program until it is started again";
    case OnWrite::forbidden: return range.meaning == Meaning::absent ? "" : "can only be read";
    }
    return {};
}

/// "moves with X or U", for the position of an axis.
std::string axis_of(const VariableRange& range, std::int64_t number) {
    std::string_view axes = range.positions_of;
    for (auto skip = number - range.first; skip > 0 && !axes.empty(); --skip)
        axes.remove_prefix(std::min(axes.find(' '), axes.size() - 1) + 1);
    const std::string_view addresses = axes.substr(0, axes.find(' '));
    std::string text;
    for (const char c : addresses) text.append(text.empty() ? "" : " or ").push_back(c);
    return text.empty() ? text : "that of the axis of " + text;
}

std::string values_of(const VariableRange& range) {
    if (range.is_bit) return "0 or 1";
    if (range.last_number)
        return "whole numbers from 0 to " + std::to_string(static_cast<std::int64_t>(*range.last_number));
    return range.may_be_vacant ? "vacant where there is none" : "";
}

struct VariablePage {
    std::string_view what;
    std::vector<std::string> lines;
    std::string_view source;
    friend bool operator==(const VariablePage&, const VariablePage&) = default;
};

VariablePage page_on(const ControlModel& control, const VariableRange& range, std::int64_t number) {
    VariablePage page{range.what, {}, range.source};
    const auto add = [&](std::string line) {
        if (!line.empty()) page.lines.push_back(std::move(line));
    };
    add(what_it_is(control, range));
    if (const auto letter = control.letter_of({range.space, static_cast<std::int32_t>(number)});
        letter && range.meaning == Meaning::variable)
        add("argument " + std::string(1, *letter) + " of a macro call");
    add(axis_of(range, number));
    add(values_of(range));
    add(writing(control, range));
    if (range.changes_by_itself) add("changes without the program");
    return page;
}

std::string names_of(const std::vector<const ControlModel*>& on) {
    std::vector<std::string> names;
    for (const ControlModel* control : on) names.push_back(control->name);
    return rules::listed(names, " and ");
}

} // namespace

std::string scope_of(const VariableSpace& space) {
    std::string text = space.scope == Scope::frame ? "each call of a macro has its own"
                       : space.scope == Scope::shared
                           ? "all programs share it, until the control is switched off"
                           : "all programs share it, and it is kept when the control is switched off";
    if (space.initial_value == InitialValue::vacant) text += "; vacant until something is stored in it";
    return text;
}

std::vector<std::string> facts_of_number(const ControlModel& control, const VariableRange& range,
                                         std::int64_t number) {
    VariablePage page = page_on(control, range, number);
    page.lines.insert(page.lines.begin(), std::string(page.what));
    return std::move(page.lines);
}

std::optional<std::int64_t> variable_number_in(std::string_view word) {
    constexpr std::size_t most_digits = 9;
    if (!word.starts_with('#') || word.size() < 2 || word.size() > most_digits + 1) return std::nullopt;
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(word.data() + 1, word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size() || number < 0) return std::nullopt;
    return number;
}

std::string plain_variable_pages(std::int64_t number, const ControlModel* only, const PageStyle& style) {
    struct Shared {
        VariablePage page;
        std::vector<const ControlModel*> on;
    };
    std::vector<Shared> pages;
    std::size_t known = 0;
    for (const ControlModel* control : controls()) {
        if (only != nullptr && control != only) continue;
        const VariableRange* range = range_on(*control, number);
        if (range == nullptr) continue;
        ++known;
        VariablePage page = page_on(*control, *range, number);
        const auto same = std::ranges::find(pages, page, &Shared::page);
        if (same == pages.end())
            pages.push_back({std::move(page), {control}});
        else
            same->on.push_back(control);
    }
    std::string text;
    for (const auto& [page, on] : pages) {
        PlainPage out(style);
        out.add_title("#" + std::to_string(number) + " " + std::string(page.what),
                      on.size() == known && only == nullptr ? "all controls with such variables"
                                                            : names_of(on));
        out.add_heading("What it is:");
        for (const std::string& line : page.lines) out.add_item(line);
        add_speaking_rules(out, "#" + std::to_string(number), on);
        out.add_heading("Source:");
        out.add_source(page.source);
        text += (text.empty() ? "" : "\n") + out.take();
    }
    return text;
}

} // namespace maclint::cli
