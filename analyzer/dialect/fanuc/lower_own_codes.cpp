//! Lowering of codes that the machine's parameters make call programs.
#include "analyzer/dialect/fanuc/lowering.hpp"
#include "analyzer/dialect/fanuc/tables.hpp"
#include "analyzer/program/own_codes.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

namespace maclint::fanuc {
namespace {

/// Where the program that a T word calls finds its number [B-62093E, 3.1.1].
constexpr Variable tool_variable{spaces::common, 149};

} // namespace

/// Within a program that such a code has called the codes are ordinary ones [T: section on macro calls by G
/// code of the manuals].
const CodeTable& BlockLowering::codes() {
    if (codes_in_program_ != nullptr) return *codes_in_program_;
    const ControlModel& control = *program_->control;
    const bool is_called =
        program_->number && std::ranges::any_of(control.own_codes, [&](const OwnCode& code) {
            return code.program == *program_->number;
        });
    codes_in_program_ = is_called ? &usual_codes_of(control) : &codes_;
    return *codes_in_program_;
}

/// What the word calls here, or nullptr.
const OwnCode* BlockLowering::own_call(const NcWord& word) {
    const bool tool = word.letter == tool_letter && word.value;
    const bool other = (word.letter == 'G' || word.letter == 'M') && word.literal;
    if (word.comma || (!tool && !other) || &codes() != &codes_) return nullptr;
    const OwnCode* code = own_code(*program_->control, word.letter, tool ? 0 : *word.literal);
    return code != nullptr && calls_program(*code) ? code : nullptr;
}

/// The other words are arguments, as those of G65 are; false where no word calls.
bool BlockLowering::lower_own_macro(std::span<const NcWord> words, Span span) {
    const auto is_macro = [&](const NcWord& word) {
        const OwnCode* code = own_call(word);
        return code != nullptr && !calls_subprogram(*code);
    };
    const auto word = std::ranges::find_if(words, is_macro);
    if (word == words.end()) return false;
    std::vector<NcWord> others;
    std::ranges::copy_if(words, std::back_inserter(others),
                         [&](const NcWord& other) { return &other != &*word; });
    Call call{literal(static_cast<double>(own_call(*word)->program), this->span(*word->node)), calls::g65,
              arguments_from(others), std::nullopt};
    for (const NcWord& other : others)
        if (other.letter == 'L' && !other.comma && other.value) call.repeat = other.value;
    effect({call, span});
    return true;
}

void BlockLowering::lower_own_subprogram(const NcWord& code, Span span) {
    const OwnCode& own = *own_call(code);
    if (!calls_subprogram(own)) return; // a macro, which the block has called by then
    if (own.letter == tool_letter) effect({Assign{tool_variable, *code.value}, span});
    effect({Call{literal(static_cast<double>(own.program), span), calls::m98, {}, std::nullopt}, span});
}

} // namespace maclint::fanuc
