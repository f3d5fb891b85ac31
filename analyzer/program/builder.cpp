//! Fills the arenas of a program.
#include "analyzer/program/builder.hpp"

#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

namespace maclint {
namespace {

/// Where the next entry of an arena goes.
template<class Entry>
Id end_of(const std::vector<Entry>& arena) {
    return static_cast<Id>(arena.size());
}

/// Appends to an arena and tells where.
template<class Entry, class Entries>
Slice append(std::vector<Entry>& arena, const Entries& entries) {
    const Slice slice{end_of(arena), static_cast<Id>(entries.size())};
    arena.insert(arena.end(), entries.begin(), entries.end());
    return slice;
}

} // namespace

ProgramBuilder::ProgramBuilder(std::string name, std::string_view text, const ControlModel& control) {
    program_.name = std::move(name);
    program_.text = text;
    program_.control = &control;
}

std::int32_t ProgramBuilder::number_of_name(SpaceId space, std::string_view name) {
    return program_.control->spaces[space].scope == Scope::frame ? program_.names.number_of(name)
                                                                 : program_.shared_names.number_of(name);
}

Program ProgramBuilder::take() {
    end_section();
    program_.fit();
    if (!program_.items.empty())
        program_.span = {program_.span_of(0).begin, program_.span_of(end_of(program_.items) - 1).end};
    else if (!program_.sections.empty())
        program_.span = program_.sections.front().heading;
    if (program_.name_span.empty()) program_.name_span = {program_.span.begin, program_.span.begin};
    return std::move(program_);
}

void ProgramBuilder::add_name(std::string_view name) {
    std::vector<std::string>& names = program_.also_known_as;
    if (name != program_.name && std::ranges::find(names, name) == names.end()) names.emplace_back(name);
}

void ProgramBuilder::begin_section(std::string_view kind, Section::Executed executed, Span heading) {
    end_section();
    program_.sections.push_back({kind, {end_of(program_.items), 0}, executed, heading});
}

void ProgramBuilder::end_section() {
    if (program_.sections.empty()) return;
    Slice& items = program_.sections.back().items;
    items.count = end_of(program_.items) - items.first;
}

ExpressionId ProgramBuilder::add(Expression expression) {
    program_.expressions.push_back(expression);
    return end_of(program_.expressions) - 1;
}

ExpressionId ProgramBuilder::apply(Operation operation, std::span<const ExpressionId> operands, Span span) {
    return add({Apply{operation, add_operands(operands)}, span});
}

ExpressionId ProgramBuilder::widen(ExpressionId id, Span span) {
    program_.expressions[id].span = span;
    return id;
}

ExpressionId ProgramBuilder::negate_literal(ExpressionId id, Span span) {
    auto* number = std::get_if<Literal>(&program_.expressions[id].node);
    assert(number != nullptr && "only a literal has a sign of its own");
    if (number->value != 0) number->value = -number->value;
    return widen(id, span);
}

std::optional<double> ProgramBuilder::literal_value(ExpressionId id) const {
    const auto* literal = std::get_if<Literal>(&program_.expressions[id].node);
    return literal == nullptr ? std::nullopt : std::optional(literal->value);
}

void ProgramBuilder::begin_block() {
    first_word_ = end_of(program_.words);
    effects_.clear();
}

void ProgramBuilder::end_block(Block block) {
    block.words = {first_word_, end_of(program_.words) - first_word_};
    block.effects = {end_of(program_.effects), end_of(effects_)};
    std::ranges::move(effects_, std::back_inserter(program_.effects));
    effects_.clear();
    add_channels(block.channels);
    program_.items.emplace_back(block);
}

void ProgramBuilder::replace_effects(ItemId block) {
    Slice& own = std::get<Block>(program_.items[block]).effects;
    // Who looks through all effects finds each once.
    for (Id id = own.first; id < own.first + own.count; ++id) program_.effects[id].what = EvaluateWords{};
    own = {end_of(program_.effects), end_of(effects_)};
    std::ranges::move(effects_, std::back_inserter(program_.effects));
    effects_.clear();
}

void ProgramBuilder::add_run(PlainRun run, std::span<const ModalSetting> net,
                             std::span<const CodeWords> beside_codes) {
    run.net = append(program_.settings, net);
    run.beside_codes = append(program_.code_words, beside_codes);
    program_.items.emplace_back(run);
}

void ProgramBuilder::add_values(std::span<const ExpressionId> values, Span span) {
    if (!values.empty()) add_effect({EvaluateWords{add_operands(values)}, span});
}

void ProgramBuilder::add_exchange(std::span<const ExpressionId> out, std::span<const Variable> in,
                                  Span span) {
    add_effect({Exchange{add_operands(out), append(program_.variables, in)}, span});
}

void ProgramBuilder::add_unreadable(const NamedInBlock& named, Span span) {
    add_effect(
        {UnreadableBlock{append(program_.variables, named.variables), append(program_.labels, named.labels),
                         named.may_open_or_close, named.may_call_or_return},
         span});
}

Slice ProgramBuilder::add_arguments(std::span<const Argument> arguments) {
    return append(program_.arguments, arguments);
}

Slice ProgramBuilder::add_operands(std::span<const ExpressionId> operands) {
    return append(program_.operands, operands);
}

void ProgramBuilder::guard(ExpressionId condition, std::size_t first, Span span) {
    assert(first <= effects_.size());
    const auto begin = effects_.begin() + static_cast<std::ptrdiff_t>(first);
    const Slice slice{end_of(program_.effects), static_cast<Id>(effects_.end() - begin)};
    std::move(begin, effects_.end(), std::back_inserter(program_.effects));
    effects_.erase(begin, effects_.end());
    add_effect({Guarded{condition, slice}, span});
}

} // namespace maclint
