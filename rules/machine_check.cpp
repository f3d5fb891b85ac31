//! What a step is for messages.
#include "rules/machine_check.hpp"

#include "analyzer/program/model.hpp"
#include "rules/path.hpp"

#include <algorithm>
#include <string_view>
#include <variant>

namespace maclint {
namespace {

/// The block that begins there, up to the end of its line, or to a comment in it.
Span line_at(const Program& program, Offset begin) {
    const syntax::PlainTables* tables = program.plain_tables[0];
    const auto ends = [&](char c) {
        return c == '\r' || c == '\n' ||
               (tables != nullptr &&
                tables->bytes[static_cast<unsigned char>(c)].start == syntax::PlainStart::comment);
    };
    const std::string_view rest = program.text.substr(begin);
    const std::string_view line =
        rest.substr(0, static_cast<std::size_t>(std::ranges::find_if(rest, ends) - rest.begin()));
    const std::size_t last = line.find_last_not_of(" \t");
    return {begin, begin + static_cast<Offset>(last == std::string_view::npos ? 0 : last + 1)};
}

} // namespace

std::string MachineStep::quoted_block() const {
    const Span words = step.words.span();
    return quoted(analysis.program(), words.empty() ? block() : words);
}

Span MachineStep::place_of(char letter) const {
    const Word* word = letter == 0 ? nullptr : step.words.word(letter);
    return word == nullptr ? block() : word->span;
}

std::optional<double> MachineStep::off(ModalRole role) const {
    return machine::code_off(analysis.control(), role);
}

bool MachineStep::is_on(const machine::State& state, ModalRole role) const {
    return machine::is_surely_on(state, analysis.control(), role);
}

std::string MachineStep::spelled(const machine::State& state, ModalRole role) const {
    return analysis.control().spell(*analysis.control().group_with(role), state.of(role).value);
}

Span MachineStep::block_of(const machine::Known& set) const { return line_at(analysis.program(), set.block); }

std::vector<const machine::Left*> MachineStep::called() const {
    std::vector<const machine::Left*> called;
    if (!step.calls) return called;
    for (EffectId id = step.block.effects.first; id < step.block.effects.first + step.block.effects.count;
         ++id)
        if (std::holds_alternative<Call>(analysis.program().effects[id].what))
            if (const machine::Left* left = analysis.machine().left_by_call(id)) called.push_back(left);
    return called;
}

RelatedLocation MachineStep::at(const machine::Known& set, std::string text) const {
    return {analysis.source(), block_of(set), std::move(text)};
}

std::string MachineStep::line_of(const machine::Known& set) const {
    return line_number(analysis.file(), set.block);
}

} // namespace maclint
