//! Takes the sum apart that an index is.
#include "analyzer/dataflow/solver/index_reach.hpp"

#include "analyzer/flow/walk.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <variant>

namespace maclint::dataflow {
namespace {

/// What is added up in an index.
struct Sum {
    double number = 0;      ///< of all numbers that stand there
    bool subtracts = false; ///< something that is no number is taken away
    bool shared = false;    ///< a variable that all programs share is added
    int terms = 0;
    std::vector<Variable> variables; ///< that are added
};

class SumReader {
  public:
    explicit SumReader(const Program& program)
        : program_(program) {}

    Sum read(ExpressionId index) {
        add(index, false);
        return sum_;
    }

  private:
    void add(ExpressionId id, bool negative) {
        const auto& node = program_.expressions[id].node;
        if (const auto* apply = std::get_if<Apply>(&node);
            apply != nullptr &&
            (apply->operation == Operation::add || apply->operation == Operation::subtract)) {
            const auto operands = program_.operands_of(*apply);
            add(operands[0], negative);
            add(operands[1], negative != (apply->operation == Operation::subtract));
            return;
        }
        ++sum_.terms;
        if (const auto* literal = std::get_if<Literal>(&node)) {
            sum_.number += negative ? -literal->value : literal->value;
            return;
        }
        sum_.subtracts |= negative;
        if (const auto* load = std::get_if<Load>(&node); load != nullptr && !negative) {
            sum_.shared |= program_.control->spaces[load->variable.space].scope != Scope::frame;
            sum_.variables.push_back(load->variable);
        }
    }

    const Program& program_;
    Sum sum_;
};

std::pair<SpaceId, std::int32_t> key(Variable variable) { return {variable.space, variable.number}; }

} // namespace

IndexReach IndexReaches::of(FamilyId family, ExpressionId index, const semantics::Range& known,
                            flow::NodeId node) {
    IndexReach reach{known};
    if (std::isfinite(known.low) && std::isfinite(known.high)) return reach;
    const IndexCustom& custom = program_.control->families[family].custom;
    const Sum sum = SumReader(program_).read(index);
    if (sum.number >= custom.least_base) {
        reach.locals = false;
        reach.numbers.high = std::min(known.high, sum.number + custom.reach);
        if (!sum.subtracts) reach.numbers.low = std::max(known.low, sum.number);
    }
    if (custom.shared_points_to_shared && sum.shared && sum.terms > 1) reach.locals = false;
    if (reach.locals && std::isfinite(custom.least_base))
        reach.locals = std::ranges::none_of(sum.variables, [&](Variable variable) {
            return sum.number + base_of(variable, index, node) >= custom.least_base;
        });
    return reach;
}

double IndexReaches::base_of(Variable variable, ExpressionId index, flow::NodeId node) {
    if (!bases_) collect_bases();
    if (program_.is_formal(variable) && may_be_passed(variable, index, node)) return 0;
    const auto found = std::ranges::lower_bound(*bases_, key(variable), {},
                                                [](const Base& base) { return key(base.variable); });
    return found == bases_->end() || !(found->variable == variable) ? 0 : found->number;
}

/// #10=5221+[#4012-54]*20 and #10=#10+20 leave 5221 for #10.
void IndexReaches::collect_bases() {
    std::vector<Base> all;
    for (const Effect& effect : program_.effects) {
        if (const auto* unreadable = std::get_if<UnreadableBlock>(&effect.what))
            for (const Variable variable : program_.variables_of(*unreadable)) all.push_back({variable, 0});
        const auto* assign = std::get_if<Assign>(&effect.what);
        const auto* target = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
        if (target == nullptr) continue;
        const Sum sum = SumReader(program_).read(assign->value);
        if (std::ranges::find(sum.variables, *target) == sum.variables.end())
            all.push_back({*target, sum.number});
    }
    std::ranges::sort(all, {}, [](const Base& base) { return std::pair(key(base.variable), base.number); });
    const auto twice = std::ranges::unique(all, {}, &Base::variable);
    all.erase(twice.begin(), twice.end());
    bases_ = std::move(all);
}

bool IndexReaches::may_be_passed(Variable variable, ExpressionId index, flow::NodeId node) {
    if (node >= graph_.nodes.size()) return true; // nobody has looked where the control goes
    const auto [known, fresh] = passed_.try_emplace(variable);
    std::vector<bool>& passed = known->second;
    if (fresh) {
        constexpr Offset anywhere = std::numeric_limits<Offset>::max();
        passed.assign(graph_.nodes.size(), false);
        passed[0] = true;
        if (!sets(0, variable, anywhere))
            flow::walk<flow::Direction::forward>(graph_, {0}, [&](flow::EdgeId, flow::NodeId to) {
                passed[to] = true;
                return sets(to, variable, anywhere) ? flow::Step::end : flow::Step::go_on;
            });
    }
    return passed[node] && !sets(node, variable, program_.expressions[index].span.begin);
}

bool IndexReaches::sets(flow::NodeId node, Variable variable, Offset before) const {
    return std::ranges::any_of(program_.effects_in(graph_.nodes[node].effects), [&](const Effect& effect) {
        const auto* assign = std::get_if<Assign>(&effect.what);
        const auto* target = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
        return target != nullptr && *target == variable && effect.span.end <= before;
    });
}

} // namespace maclint::dataflow
