//! Look-ups in the program model and its tables.
#include "analyzer/program/model.hpp"

#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace maclint {
namespace {

template<class Entry>
std::span<const Entry> part_of(const std::vector<Entry>& arena, Slice slice) {
    return std::span(arena).subspan(slice.first, slice.count);
}

} // namespace

const VariableRange* VariableFamily::find(std::int64_t number) const {
    const auto after =
        std::upper_bound(ranges.begin(), ranges.end(), number,
                         [](std::int64_t n, const VariableRange& range) { return n < range.first; });
    if (after == ranges.begin()) return nullptr;
    const VariableRange& range = *std::prev(after);
    return number <= range.last ? &range : nullptr;
}

std::optional<GroupId> group_with(ModalRole role, std::span<const ModalGroup> groups) {
    const auto row = std::ranges::find(groups, role, &ModalGroup::role);
    return row == groups.end() ? std::nullopt : std::optional(static_cast<GroupId>(row - groups.begin()));
}

ControlModel checked(ControlModel control) {
    if (control.spaces.size() > most_spaces)
        throw std::logic_error("the control '" + control.name + "' has " +
                               std::to_string(control.spaces.size()) +
                               " spaces of variables, and the analysis has room for " +
                               std::to_string(most_spaces) + ": raise most_spaces");
    if (control.switches.size() > most_switches)
        throw std::logic_error("the control '" + control.name + "' has " +
                               std::to_string(control.switches.size()) +
                               " switches, and the analysis has room for " + std::to_string(most_switches) +
                               ": raise most_switches");
    if (control.groups.size() > syntax::most_groups)
        throw std::logic_error("the control '" + control.name + "' has " +
                               std::to_string(control.groups.size()) +
                               " modal groups, and the plain lane has room for " +
                               std::to_string(syntax::most_groups) + ": raise most_groups");
    control.ended_groups.clear();
    for (std::size_t group = 0; group < control.groups.size(); ++group) {
        const ModalGroup& row = control.groups[group];
        const auto by = row.ended_by ? control.group_with(*row.ended_by) : std::nullopt;
        if (by && row.cancel) control.ended_groups.push_back({*by, static_cast<GroupId>(group), *row.cancel});
    }
    return control;
}

const ControlModel* ControlModel::lathe_of(char system) const {
    const auto found = std::ranges::find(lathes, system, &ControlModel::code_system);
    return found == lathes.end() ? nullptr : *found;
}

bool ControlModel::has(Capability capability) const {
    const auto starts_as = [&](InitialValue initial_value) {
        return std::ranges::find(spaces, initial_value, &VariableSpace::initial_value) != spaces.end();
    };
    switch (capability) {
    case Capability::loop_numbers: return limits.last_loop_number != 0;
    case Capability::sections: return !sections.empty();
    case Capability::exclusive_words: return !repeatable.empty();
    case Capability::vacancy: return starts_as(InitialValue::vacant);
    case Capability::unset_locals:
        return std::ranges::any_of(spaces, [](const VariableSpace& space) {
            return space.scope == Scope::frame && (space.initial_value == InitialValue::vacant ||
                                                   space.initial_value == InitialValue::undefined);
        });
    case Capability::undefined_variables: return starts_as(InitialValue::undefined);
    case Capability::jumps: return loops_left_by_jump; // the one thing that a table tells of them
    case Capability::sequence_numbers: return loops_left_by_jump || !references.empty();
    case Capability::block_if: return has_block_if;
    case Capability::paired_words: return !region_words.empty();
    case Capability::block_references: return !references.empty();
    case Capability::macro_calls: return limits.macro_calls != 0;
    case Capability::modal_calls:
        return std::ranges::any_of(calls,
                                   [](const CallKind& kind) { return kind.trigger != CallTrigger::once; });
    case Capability::named_arguments:
        return std::ranges::any_of(spaces,
                                   [](const VariableSpace& space) { return !space.fixed_names.empty(); });
    case Capability::suppression:
        return std::ranges::find(groups, RestorePolicy::suppression, &ModalGroup::restore_policy) !=
               groups.end();
    }
    return false;
}

bool MachineFunctions::may_stop_look_ahead(double number) const {
    const auto holds = [&](const Range& range) { return range.first <= number && number <= range.last; };
    return !stopping || std::ranges::any_of(*stopping, holds);
}

std::optional<GroupId> ControlModel::group_with(ModalRole role) const {
    return maclint::group_with(role, groups);
}

std::optional<GroupCode> ControlModel::member_of(char letter, double code) const {
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const ModalGroup& group = groups[i];
        if (group.letter != letter) continue;
        const auto member = std::ranges::find(group.members, code, &ModalMember::written_code);
        if (member != group.members.end()) return GroupCode{static_cast<GroupId>(i), member->number};
    }
    return std::nullopt;
}

std::optional<GroupId> ControlModel::group_of(char letter, double code) const {
    const auto member = member_of(letter, code);
    return member ? std::optional(member->group) : std::nullopt;
}

