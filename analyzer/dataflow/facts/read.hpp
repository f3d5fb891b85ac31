//! A variable that is read.
#pragma once

#include "analyzer/dataflow/domain/value.hpp"
#include "analyzer/dataflow/facts/fact_set.hpp"
#include "analyzer/flow/graph.hpp"

#include <cstdint>

namespace maclint::dataflow {

/// What a variable is read for.
enum class Use : std::uint8_t { copy, arithmetic, comparison, vacancy_test, word, argument, index, jump };

struct Read {
    static constexpr FactPlace place{3};
    flow::NodeId node;
    EffectId effect;
    ExpressionId expression;
    Variable variable;
    Value value;
    Use use;
};

} // namespace maclint::dataflow
