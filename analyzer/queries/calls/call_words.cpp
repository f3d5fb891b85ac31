//! Finds the words of calls by their spans.
#include "analyzer/queries/calls/call_words.hpp"

#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

namespace maclint::queries {
namespace {

/// Whether the word is that code: "G65", "M30".
bool is_code(const Word& word, std::string_view code) {
    const auto* literal = std::get_if<Literal>(&word.value);
    if (literal == nullptr || word.address.size() != 1 || !code.starts_with(word.address)) return false;
    double number = 0;
    const std::string_view digits = code.substr(1);
    const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return end.ec == std::errc() && end.ptr == digits.data() + digits.size() && literal->value == number;
}

/// Whether the name of a kind of calls begins with the word: "G65 macro call".
bool names(const CallKind& kind, const Word& word) {
    return is_code(word, kind.name.substr(0, kind.name.find(' ')));
}

/// The word that makes the call. A macro call takes what stands after it, so its effect begins there; of a
/// code that stands twice each makes a call of its own.
std::optional<std::size_t> code_of(const Effect& effect, const CallKind& kind, std::span<const Word> words,
                                   std::size_t nth) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (!names(kind, words[i])) continue;
        if (kind.frame == Frame::fresh ? words[i].span.begin == effect.span.begin : nth-- == 0) return i;
    }
    return std::nullopt;
}

/// Whether the word makes a macro call.
bool opens_locals(const ControlModel& control, const Word& word) {
    return std::ranges::any_of(
        control.calls, [&](const CallKind& kind) { return kind.frame == Frame::fresh && names(kind, word); });
}

/// Whether the expression is the value of the word.
bool is_value_of(const Program& program, ExpressionId id, const Word& word) {
    return word.span.contains(program.expressions[id].span.begin);
}

} // namespace

std::vector<CallInBlock> calls_with_words(const ProgramAnalysis& analysis) {
    const Program& program = analysis.program();
    std::vector<CallInBlock> found;
    for (const Item& item : program.items) {
        const auto* block = std::get_if<Block>(&item);
        if (block == nullptr || block->effects.count == 0 || block->words.count == 0) continue;
        const auto words = std::span(program.words).subspan(block->words.first, block->words.count);
        std::vector<std::pair<CallKindId, std::size_t>> seen; // subprogram calls of one kind
        for_each_effect_in(program, block->effects, [&](EffectId id) {
            const auto* call = std::get_if<Call>(&program.effects[id].what);
            if (call == nullptr) return;
            const CallKind& kind = analysis.control().calls[call->kind];
            auto known = std::ranges::find(seen, call->kind, &std::pair<CallKindId, std::size_t>::first);
            if (known == seen.end()) known = seen.insert(seen.end(), {call->kind, 0});
            const auto code = code_of(program.effects[id], kind, words, known->second++);
            if (!code) return;
            std::size_t end = *code + 1;
            while (end < words.size() && !opens_locals(analysis.control(), words[end])) ++end;
            found.push_back({id, *call, kind, block->span, words, *code, end});
        });
    }
    return found;
}

const Argument* argument_of(const Program& program, const CallInBlock& call, const Word& word) {
    const auto arguments = program.arguments_of(call.call);
    const auto found = std::ranges::find(arguments, word.span, &Argument::span);
    return found == arguments.end() ? nullptr : &*found;
}

CallPart part_of(const Program& program, const CallInBlock& call, const Word& word) {
    if (word.span == call.code_word().span) return CallPart::code;
    if (const auto* number = std::get_if<ExpressionId>(&call.call.program);
        number != nullptr && is_value_of(program, *number, word))
        return CallPart::program;
    if (const auto* name = std::get_if<Text>(&call.call.program);
        name != nullptr && word.span.contains(name->characters.begin))
        return CallPart::program;
    if (call.call.repeat && is_value_of(program, *call.call.repeat, word)) return CallPart::repeat;
    return argument_of(program, call, word) != nullptr ? CallPart::argument : CallPart::none;
}

bool call_twice(const ControlModel& control, std::span<const Word> words) {
    return std::ranges::count_if(words, [&](const Word& word) {
               return std::ranges::any_of(control.calls,
                                          [&](const CallKind& kind) { return names(kind, word); });
           }) > 1;
}

bool ends_program(const ControlModel& control, const Word& word) {
    constexpr double without_rewinding = 2;
    const auto* literal = std::get_if<Literal>(&word.value);
    return is_code(word, control.return_word) || is_code(word, control.end_word) ||
           (word.address == control.functions.address && literal != nullptr &&
            literal->value == without_rewinding);
}

bool begins_cycle(const ControlModel& control, const Word& word) {
    const auto* code = std::get_if<Literal>(&word.value);
    if (word.address != "G" || code == nullptr) return false;
    const auto group = control.group_of('G', code->value);
    return group && control.groups[*group].role == ModalRole::cycle &&
           control.groups[*group].cancel != code->value;
}

bool can_be_passed(const ControlModel& control, Variable variable) {
    const auto holds = [&](const auto& variables) {
        return std::ranges::find(variables, variable) != std::ranges::end(variables);
    };
    return holds(control.formals) || std::ranges::any_of(control.series, holds);
}

} // namespace maclint::queries
