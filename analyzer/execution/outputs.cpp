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
                   [&](const Stored& stored) {
                       // Of a local it shows in what is done with it whether it is 0 or vacant.
                       const bool is_local =
                           stepper.program().control().spaces[stored.variable.space].scope == Scope::frame;
                       if (is_local ? stored.old.value_or(0) == stored.content.value_or(0)
                                    : stored.old == stored.content)
                           return;
                       note(stored_, {}, static_cast<double>(stored.variable.number));
                       note(stored_, {}, stored.content.value_or(-0.0)); // no number that is stored is -0
                   },
                   [&](const ProgramLeft& left) {
                       if (stepper.depth() == 0) left_ = left.how;
                   },
                   [](const auto&) {},
               },
               event);
}

bool Outputs::begins_like(const Outputs& other) const {
    const auto is_alike = [](const std::vector<Given>& a, const std::vector<Given>& b) {
        const auto shorter = static_cast<std::ptrdiff_t>(std::min(a.size(), b.size()));
        return std::equal(a.begin(), a.begin() + shorter, b.begin());
    };
    return is_alike(given_, other.given_) && is_alike(stored_, other.stored_);
}

bool Outputs::gives_no_more_than(const Outputs& other) const {
    return given_.size() <= other.given_.size() &&
           std::equal(given_.begin(), given_.end(), other.given_.begin());
}

} // namespace maclint::execution
