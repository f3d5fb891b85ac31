//! The control, its limits, variables and calls.
#include "analyzer/dialect/dinplus/tables.hpp"

#include "analyzer/dialect/dinplus/tables_parts.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <utility>

namespace maclint::dinplus {
namespace {

constexpr std::string_view family_letters = "lxcginmdewta"; // in the order of namespace families
constexpr std::int32_t most = 999'999;

std::string lower(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

VariableRange variables(std::int32_t first, std::int32_t last, SpaceId space, std::string_view what,
                        std::string_view source) {
    return {first, last, Meaning::variable, space, 0, OnWrite::store, false, what, source};
}

/// A value that the control owns; `itself`: it may change while a loop waits for it.
VariableFamily owned(std::string_view name, bool itself, std::string_view what, std::string_view source) {
    return {name,
            {{.first = 0,
              .last = most,
              .meaning = Meaning::machine,
              .space = spaces::machine,
              .group = 0,
              .on_write = itself ? OnWrite::forbidden : OnWrite::store,
              .changes_by_itself = itself,
              .what = what,
              .source = source,
              .may_be_vacant = true}}}; // l.22325: a probe that touched nothing has no result
}

ControlModel make() {
    ControlModel control;
    control.name = "dinplus";
    control.language = "dinplus";
    control.model = "dinplus";
    control.description = "HEIDENHAIN DIN PLUS";
    control.has_block_if = true;
    control.machine = Machine::lathe; // CNC PILOT, MANUALplus
    control.calculator_input = true;  // all examples of the manual write X80 for 80 mm
    control.assumed = false;
    control.return_word = "RETURN"; // l.2949, l.19944
    // "Chained at most six times" is read as six levels below the main program. No limit of loops is
    // printed; "max. 6 characters" in l.18887 can only mean levels of brackets.
    control.limits = {.macro_calls = 0,
                      .subprogram_calls = 6,
                      .loop_levels = 0,
                      .first_loop_number = 0,
                      .last_loop_number = 0,
                      .bracket_levels = 6,
                      .source = "l.10397, l.19934 (calls); l.18887 (brackets)"};
    control.spaces = variable_spaces();
    control.families = variable_families();
    control.groups = modal_groups();
    control.calls = {
        {"call of a local subprogram", Frame::fresh, NestingLimit::subprogram, CallTrigger::once, 0,
         "l.10403, l.20751", LookupScope::same_file},
        {"call of an external subprogram", Frame::fresh, NestingLimit::subprogram, CallTrigger::once, 0,
         "l.10404, l.19932", LookupScope::other_files},
    };
    for (std::size_t i = 0; i < transfer_letters.size(); ++i)
        control.formals.push_back({spaces::transfer, static_cast<std::int32_t>(i)});
    control.vacant_equals_zero = true;  // l.19721: an undefined variable may read as 0
    control.loops_left_by_jump = false; // the language has no jump [dinplus.md 4.1]; l.19801
    control.sections = section_kinds();
    control.repeatable = {"G", "M"};                  // l.10166, l.21017
    control.contradiction = Contradiction::forbidden; // l.10226
    control.exclusive_codes = exclusive_codes();
    control.switches = switch_rows();
    control.references = {{"contour block", SectionKind::Role::contour, "l.10203, l.13166"}};
    return checked(std::move(control));
}

} // namespace

std::vector<VariableSpace> variable_spaces() {
    // clang-format off
    std::vector<VariableSpace> rows = {
        {"local variable",            "#l",  false, Scope::frame,     InitialValue::undefined, "l.18946, l.19721, l.19941"},
        {"local text variable",       "#x",  false, Scope::frame,     InitialValue::undefined, "l.18959"},
        {"channel variable",          "#c",  false, Scope::shared, InitialValue::undefined, "l.18956, l.19721"},
        {"global variable",           "#g",  false, Scope::retained,  InitialValue::old_value, "l.18957, l.18995"},
        {"transfer value",            "#__", false, Scope::frame,     InitialValue::undefined, "l.19721, l.19742, l.19938"},
        {"named variable",            "#",   true,  Scope::frame,     InitialValue::undefined, "l.2978-2997, l.19452"},
        {"constant",                  "",    true,  Scope::frame,     InitialValue::undefined, "l.2951-2967"},
        {"value of the control",      "#",   false, Scope::machine,   InitialValue::old_value, "l.19032-19387"},
    };
    // clang-format on
    // l.18979: #l1(200) is visible in the programs called from there, and so are the names of VAR [l.19491].
    for (const SpaceId space : {spaces::local, spaces::named, spaces::constant})
        rows[space].handed_down = true;
    rows[spaces::constant].written_once = true;
    rows[spaces::transfer].fixed_names.assign(transfer_letters.begin(), transfer_letters.end());
    return rows;
}

std::vector<VariableFamily> variable_families() {
    // clang-format off
    return {
        {"#l", {variables(1, 99,   spaces::local,      "local variable",      "l.18946")}},
        {"#x", {variables(1, most, spaces::local_text, "local text variable", "l.18959; l.19408 uses #x30")}},
        {"#c", {variables(1, most, spaces::channel,    "channel variable",    "l.18956")}},
        {"#g", {variables(1, most, spaces::global,     "global variable",     "l.18957, l.2723")}},
        owned("#i", true,  "information of the control", "l.19327-19387"),
        owned("#n", true,  "current NC state",           "l.19233-19325"),
        owned("#m", false, "machine dimension",          "l.19032"),
        owned("#d", false, "tool compensation",          "l.19044"),
        owned("#e", true,  "PLC operand",                "l.19069-19091"),
        owned("#w", true,  "tool data",                  "l.19105"),
        owned("#t", true,  "tool diagnosis",             "l.19205"),
        owned("#a", true,  "interpolation data",         "l.18101, l.22327"),
    };
    // clang-format on
}

std::optional<FamilyId> family_of(char letter) {
    const auto row = family_letters.find(static_cast<char>(std::tolower(static_cast<unsigned char>(letter))));
    if (row == std::string_view::npos) return std::nullopt;
    return static_cast<FamilyId>(row);
}

std::optional<Variable> transfer_variable(std::string_view name) {
    std::string letters = lower(name);
    if (letters == "id1" || letters == "at1") letters.pop_back(); // l.8544: as the unit form prints them
    for (const std::string& candidate : {letters, "l" + letters}) {
        const auto* row = std::ranges::find(transfer_letters, std::string_view(candidate));
        if (row != transfer_letters.end())
            return Variable{spaces::transfer, static_cast<std::int32_t>(row - transfer_letters.begin())};
    }
    return std::nullopt;
}

const ControlModel& control() {
    static const ControlModel model = make();
    return model;
}

} // namespace maclint::dinplus