std::string ControlModel::spell(GroupId group, double code) const {
    const auto& members = groups[group].members;
    const auto member = std::ranges::find(members, code, &ModalMember::number);
    if (member != members.end() && !member->spelling.empty()) return std::string(member->spelling);
    std::array<char, 32> digits{};
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), code);
    std::string text(digits.data(), error == std::errc{} ? end : digits.data());
    if (groups[group].letter == '#') return text;
    return groups[group].letter + text;
}

std::optional<char> ControlModel::letter_of(Variable variable) const {
    const auto formal = std::ranges::find(formals, variable);
    const auto index = static_cast<std::size_t>(formal - formals.begin());
    return index < formal_letters.size() ? std::optional(formal_letters[index]) : std::nullopt;
}

std::optional<std::string> ControlModel::variable_of(GroupId group) const {
    for (const VariableFamily& family : families)
        for (const VariableRange& range : family.ranges)
            if (range.meaning == Meaning::modal && range.group == group)
                return std::string(family.name) + std::to_string(range.first);
    return std::nullopt;
}

std::span<const ExpressionId> Program::operands_of(const Apply& apply) const {
    return part_of(operands, apply.operands);
}

std::span<const ExpressionId> Program::values_of(const EvaluateWords& values) const {
    return part_of(operands, values.values);
}

std::span<const ExpressionId> Program::values_of(const Exchange& exchange) const {
    return part_of(operands, exchange.out);
}

std::span<const ExpressionId> Program::indices_of(const ForeignElement& element) const {
    return part_of(operands, element.indices);
}

std::span<const Variable> Program::variables_of(const Exchange& exchange) const {
    return part_of(variables, exchange.in);
}

std::span<const Variable> Program::variables_of(const UnreadableBlock& block) const {
    return part_of(variables, block.may_write);
}

std::span<const Label> Program::labels_of(const UnreadableBlock& block) const {
    return part_of(labels, block.may_jump);
}

std::span<const Effect> Program::effects_in(Slice slice) const { return part_of(effects, slice); }

std::span<const Argument> Program::arguments_of(const Call& call) const {
    return part_of(arguments, call.arguments);
}

Span Program::span_of(ItemId item) const {
    return std::visit([](const auto& part) { return part.span; }, items[item]);
}

bool Program::is_formal(Variable variable) const {
    return std::ranges::find(control->formals, variable) != control->formals.end() ||
           std::ranges::find(formals, variable, &Formal::variable) != formals.end();
}

const Declaration* Program::declaration_of(Variable variable) const {
    if (declarations.empty()) return nullptr;
    const auto found = declarations.find(variable);
    return found == declarations.end() ? nullptr : &found->second;
}

VariableType Program::type_of(Variable variable) const {
    const Declaration* declaration = declaration_of(variable);
    return declaration == nullptr ? control->spaces[variable.space].type : declaration->type;
}

std::string Program::spell(const Label& label) const {
    if (const auto* name = std::get_if<BlockName>(&label)) return std::string(block_names[name->number]);
    return 'N' + std::to_string(std::get<std::int64_t>(label));
}

Channels Program::channels_of(ItemId item) const {
    const auto* block = std::get_if<Block>(&items[item]);
    if (block != nullptr && block->channels != 0) return block->channels;
    const auto after = std::ranges::upper_bound(sections, item, {},
                                                [](const Section& section) { return section.items.first; });
    if (after == sections.begin() || std::prev(after)->channels == 0) return channels;
    return std::prev(after)->channels;
}

Variable Program::meant_by(Variable variable) const {
    const auto alias = aliases.find(variable);
    return alias == aliases.end() ? variable : alias->second;
}

std::string Program::spell(Variable variable) const {
    const VariableSpace& space = control->spaces[variable.space];
    const auto index = static_cast<std::size_t>(variable.number);
    if (index < space.fixed_names.size())
        return std::string(space.prefix) + std::string(space.fixed_names[index]);
    if (space.named)
        return std::string(space.prefix)
            .append(space.scope == Scope::frame ? names[variable.number] : shared_names[variable.number]);
    return std::string(space.prefix) + std::to_string(variable.number);
}

std::span<const SyntaxError> ProgramFile::syntax_errors_in(Span span) const {
    const auto begin = [](const SyntaxError& error) { return error.span.begin; };
    const auto first = std::ranges::lower_bound(syntax_errors, span.begin, {}, begin);
    return {first, std::ranges::lower_bound(first, syntax_errors.end(), span.end, {}, begin)};
}

void Program::fit() {
    items.shrink_to_fit();
    expressions.shrink_to_fit();
    operands.shrink_to_fit();
    effects.shrink_to_fit();
    words.shrink_to_fit();
    arguments.shrink_to_fit();
    variables.shrink_to_fit();
    labels.shrink_to_fit();
    settings.shrink_to_fit();
    code_words.shrink_to_fit();
}

} // namespace maclint
