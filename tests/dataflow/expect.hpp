//! What tests of data flow expect of values and truths.
#pragma once

#include "analyzer/dataflow/domain/arithmetic.hpp"

#include <gtest/gtest.h>

namespace maclint::dataflow {

using semantics::infinity;

inline void expect_truth(Truth truth, bool can_hold, bool can_fail) {
    EXPECT_EQ(truth.can_hold, can_hold);
    EXPECT_EQ(truth.can_fail, can_fail);
}

} // namespace maclint::dataflow

/// Both bounds of a value; a macro, so that a failure names the line of the test.
#define EXPECT_RANGE(value, from, to)                                                                        \
    {                                                                                                        \
        const maclint::dataflow::Value found = value;                                                        \
        EXPECT_EQ(found.low, from);                                                                          \
        EXPECT_EQ(found.high, to);                                                                           \
    }
