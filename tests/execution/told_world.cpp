//! Chance by a sum over the question, nothing else.
#include "tests/execution/told_world.hpp"

#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <array>

namespace maclint::test {
namespace {

using semantics::Content;

enum Asked : std::uint64_t { start = 100, group, machine, other, typed, skipped, called };

} // namespace

std::vector<double> numbers_of(const Program& program) {
    std::vector<double> numbers{1, 0, -1, 5, 100, 2.5};
    const auto add = [&](double number) {
        constexpr std::size_t most = 24;
        if (numbers.size() < most && std::ranges::find(numbers, number) == numbers.end())
            numbers.push_back(number);
    };
    for (const Expression& expression : program.expressions) {
        const auto* apply = std::get_if<Apply>(&expression.node);
        if (apply == nullptr || !semantics::is_comparison(apply->operation)) continue;
        for (const ExpressionId operand : program.operands_of(*apply))
            if (const auto* literal = std::get_if<Literal>(&program.expressions[operand].node)) {
                add(literal->value);
                add(literal->value + 1);
                add(literal->value - 1);
            }
    }
    return numbers;
}

double ToldWorld::number(std::uint64_t asked) const {
    return numbers_[mixed({seed_, asked}) % numbers_.size()];
}

bool ToldWorld::one_in(std::uint64_t times, std::uint64_t asked) const {
    return mixed({seed_, ~asked}) % times == 0;
}

std::uint64_t ToldWorld::again(std::uint64_t asked) { return mixed({asked, times_[asked]++}); }

execution::Environment ToldWorld::environment(const ControlModel& control, bool main) {
    times_.clear();
    execution::Environment environment;
    environment.at_start = [this](const Program& program, Variable variable) {
        return at_start(program, variable);
    };
    environment.code_at_start = [this, &control, main](GroupId id) { return code(control, id, main); };
    environment.value_of = [this](const Program& program, ExpressionId id) {
        return value_of(program, program.expressions[id]);
    };
    environment.typed_in = [this](const Program&, Variable variable) {
        return Content{number(again(mixed({Asked::typed, static_cast<std::uint64_t>(variable.number)})))};
    };
    const std::uint64_t switches = mixed({seed_, Asked::skipped});
    environment.skips = [switches](const BlockView& block) { return (block.skip_levels & switches) != 0; };
    environment.unknown_call = [this](const Program& program, CallKindId kind) {
        return unknown_call(program, kind);
    };
    return environment;
}

std::uint64_t question_of(const Program& program, Variable variable) {
    const VariableSpace& space = program.control->spaces[variable.space];
    return mixed(
        {Asked::start, variable.space,
         space.named ? mixed(program.spell(variable)) : static_cast<std::uint64_t>(variable.number)});
}

std::uint64_t question_of(const LoadMachine& owned) {
    return mixed({Asked::machine, owned.family, static_cast<std::uint64_t>(owned.number)});
}

/// In some worlds all of them hold numbers, in some none does.
Content ToldWorld::at_start(const Program& program, Variable variable) const {
    const std::uint64_t asked = question_of(program, variable);
    if (const auto told = told_.find(asked); told != told_.end()) return told->second;
    const std::uint64_t share = mixed({seed_, Asked::start}) % 4;
    const bool may_be_vacant = program.control->spaces[variable.space].scope != Scope::machine;
    const bool vacant = may_be_vacant && (share == 1 || (share > 1 && one_in(3, asked)));
    return vacant ? Content{} : Content{number(asked)};
}

double ToldWorld::code(const ControlModel& control, GroupId id, bool main) const {
    const ModalGroup& group = control.groups[id];
    if (group.reset && (main || group.members.empty() || one_in(3, mixed({Asked::group, 7, id}))))
        return *group.reset;
    const std::uint64_t chance = mixed({seed_, Asked::group, id});
    return group.members.empty() ? static_cast<double>(50 + chance % 400)
                                 : group.members[chance % group.members.size()].number;
}

/// What the machine owns stays as it is in half of the worlds; what is told is so when it is first read.
Content ToldWorld::value_of(const Program& program, const Expression& expression) {
    const auto* owned = std::get_if<LoadMachine>(&expression.node);
    if (owned == nullptr) return number(again(mixed({Asked::other, mixed(program.slice(expression.span))})));
    const std::uint64_t asked = question_of(*owned);
    const auto told = told_.find(asked);
    if (told != told_.end() && times_[asked]++ == 0) return told->second;
    if (told != told_.end() && seed_ % 2 == 0) return told->second;
    const std::uint64_t question = seed_ % 2 == 0 ? asked : again(asked);
    const VariableRange* range = program.control->families[owned->family].find(owned->number);
    if (range != nullptr && range->is_bit) return static_cast<double>(mixed({seed_, question}) % 2);
    if (range != nullptr && range->may_be_vacant && one_in(3, question)) return {};
    return number(question);
}

/// In half of the worlds it does nothing.
execution::UnknownEffects ToldWorld::unknown_call(const Program& program, CallKindId kind) {
    const std::uint64_t asked = again(mixed({Asked::called, kind}));
    execution::UnknownEffects effects;
    if (mixed({seed_, Asked::called}) % 2 == 0) return effects;
    const ControlModel& control = *program.control;
    const bool shares = control.calls[kind].frame == Frame::shared;
    for (const VariableFamily& family : control.families)
        for (const std::int32_t number : {1, 2, 3, 24, 100, 101, 500}) {
            const VariableRange* range = family.find(number);
            const std::uint64_t store = mixed({asked, static_cast<std::uint64_t>(number)});
            if (range == nullptr || range->meaning != Meaning::variable || !one_in(4, store)) continue;
            if (shares || control.spaces[range->space].scope != Scope::frame)
                effects.stores.emplace_back(Variable{range->space, number}, this->number(store));
        }
    for (std::size_t i = 0; i < control.groups.size(); ++i)
        if (control.groups[i].role != ModalRole::macro_call && one_in(6, mixed({asked, 1000 + i})))
            effects.codes.emplace_back(static_cast<GroupId>(i),
                                       code(control, static_cast<GroupId>(i), false));
    effects.stops = one_in(30, asked);
    return effects;
}

} // namespace maclint::test
