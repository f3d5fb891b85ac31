//! Reads the words of the blocks that are run.
#include "analyzer/execution/outputs.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/overloaded.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <optional>
#include <variant>

namespace maclint::execution {

const WordTexts::OfProgram& WordTexts::of(const Program& program) {
    const auto [known, fresh] = programs_.try_emplace(&program);
    if (!fresh) return known->second;
    OfProgram& texts = known->second;
    const auto every_block = [](const WordSummary&) { return true; };
    for_each_block_with_words(program, every_block,
                              [&](const BlockView& block, std::span<const Word> words, const WordSummary*) {
                                  for (const Word& word : words)
                                      if (const auto* literal = std::get_if<Literal>(&word.value))
                                          texts.literal_words[block.span.begin].push_back(
                                              {word.address, std::bit_cast<std::uint64_t>(literal->value)});
                                      else if (const auto* computed = std::get_if<ExpressionId>(&word.value))
                                          texts.addresses.emplace(*computed, word.address);
                              });
    return texts;
}

namespace {

/// Whether the effect stores in a variable, of which there is an event of its own.
bool is_for_variable(const Program& program, std::optional<EffectId> effect) {
    const auto* assign = effect ? std::get_if<Assign>(&program.effects[*effect].what) : nullptr;
    return assign != nullptr && !std::holds_alternative<StoreMachine>(assign->target);
}

} // namespace

void Outputs::observe(const Stepper& stepper, const Event& event) {
    const Program& program = stepper.program().program();
    const auto note = [](std::vector<Given>& list, std::string_view what, double value) {
        list.push_back({what, std::bit_cast<std::uint64_t>(value)});
    };
    std::visit(overloaded{
                   [&](const BlockBegins& block) {
                       const auto& literal = texts_->of(program).literal_words;
                       const auto words = literal.find(block.span.begin);
                       if (words != literal.end())
                           given_.insert(given_.end(), words->second.begin(), words->second.end());
                   },
                   [&](const EffectBegins& begun) {
                       const Effect& effect = program.effects[begun.effect];
                       if (std::holds_alternative<Exchange>(effect.what))
                           note(given_, program.slice(effect.span), 0);
                   },
                   [&](const ValueTaken& value) {
                       if (!value.content || is_for_variable(program, stepper.effect())) return;
                       const auto& addresses = texts_->of(program).addresses;
                       const auto address = addresses.find(value.expression);
                       note(given_, address == addresses.end() ? std::string_view{} : address->second,
                            *value.content);
                   },
                   [&](const execution::Stored& stored) {
                       const bool is_local =
                           stepper.program().control().spaces[stored.variable.space].scope == Scope::frame;
                       if (is_local && stepper.depth() != 0) return;
                       const auto seen = [&](Content content) {
                           return is_local ? Content{content.value_or(0)} : content;
                       };
                       const auto key = std::uint64_t{stored.variable.space} << 32U |
                                        static_cast<std::uint32_t>(stored.variable.number);
                       stored_.try_emplace(key, Stored{seen(stored.old), {}}).first->second.now =
                           seen(stored.content);
                   },
                   [&](const ProgramLeft& left) {
                       if (stepper.depth() == 0) left_ = left.how;
                   },
                   [](const auto&) {},
               },
               event);
}

std::vector<std::pair<std::uint64_t, Content>> Outputs::changed() const {
    std::vector<std::pair<std::uint64_t, Content>> changed;
    for (const auto& [key, stored] : stored_)
        if (stored.before != stored.now) changed.emplace_back(key, stored.now);
    return changed;
}

bool Outputs::begins_like(const Outputs& other) const {
    return gives_no_more_than(other) || other.gives_no_more_than(*this);
}

bool Outputs::gives_no_more_than(const Outputs& other) const {
    return given_.size() <= other.given_.size() &&
           std::equal(given_.begin(), given_.end(), other.given_.begin());
}

} // namespace maclint::execution
