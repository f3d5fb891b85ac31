//! Looks at the effects and codes of a block.
#include "analyzer/queries/words/block_words.hpp"

#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <variant>

namespace maclint::queries {

bool has_modal_calls(const Program& program) {
    return std::ranges::any_of(program.effects, [&](const Effect& effect) {
        const auto* call = std::get_if<Call>(&effect.what);
        return call != nullptr && program.control->calls[call->kind].trigger != CallTrigger::once;
    });
}

bool has_alternatives(const WordsOfBlock& block) {
    return std::ranges::any_of(
        block.analysis.program().effects_in(block.block.effects),
        [](const Effect& effect) { return std::holds_alternative<Guarded>(effect.what); });
}

namespace {

/// Whether a code takes the word for itself.
bool takes(const ControlModel& control, double code, const Word& word) {
    constexpr std::string_view of_moves = "ABCFIJKRUVWXYZ";
    const auto group = control.group_of('G', code);
    if (!group) return true;
    switch (control.groups[*group].role) {
    case ModalRole::plane:
    case ModalRole::distance:
    case ModalRole::units:
    case ModalRole::feed_mode:
    case ModalRole::work_offset:
    case ModalRole::offset_suspension:
    case ModalRole::return_level:
    case ModalRole::cutting_mode: return false;
    case ModalRole::motion:
        return word.address.size() > 1 || of_moves.find(word.address) != std::string_view::npos;
    default: return true;
    }
}

} // namespace

bool may_belong_to_another(const WordsOfBlock& block, const Word& code, const Word& word) {
    const ControlModel& control = block.analysis.control();
    return std::ranges::any_of(block.words, [&](const Word& other) {
        const auto* number = std::get_if<Literal>(&other.value);
        return &other != &code && other.address == "G" &&
               (number == nullptr || takes(control, number->value, word));
    });
}

bool calls(const WordsOfBlock& block) {
    const auto is_call = [](const Effect& effect) { return std::holds_alternative<Call>(effect.what); };
    const auto is_computed = [](const Word& word) {
        return (word.address == "G" || word.address == "M") && !std::holds_alternative<Literal>(word.value);
    };
    return std::ranges::any_of(block.analysis.program().effects_in(block.block.effects), is_call) ||
           std::ranges::any_of(block.words, is_computed);
}

bool may_call(const WordsOfBlock& block) {
    const ControlModel& control = block.analysis.control();
    const auto unknown = [&](const Word& word) {
        if (word.address != "G" && word.address != "M") return false;
        const auto* code = std::get_if<Literal>(&word.value);
        return code != nullptr && !control.group_of(word.address.front(), code->value);
    };
    return block.modal_calls || calls(block) || std::ranges::any_of(block.words, unknown);
}

} // namespace maclint::queries
