//! Compares what statements set with the first thing that their sums read.
#include "rules/variables/crossed_axes_siblings_finder.hpp"

#include "analyzer/dataflow/domain/state.hpp"
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace maclint::rules {
namespace {

using dataflow::Key;
using dataflow::key_of;

/// The left side of the sum that the assignment stores.
std::optional<ExpressionId> first_summand(const Program& program, const Assign& assign) {
    const auto* sum = std::get_if<Apply>(&program.expressions[assign.value].node);
    if (sum == nullptr || (sum->operation != Operation::add && sum->operation != Operation::subtract))
        return std::nullopt;
    ExpressionId left = program.operands_of(*sum).front();
    while (const auto* inner = std::get_if<Apply>(&program.expressions[left].node)) {
        if (inner->operation != Operation::add && inner->operation != Operation::subtract)
            return std::nullopt;
        left = program.operands_of(*inner).front();
    }
    return left;
}

/// What a statement sets and goes on from, where both are of one kind.
template<class Place>
struct Step {
    EffectId effect;
    Place target;
    ExpressionId operand;
    Place from;
};

/// Offsets of one axis.
struct OffsetNumber {
    const VariableRange* range;
    std::int32_t number;

    [[nodiscard]] bool is_own(const OffsetNumber& target) const { return number == target.number; }
};

std::optional<OffsetNumber> offset(const Program& program, FamilyId family, std::int32_t number) {
    const VariableRange* range = program.control->families[family].find(number);
    if (range == nullptr || !range->first_code) return std::nullopt;
    return OffsetNumber{range, number};
}

std::optional<Step<OffsetNumber>> offset_step(const Program& program, EffectId id, const Assign& assign,
                                              ExpressionId operand) {
    const auto* target = std::get_if<StoreMachine>(&assign.target);
    const auto* load = std::get_if<LoadMachine>(&program.expressions[operand].node);
    if (target == nullptr || load == nullptr || target->family != load->family) return std::nullopt;
    const auto set = offset(program, target->family, target->number);
    const auto from = offset(program, load->family, load->number);
    const bool of_one_axis = set && from && set->range == from->range &&
                             set->range->axis(set->number) == from->range->axis(from->number);
    return of_one_axis ? std::optional(Step<OffsetNumber>{id, *set, operand, *from}) : std::nullopt;
}

/// #[#11+2]: a variable, and how far beyond its number.
struct Indexed {
    Variable start;
    double further;
};

std::optional<Indexed> indexed(const Program& program, ExpressionId index) {
    const auto& node = program.expressions[index].node;
    if (const auto* load = std::get_if<Load>(&node)) return Indexed{load->variable, 0};
    const auto* sum = std::get_if<Apply>(&node);
    if (sum == nullptr || sum->operation != Operation::add) return std::nullopt;
    const auto operands = program.operands_of(*sum);
    const auto* load = std::get_if<Load>(&program.expressions[operands[0]].node);
    const auto* literal = std::get_if<Literal>(&program.expressions[operands[1]].node);
    if (load == nullptr || literal == nullptr) return std::nullopt;
    return Indexed{load->variable, literal->value};
}

std::optional<Step<Indexed>> indexed_step(const Program& program, EffectId id, const Assign& assign,
                                          ExpressionId operand) {
    const auto* target = std::get_if<StoreAt>(&assign.target);
    const auto* load = std::get_if<LoadAt>(&program.expressions[operand].node);
    if (target == nullptr || load == nullptr) return std::nullopt;
    const auto set = indexed(program, target->index);
    const auto from = indexed(program, load->index);
    return set && from ? std::optional(Step<Indexed>{id, *set, operand, *from}) : std::nullopt;
}

/// The number that `#510=#510+1` adds.
const Literal* added_number(const Program& program, const Assign& assign) {
    const auto* sum = std::get_if<Apply>(&program.expressions[assign.value].node);
    return sum == nullptr ? nullptr
                          : std::get_if<Literal>(&program.expressions[program.operands_of(*sum)[1]].node);
}

std::string text_before_equals(const Program& program, EffectId effect) {
    const std::string text = without_blanks(program.slice(program.effects[effect].span));
    return text.substr(0, text.find('='));
}

class Steps {
  public:
    explicit Steps(const Program& program)
        : program_(program) {
        for (EffectId id = 0; id < program.effects.size(); ++id) {
            const auto* assign = std::get_if<Assign>(&program.effects[id].what);
            if (assign == nullptr) continue;
            const auto operand = first_summand(program, *assign);
            if (!operand) continue;
            if (const auto step = offset_step(program, id, *assign, *operand)) offsets_.push_back(*step);
            if (const auto step = indexed_step(program, id, *assign, *operand)) indexed_.push_back(*step);
            const auto* target = std::get_if<Variable>(&assign->target);
            const auto* load = std::get_if<Load>(&program.expressions[*operand].node);
            if (target != nullptr && load != nullptr && added_number(program, *assign) != nullptr)
                counts_.push_back({id, *target, *operand, load->variable});
        }
    }

    [[nodiscard]] std::vector<FromSibling> find() const {
        std::vector<FromSibling> found;
        find_offsets(found);
        find_indexed(found);
        find_counts(found);
        std::ranges::sort(found, {}, &FromSibling::effect);
        return found;
    }

  private:
    static constexpr std::ptrdiff_t enough_siblings = 2;

    void add(EffectId effect, ExpressionId operand, std::string own, EffectId sibling, bool counts,
             std::vector<FromSibling>& found) const {
        found.push_back({effect, operand, std::move(own), sibling, counts});
    }

    void find_offsets(std::vector<FromSibling>& found) const {
        const auto is_own = [](const Step<OffsetNumber>& step) { return step.from.is_own(step.target); };
        const auto own = std::ranges::count_if(offsets_, is_own);
        if (own < enough_siblings || std::ssize(offsets_) != own + 1) return;
        const auto odd = std::ranges::find_if_not(offsets_, is_own);
        add(odd->effect, odd->operand, text_before_equals(program_, odd->effect),
            std::ranges::find_if(offsets_, is_own)->effect, false, found);
    }

    void find_indexed(std::vector<FromSibling>& found) const {
        struct Likes {
            std::vector<const Step<Indexed>*> own,
                odd; ///< as far beyond one start as beyond the other, or not
        };
        std::map<std::pair<Key, Key>, Likes> by_starts;
        for (const Step<Indexed>& step : indexed_) {
            Likes& likes = by_starts[{key_of(step.target.start), key_of(step.from.start)}];
            (step.from.further == step.target.further ? likes.own : likes.odd).push_back(&step);
        }
        for (const auto& [starts, likes] : by_starts) {
            if (starts.first == starts.second || std::ssize(likes.own) < enough_siblings ||
                likes.odd.size() != 1)
                continue;
            const Step<Indexed>& odd = *likes.odd.front();
            const std::string further = std::to_string(static_cast<int>(odd.target.further));
            add(odd.effect, odd.operand, "#[" + program_.spell(odd.from.start) + "+" + further + "]",
                likes.own.front()->effect, false, found);
        }
    }

    /// What else than by counting the variables are set to.
    struct Settings {
        std::vector<double> numbers;
        std::size_t others = 0; ///< statements that store something else
    };
    [[nodiscard]] std::map<Key, Settings> settings() const {
        std::map<Key, Settings> all;
        for (const Effect& effect : program_.effects) {
            const auto* assign = std::get_if<Assign>(&effect.what);
            const auto* target = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
            if (target == nullptr) continue;
            Settings& of = all[key_of(*target)];
            const auto* literal = std::get_if<Literal>(&program_.expressions[assign->value].node);
            if (literal == nullptr)
                ++of.others;
            else
                of.numbers.push_back(literal->value);
        }
        return all;
    }

    void find_counts(std::vector<FromSibling>& found) const {
        std::map<Key, const Step<Variable>*> own; ///< the first that goes on from its own
        for (const Step<Variable>& step : counts_)
            if (step.target == step.from) own.try_emplace(key_of(step.target), &step);
        if (own.empty() || own.size() == counts_.size()) return;
        const std::map<Key, Settings> all = settings();
        for (const Step<Variable>& odd : counts_) {
            const auto sibling = own.find(key_of(odd.from));
            if (odd.target == odd.from || sibling == own.end()) continue;
            const Settings& here = all.at(key_of(odd.target));
            const Settings& there = all.at(key_of(odd.from));
            const bool alike = here.others == 1 && there.others == 1 && !here.numbers.empty() &&
                               here.numbers == there.numbers;
            if (alike)
                add(odd.effect, odd.operand, program_.spell(odd.target), sibling->second->effect, true,
                    found);
        }
    }

    const Program& program_;
    std::vector<Step<OffsetNumber>> offsets_;
    std::vector<Step<Indexed>> indexed_;
    std::vector<Step<Variable>> counts_;
};

} // namespace

std::vector<FromSibling> find_statements_from_siblings(const Program& program) {
    return Steps(program).find();
}

} // namespace maclint::rules
