//! Reads the axis words of the block and of those before it.
#include "rules/modal/chamfer_or_corner_lengths_finder.hpp"

#include "analyzer/program/machine_words.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/words/enclosed_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <variant>

namespace maclint::rules {
namespace {

constexpr double absolute = 90, incremental = 91;

bool is_axis(const Word& word) {
    return word.address.size() == 1 && letters_of_axes.find(word.address) != std::string_view::npos;
}

/// Whether nothing but moves and their codes stands there: no call, no shift of zero, no other distance mode.
bool only_moves(const ControlModel& control, const Program& program, const BlockView& block,
                std::span<const Word> words) {
    const auto moves = [](const Effect& effect) {
        return std::holds_alternative<SetModal>(effect.what) || std::holds_alternative<Motion>(effect.what);
    };
    const auto stays = [&](const Word& word) {
        const auto* code = std::get_if<Literal>(&word.value);
        if (word.address != "G") return true;
        const auto group = code == nullptr ? std::nullopt : control.group_of('G', code->value);
        return group && control.groups[*group].role == ModalRole::motion;
    };
    return !block.number && block.skip_levels == 0 &&
           std::ranges::all_of(program.effects_in(block.effects), moves) && std::ranges::all_of(words, stays);
}

/// The last number of the axis before the block.
std::optional<double> position_before(const ProgramAnalysis& analysis, const BlockView& block,
                                      std::string_view axis) {
    constexpr Offset near = 300;
    const Program& program = analysis.program();
    std::optional<double> position;
    // Blocks are read from the beginning of a line.
    const Offset from = std::max(program.span.begin, block.span.begin - std::min(near, block.span.begin));
    const std::size_t line_end = program.text.find_first_of("\n\r", from);
    const Offset begin = from == program.span.begin
                             ? from
                             : static_cast<Offset>(std::min<std::size_t>(line_end, block.span.begin));
    if (queries::first_statement_in(program, {begin, block.span.begin})) return std::nullopt;
    queries::for_each_block_in(
        program, {begin, block.span.begin}, [&](const BlockView& before, std::span<const Word> words) {
            if (!only_moves(analysis.control(), program, before, words)) position.reset();
            for (const Word& word : words) {
                const auto* value = std::get_if<Literal>(&word.value);
                if (word.address == axis)
                    position = value == nullptr ? std::nullopt : std::optional(value->value);
            }
        });
    return position;
}

} // namespace

std::optional<AxisMove> single_move(const ProgramAnalysis& analysis, queries::ModesAt& modes_at,
                                    const BlockView& block, std::span<const Word> words) {
    const ControlModel& control = analysis.control();
    if (std::ranges::count_if(words, is_axis) != 1 || block.skip_levels != 0) return std::nullopt;
    const Word& word = *std::ranges::find_if(words, is_axis);
    const auto* value = std::get_if<Literal>(&word.value);
    if (value == nullptr) return std::nullopt;
    constexpr std::string_view increments = "UVW", their_axes = "XYZ";
    if (const auto at = increments.find(word.address);
        control.machine == Machine::lathe && at != std::string_view::npos)
        return control.code_system == 'A' ? std::optional(AxisMove{their_axes[at], std::abs(value->value)})
                                          : std::nullopt;
    const auto distance = control.group_with(ModalRole::distance);
    const auto mode = distance ? modes_at(block).with_words(*distance).sure_code() : std::optional(absolute);
    if (mode == incremental) return AxisMove{word.address.front(), std::abs(value->value)};
    const auto before = mode == absolute ? position_before(analysis, block, word.address) : std::nullopt;
    return before ? std::optional(AxisMove{word.address.front(), std::abs(value->value - *before)})
                  : std::nullopt;
}

} // namespace maclint::rules
