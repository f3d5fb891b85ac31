//! Looks at the words of each move under the modes that may be in force there.
#include "rules/modal/position_as_increment_finder.hpp"

#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/program/machine_words.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/values/positions.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <span>
#include <variant>

namespace maclint::rules {
namespace {

class Finder {
  public:
    Finder(const ProgramAnalysis& analysis, GroupId group, const MachineWords& machine)
        : analysis_(analysis)
        , program_(analysis.program())
        , group_(group)
        , machine_(machine) {}

    [[nodiscard]] std::vector<PositionAsIncrement> find() const {
        std::vector<PositionAsIncrement> found;
        std::set<Offset> told; // codes
        queries::ModesAt modes_at(analysis_);
        for_each_block(program_, [&](const BlockView& block) {
            const auto effect = words_of_move(block);
            const auto node = effect ? analysis_.graph().node_of(*effect) : std::nullopt;
            if (!node || !Budget::allows()) return;
            const auto word = first_position(*effect);
            if (!word) return;
            for (const queries::Mode& mode : modes_at(block).with_words(group_).possible) {
                const bool counts_on =
                    mode.set_by == queries::Mode::SetBy::word && mode.code && *mode.code != machine_.absolute;
                if (counts_on && told.insert(queries::span_of(analysis_, mode).begin).second)
                    found.push_back({word->span, word->position, *node, group_, mode});
            }
        });
        return found;
    }

  private:
    struct PositionWord {
        Span span;
        ExpressionId position;
    };

    /// The effect that calculates the words of a move; nothing where the block moves otherwise.
    [[nodiscard]] std::optional<EffectId> words_of_move(const BlockView& block) const {
        std::optional<EffectId> words;
        bool moves = false;
        for (EffectId id = block.effects.first; id < block.effects.first + block.effects.count; ++id) {
            const auto& what = program_.effects[id].what;
            if (std::holds_alternative<EvaluateWords>(what)) words = id;
            const auto* motion = std::get_if<Motion>(&what);
            moves |= motion != nullptr && !motion->to_reference && !motion->without_feed;
        }
        return moves ? words : std::nullopt;
    }

    /// Whether nothing is taken away from anything.
    [[nodiscard]] bool only_adds(ExpressionId id) const {
        const auto* apply = std::get_if<Apply>(&program_.expressions[id].node);
        if (apply == nullptr) return true;
        if (apply->operation == Operation::subtract || apply->operation == Operation::negate) return false;
        return std::ranges::all_of(program_.operands_of(*apply),
                                   [&](ExpressionId operand) { return only_adds(operand); });
    }

    [[nodiscard]] std::optional<PositionWord> first_position(EffectId effect) const {
        const auto node = analysis_.graph().node_of(effect);
        std::optional<PositionWord> found;
        for_each_block_with_words(
            program_, analysis_.graph().nodes[*node].stretch(),
            [&](const BlockView&, std::span<const Word> words) {
                if (std::ranges::any_of(words, [&](const Word& word) { return counts_elsewhere(word); }))
                    return;
                for (const Word& word : words)
                    if (!found) found = position_in(effect, word);
            });
        return found;
    }

    [[nodiscard]] bool counts_elsewhere(const Word& word) const {
        const auto* code = std::get_if<Literal>(&word.value);
        return code != nullptr && word.address == "G" &&
               std::ranges::find(machine_.of_machine, code->value) != machine_.of_machine.end();
    }

    [[nodiscard]] std::optional<PositionWord> position_in(EffectId effect, const Word& word) const {
        const auto* value = std::get_if<ExpressionId>(&word.value);
        const bool is_length =
            word.address.size() == 1 && letters_of_lengths.find(word.address) != std::string_view::npos;
        if (value == nullptr || !is_length || word.incremental || !only_adds(*value)) return std::nullopt;
        const auto position = position_in(effect, *value);
        return position ? std::optional(PositionWord{word.span, *position}) : std::nullopt;
    }

    /// The position in the sum, or of which a variable in it is a copy.
    [[nodiscard]] std::optional<ExpressionId> position_in(EffectId effect, ExpressionId id) const {
        const auto& node = program_.expressions[id].node;
        if (is_position(id)) return id;
        if (std::holds_alternative<Load>(node)) {
            const auto reads = analysis_.facts().at<dataflow::Read>(effect);
            const auto read = std::ranges::find(reads, id, &dataflow::Read::expression);
            if (read == reads.end()) return std::nullopt;
            const auto made = analysis_.data().table().symbols[read->value.symbol].expression();
            if (!made || *made >= program_.expressions.size()) return std::nullopt;
            const auto of_copy = static_cast<ExpressionId>(*made);
            return is_position(of_copy) ? std::optional(of_copy) : std::nullopt;
        }
        const auto* sum = std::get_if<Apply>(&node);
        if (sum == nullptr || sum->operation != Operation::add) return std::nullopt;
        for (const ExpressionId operand : program_.operands_of(*sum))
            if (const auto found = position_in(effect, operand)) return found;
        return std::nullopt;
    }

    [[nodiscard]] bool is_position(ExpressionId id) const {
        return queries::position_read(program_, id) != nullptr;
    }

    const ProgramAnalysis& analysis_;
    const Program& program_;
    GroupId group_;
    const MachineWords& machine_;
};

} // namespace

std::vector<PositionAsIncrement> find_positions_as_increments(const ProgramAnalysis& analysis) {
    const auto group = analysis.control().group_with(ModalRole::distance);
    const MachineWords* machine = analysis.control().machine_words;
    if (!group || machine == nullptr) return {};
    return Finder(analysis, *group, *machine).find();
}

} // namespace maclint::rules
