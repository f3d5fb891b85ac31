//! The outcome of a condition of several comparisons, so that it is known again where the same is asked.
#pragma once

#include "analyzer/dataflow/solver/transfer.hpp"

#include <optional>

namespace maclint::execution {

/// Two conditions with equal symbols are both true or both false. Where `negated` differs, one is true and
/// the other false: #1EQ1 AND #2EQ2, and #2NE2 OR #1NE1.
struct Outcome {
    dataflow::SymbolId symbol;
    bool negated;
};

/// The outcome of a condition of the program, asked in that state. Nothing for a single comparison, as its
/// values tell more; and nothing for a condition so long that no programmer writes the same again.
[[nodiscard]] std::optional<Outcome> outcome_of(const Program& program, dataflow::Transfer& transfer,
                                                dataflow::ValueTable& table, const dataflow::State& state,
                                                ExpressionId condition);

} // namespace maclint::execution
