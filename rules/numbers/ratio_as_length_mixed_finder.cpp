//! Follows positions into words, offsets and differences.
#include "rules/numbers/ratio_as_length_mixed_finder.hpp"

#include "analyzer/program/machine_words.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/modes_at.hpp"
#include "analyzer/queries/values/positions.hpp"
#include "analyzer/queries/values/stored_positions.hpp"
#include "analyzer/queries/words/moving_words.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <variant>

namespace maclint::rules {
namespace {

class Finder {
  public:
    Finder(const ProgramAnalysis& analysis, GroupId distance, const MachineWords& machine)
        : analysis_(analysis)
        , program_(analysis.program())
        , distance_(distance)
        , machine_(machine)
        , modes_at_(analysis) {}

    [[nodiscard]] std::vector<MixedPosition> find() {
        for_each_block_with_words(
            program_, [](const WordSummary&) { return true; },
            [&](const BlockView& block, std::span<const Word> words, const WordSummary*) {
                look_at(block, words);
            });
        look_at_offsets();
        look_at_differences();
        return std::move(found_);
    }

  private:
    struct Read {
        Span place;
        ExpressionId position;
        bool of_machine;
    };

    /// The position that the expression is, or from which it is a number away.
    [[nodiscard]] std::optional<ExpressionId> position_of(EffectId effect, ExpressionId id) const {
        const auto* sum = std::get_if<Apply>(&program_.expressions[id].node);
        if (sum == nullptr) return queries::copied_position(analysis_, effect, id);
        if (sum->operation != Operation::add && sum->operation != Operation::subtract) return std::nullopt;
        const auto operands = program_.operands_of(*sum);
        const auto is_number = [&](ExpressionId operand) {
            return std::holds_alternative<Literal>(program_.expressions[operand].node);
        };
        if (is_number(operands[1])) return queries::copied_position(analysis_, effect, operands[0]);
        if (is_number(operands[0]) && sum->operation == Operation::add)
            return queries::copied_position(analysis_, effect, operands[1]);
        return std::nullopt;
    }

    [[nodiscard]] std::optional<Read> read_in(EffectId effect, ExpressionId value, Span place) const {
        const auto position = position_of(effect, value);
        if (!position) return std::nullopt;
        const VariableRange& range = *queries::position_read(program_, *position);
        if (range.is_block_end) return std::nullopt; // of a move that may count from either
        return Read{place, *position, range.counts_from_machine};
    }

    void look_at(const BlockView& block, std::span<const Word> words) {
        const auto effect = effect_with_words(block);
        if (!effect) return;
        std::vector<Read> reads;
        for (const Word& word : words) {
            const auto* value = std::get_if<ExpressionId>(&word.value);
            const bool is_length =
                word.address.size() == 1 && letters_of_lengths.find(word.address) != std::string_view::npos;
            if (value == nullptr || !is_length || word.incremental) continue;
            if (const auto read = read_in(*effect, *value, word.span)) reads.push_back(*read);
        }
        if (reads.empty() || add_siblings(reads)) return;
        const bool in_machine = std::ranges::any_of(
            words, [&](const Word& word) { return queries::counts_from_machine(machine_, word); });
        if (in_machine && !reads.front().of_machine)
            add(MixedPosition::Kind::machine_move, reads.front(), {});
        else if (!in_machine && reads.front().of_machine && queries::words_of_move(program_, block) &&
                 !counts_on(block))
            add(MixedPosition::Kind::target, reads.front(), {});
    }

    [[nodiscard]] std::optional<EffectId> effect_with_words(const BlockView& block) const {
        for (EffectId id = block.effects.first; id < block.effects.first + block.effects.count; ++id)
            if (std::holds_alternative<EvaluateWords>(program_.effects[id].what)) return id;
        return std::nullopt;
    }

    /// Whether a word of the program may have chosen increments, which is another matter.
    [[nodiscard]] bool counts_on(const BlockView& block) {
        const auto& possible = modes_at_(block).with_words(distance_).possible;
        return std::ranges::any_of(possible, [&](const queries::Mode& mode) {
            return mode.set_by != queries::Mode::SetBy::nobody && mode.code != machine_.absolute;
        });
    }

    void add(MixedPosition::Kind kind, const Read& read, Span other) {
        found_.push_back({kind, read.place, read.position, other});
    }

    /// The first that is not of the kind of the first one.
    bool add_siblings(const std::vector<Read>& reads) {
        const auto odd = std::ranges::find_if(
            reads, [&](const Read& read) { return read.of_machine != reads.front().of_machine; });
        if (odd == reads.end()) return false;
        add(MixedPosition::Kind::sibling, *odd, reads.front().place);
        return true;
    }

    /// #5221=#5021, #5222=#5042: axes of one offset.
    void look_at_offsets() {
        std::map<std::pair<std::int32_t, std::int32_t>, std::vector<Read>> offsets;
        for (EffectId id = 0; id < program_.effects.size(); ++id) {
            const auto* assign = std::get_if<Assign>(&program_.effects[id].what);
            const auto* target = assign == nullptr ? nullptr : std::get_if<StoreMachine>(&assign->target);
            const VariableRange* range =
                target == nullptr ? nullptr : program_.control->families[target->family].find(target->number);
            if (range == nullptr || range->numbers_of_a_set == 0 || range->on_write != OnWrite::store)
                continue;
            const auto number = static_cast<std::int32_t>(target->number);
            if (const auto read = read_in(id, assign->value, program_.effects[id].span))
                offsets[{range->first, (number - range->first) / range->numbers_of_a_set}].push_back(*read);
        }
        for (const auto& [offset, reads] : offsets) add_siblings(reads);
    }

    void look_at_differences() {
        const queries::StoredPositions positions(analysis_);
        for (ExpressionId id = 0; id < program_.expressions.size(); ++id) {
            const auto* difference = std::get_if<Apply>(&program_.expressions[id].node);
            if (difference == nullptr || difference->operation != Operation::subtract) continue;
            const auto operands = program_.operands_of(*difference);
            const queries::StoredPosition* a = positions.in(operands[0]);
            const queries::StoredPosition* b = positions.in(operands[1]);
            if (a == nullptr || b == nullptr || a->axis != b->axis || a->moves == b->moves ||
                a->range->counts_from_machine == b->range->counts_from_machine)
                continue;
            const auto& of_machine = a->range->counts_from_machine ? *a : *b;
            const auto& other = a->range->counts_from_machine ? *b : *a;
            found_.push_back({MixedPosition::Kind::difference, program_.expressions[id].span,
                              std::get<Assign>(program_.effects[of_machine.effect].what).value,
                              program_.effects[other.effect].span});
        }
    }

    const ProgramAnalysis& analysis_;
    const Program& program_;
    GroupId distance_;
    const MachineWords& machine_;
    queries::ModesAt modes_at_;
    std::vector<MixedPosition> found_;
};

} // namespace

std::vector<MixedPosition> find_mixed_positions(const ProgramAnalysis& analysis) {
    const auto distance = analysis.control().group_with(ModalRole::distance);
    const MachineWords* machine = analysis.control().machine_words;
    if (!distance || machine == nullptr || !queries::reads_positions(analysis.program())) return {};
    return Finder(analysis, *distance, *machine).find();
}

} // namespace maclint::rules
