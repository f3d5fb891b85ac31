//! Looks at the words of each move under the modes that may be in force there.
#include "rules/modal/position_as_increment_finder.hpp"

#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/machine_words.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/values/positions.hpp"
#include "analyzer/queries/words/moving_words.hpp"

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
            const auto effect = queries::words_of_move(program_, block);
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

    /// Whether no position can be taken away from another.
    [[nodiscard]] bool only_adds(ExpressionId id) const {
        const auto* apply = std::get_if<Apply>(&program_.expressions[id].node);
        if (apply == nullptr) return true;
        const auto operands = program_.operands_of(*apply);
        if (apply->operation == Operation::subtract)
            return only_adds(operands[0]) && is_made_of_arguments(operands[1]);
        if (apply->operation == Operation::negate) return is_made_of_arguments(operands[0]);
        return std::ranges::all_of(operands, [&](ExpressionId operand) { return only_adds(operand); });
    }

    /// Whether numbers and arguments that nothing is stored in make it up: no position of this program.
    [[nodiscard]] bool is_made_of_arguments(ExpressionId id) const {
        const auto& node = program_.expressions[id].node;
        if (const auto* load = std::get_if<Load>(&node))
            return program_.is_formal(load->variable) &&
                   analysis_.facts().about<dataflow::Store>(load->variable).empty();
        const auto* apply = std::get_if<Apply>(&node);
        return std::holds_alternative<Literal>(node) ||
               (apply != nullptr && std::ranges::all_of(program_.operands_of(*apply), [&](ExpressionId of) {
                    return is_made_of_arguments(of);
                }));
    }

    [[nodiscard]] std::optional<PositionWord> first_position(EffectId effect) const {
        const auto node = analysis_.graph().node_of(effect);
        std::optional<PositionWord> found;
        for_each_block_with_words(program_, analysis_.graph().nodes[*node].stretch(),
                                  [&](const BlockView&, std::span<const Word> words) {
                                      if (std::ranges::any_of(words, [&](const Word& word) {
                                              return queries::counts_from_machine(machine_, word);
                                          }))
                                          return;
                                      for (const Word& word : words)
                                          if (!found) found = position_in(effect, word);
                                  });
        return found;
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
        if (const auto position = queries::copied_position(analysis_, effect, id)) return position;
        const auto* sum = std::get_if<Apply>(&program_.expressions[id].node);
        const bool is_sum = sum != nullptr && (sum->operation == Operation::add ||
                                               sum->operation == Operation::subtract); // see only_adds
        if (!is_sum) return std::nullopt;
        for (const ExpressionId operand : program_.operands_of(*sum))
            if (const auto found = position_in(effect, operand)) return found;
        return std::nullopt;
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
