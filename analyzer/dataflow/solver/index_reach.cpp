//! Takes the sum apart that an index is.
#include "analyzer/dataflow/solver/index_reach.hpp"

#include <algorithm>
#include <cmath>

namespace maclint::dataflow {
namespace {

/// What is added up in an index.
struct Sum {
    double number = 0;      ///< of all numbers that stand there
    bool subtracts = false; ///< something that is no number is taken away
    bool shared = false;    ///< a variable that all programs share is added
    int terms = 0;
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
        if (const auto* load = std::get_if<Load>(&node); load != nullptr && !negative)
            sum_.shared |= program_.control->spaces[load->variable.space].scope != Scope::frame;
    }

    const Program& program_;
    Sum sum_;
};

} // namespace

IndexReach reach_of(const Program& program, FamilyId family, ExpressionId index,
                    const semantics::Range& known) {
    IndexReach reach{known};
    if (std::isfinite(known.low) && std::isfinite(known.high)) return reach;
    const IndexCustom& custom = program.control->families[family].custom;
    const Sum sum = SumReader(program).read(index);
    if (sum.number >= custom.least_base) {
        reach.locals = false;
        reach.numbers.high = std::min(known.high, sum.number + custom.reach);
        if (!sum.subtracts) reach.numbers.low = std::max(known.low, sum.number);
    }
    if (custom.shared_points_to_shared && sum.shared && sum.terms > 1) reach.locals = false;
    return reach;
}

} // namespace maclint::dataflow
