//! When bounds of numbers are widened, and to what.
#include "analyzer/dataflow/solver/state_domain.hpp"

#include <algorithm>

namespace maclint::dataflow {
namespace {

/// Visits of a loop head before its bounds are widened, and of any node before its old state is kept in the
/// join.
constexpr std::uint32_t visits_before_widening = 2;
constexpr std::uint32_t visits_before_keeping = 12;
/// Visits of a loop head up to which bounds grow from threshold to threshold; then they become infinite.
constexpr std::uint32_t visits_before_infinity = 5;
constexpr std::size_t most_thresholds = 128;

/// The numbers that the program compares with: bounds of loops usually stop there.
std::vector<double> thresholds_of(const Program& program) {
    std::vector<double> numbers{0};
    for (const Expression& expression : program.expressions) {
        const auto* apply = std::get_if<Apply>(&expression.node);
        if (apply == nullptr || !is_comparison(apply->operation)) continue;
        for (const ExpressionId operand : program.operands_of(*apply))
            if (const auto* literal = std::get_if<Literal>(&program.expressions[operand].node))
                numbers.push_back(literal->value);
        if (numbers.size() > most_thresholds) break;
    }
    std::ranges::sort(numbers);
    numbers.erase(std::ranges::unique(numbers).begin(), numbers.end());
    return numbers;
}

} // namespace

StateDomain::StateDomain(const Program& program, States& states, Transfer& transfer)
    : states_(states)
    , transfer_(transfer)
    , thresholds_(thresholds_of(program)) {}

bool StateDomain::widens(bool is_head, std::uint32_t visit) {
    return visit >= (is_head ? visits_before_widening : visits_before_keeping);
}

State StateDomain::widen(flow::NodeId node, bool is_head, std::uint32_t visit, const State& old,
                         const State& incoming) {
    if (!is_head) return states_.join(old, incoming, node);
    const bool stops_at_thresholds = visit < visits_before_infinity;
    return states_.widen(old, incoming, node,
                         stops_at_thresholds ? std::span<const double>(thresholds_)
                                             : std::span<const double>{});
}

} // namespace maclint::dataflow
