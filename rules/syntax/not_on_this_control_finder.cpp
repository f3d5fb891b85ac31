//! Looks for the letters that the configuration does not name.
#include "rules/syntax/not_on_this_control_finder.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/machine_words.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <variant>

namespace maclint::rules {
namespace {

/// "A B" of a machine with X, Y and Z.
std::string missing_letters(const ControlModel& control) {
    const bool lathe = control.machine == Machine::lathe;
    std::string missing;
    for (const char letter : lathe ? std::string_view("YV") : letters_of_axes) {
        const char axis = lathe ? 'Y' : letter; // V is an increment of Y
        if (control.axes.find(axis) != std::string::npos) continue;
        missing.append(missing.empty() ? "" : " ").push_back(letter);
    }
    return missing;
}

/// Whether the axes beside the code are axes.
bool takes_axes(const ControlModel& control, const Word& word) {
    constexpr std::array once = {28.0, 29.0, 30.0, 52.0, 53.0, 92.0};
    const auto* code = std::get_if<Literal>(&word.value);
    if (code == nullptr) return false;
    const auto group = control.group_of('G', code->value);
    if (!group) return std::ranges::find(once, code->value) != once.end();
    const ModalRole role = control.groups[*group].role;
    return role != ModalRole::macro_call && role != ModalRole::rotation && role != ModalRole::other;
}

bool calls_program(const Program& program, const BlockView& block) {
    return std::ranges::any_of(program.effects_in(block.effects), [](const Effect& effect) {
        return std::holds_alternative<Call>(effect.what);
    });
}

} // namespace

void for_each_missing_axis(const Program& program, const std::function<void(const Word&)>& visit) {
    const ControlModel& control = *program.control;
    if (control.axes.empty()) return;
    const std::string letters = missing_letters(control);
    if (letters.empty()) return;
    const syntax::AddressSet missing = addresses_named(program, letters);
    for_each_block_with_words(
        program, [&](const WordSummary& summary) { return summary.addresses.meets(missing); },
        [&](const BlockView& block, std::span<const Word> words, const WordSummary*) {
            const bool others = std::ranges::any_of(
                words, [&](const Word& word) { return word.address == "G" && !takes_axes(control, word); });
            if (others || calls_program(program, block)) return;
            for (const Word& word : words)
                if (word.address.size() == 1 && word.has_value() &&
                    letters.find(word.address) != std::string::npos)
                    visit(word);
        });
}

} // namespace maclint::rules
