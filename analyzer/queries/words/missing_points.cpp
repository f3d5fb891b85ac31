//! Counts the words of blocks that only move or wait.
#include "analyzer/queries/words/missing_points.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/machine_words.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/words/block_words.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <variant>

namespace maclint::queries {
namespace {

using Words = std::span<const Word>;

/// Blocks of a program that a person writes.
constexpr std::size_t most_blocks = 5000;

/// What the codes of a block make of its words.
enum class Kind : unsigned char { other, move, arc, dwell };

bool only_switches(ModalRole role) {
    switch (role) {
    case ModalRole::plane:
    case ModalRole::distance:
    case ModalRole::feed_mode:
    case ModalRole::work_offset:
    case ModalRole::cutter_compensation:
    case ModalRole::length_compensation:
    case ModalRole::cutting_mode: return true;
    default: return false;
    }
}

Kind kind_of(const ControlModel& control, Words words) {
    constexpr double dwell = 4, last_usual_function = 99;
    Kind kind = Kind::move;
    for (const Word& word : words) {
        const auto* code = std::get_if<Literal>(&word.value);
        if (word.address == "M" && (code == nullptr || code->value > last_usual_function)) return Kind::other;
        if (word.address != "G") continue;
        if (code == nullptr) return Kind::other;
        if (code->value == dwell) return words.size() <= 3 ? Kind::dwell : Kind::other;
        const auto group = control.group_of('G', code->value);
        if (!group) return Kind::other;
        const ModalGroup& row = control.groups[*group];
        const bool arc = std::ranges::find(row.circles, code->value) != row.circles.end();
        if (row.role == ModalRole::motion && (arc || code->value <= 1))
            kind = arc ? Kind::arc : kind;
        else if (!only_switches(row.role))
            return Kind::other;
    }
    return kind;
}

class Counter {
  public:
    void count(const Program& program) {
        if (has_modal_calls(program)) return;
        for_each_block_with_words(
            program, [](const WordSummary&) { return true; },
            [&](const BlockView& block, Words words, const WordSummary*) {
                const auto is_call = [](const Effect& effect) {
                    return std::holds_alternative<Call>(effect.what);
                };
                if (std::ranges::none_of(program.effects_in(block.effects), is_call)) look_at(program, words);
            });
    }
    Lengths lengths;

  private:
    void look_at(const Program& program, Words words) {
        const Kind kind = kind_of(*program.control, words);
        if (kind == Kind::other) return;
        const std::string_view letters = kind == Kind::dwell ? "XUP"
                                         : kind == Kind::arc ? "XYZUVWIJKR"
                                                             : letters_of_lengths;
        for (const Word& word : words) {
            const auto* value = std::get_if<Literal>(&word.value);
            if (value == nullptr || value->value == 0 || word.address.size() != 1 ||
                letters.find(word.address) == std::string_view::npos ||
                value->value != std::floor(value->value))
                continue;
            const LengthWord length{&program, word.span, word.address, *value};
            if (kind == Kind::dwell) {
                lengths.times.push_back(length);
                continue;
            }
            ++lengths.count;
            if (!value->decimal_point) lengths.bare.push_back(length);
        }
    }
};

} // namespace

bool Lengths::have_points() const {
    constexpr std::size_t least = 10, of_ten = 9;
    const std::size_t pointed = count - bare.size();
    return pointed >= least && pointed >= of_ten * bare.size();
}

Lengths lengths_of(const ProgramFile& file) {
    Counter counter;
    if (file.control->calculator_input) return {};
    for (const Program& program : file.programs)
        if (count_blocks(program) <= most_blocks) counter.count(program);
    return std::move(counter.lengths);
}

} // namespace maclint::queries
