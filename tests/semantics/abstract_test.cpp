//! What is said of results before the program runs, held against results: random values, random contents of
//! them, and the numbers that concrete.hpp makes of those.
#include "analyzer/semantics/exactness.hpp"
#include "tests/semantics/sampling.hpp"

#include <cmath>
#include <functional>
#include <map>

#include <gtest/gtest.h>

namespace maclint::semantics {
namespace {

/// One operation on contents that `first` and `second` allow, and its result.
struct Trial {
    Operation operation;
    AbstractValue first, second; ///< one operand: the same twice
    Content a, b;
    double result;
};

std::ostream& operator<<(std::ostream& out, const Trial& trial) {
    return out << "operation " << static_cast<int>(trial.operation) << " of " << spell(trial.a) << " ("
               << trial.first << ") and " << spell(trial.b) << " (" << trial.second << ") is "
               << trial.result;
}

/// Shows `visit` many results of each operation that there are: of operands for which there is one, and that
/// a variable can hold.
void for_many_results(const std::function<void(const Trial&)>& visit) {
    Sampler sampler;
    std::map<Operation, int> seen;
    const auto look = [&](Operation operation, bool is_binary) {
        Trial trial{operation, sampler.value(), {}, {}, {}, 0};
        trial.a = sampler.content(trial.first);
        trial.second = is_binary ? sampler.value() : trial.first;
        trial.b = is_binary ? sampler.content(trial.second) : trial.a;
        const std::array operands{trial.a, trial.b};
        const Result result = compute(operation, std::span(operands).first(is_binary ? 2 : 1));
        const auto* number = std::get_if<double>(&result);
        if (number == nullptr || !is_in_range(*number)) return;
        trial.result = *number;
        ++seen[operation];
        visit(trial);
    };
    constexpr int rounds = 3000;
    for (int round = 0; round < rounds; ++round) {
        for (const Operation operation : unary_operations) look(operation, false);
        for (const Operation operation : binary_operations) look(operation, true);
    }
    constexpr int enough = 100;
    for (const Operation operation : unary_operations) EXPECT_GT(seen[operation], enough);
    for (const Operation operation : binary_operations) EXPECT_GT(seen[operation], enough);
}

TEST(Abstract, ResultsLieWhereTheyAreSaidToLie) {
    for_many_results([](const Trial& trial) {
        const AbstractValue said = compute(trial.operation, trial.first, trial.second);
        EXPECT_TRUE(allows(said, trial.result)) << trial << ", said to be " << said;
        EXPECT_EQ(said.vacancy, Vacancy::set);
    });
}

TEST(Abstract, OneWholeNumberIsTheResult) {
    int known = 0;
    for_many_results([&](const Trial& trial) {
        const AbstractValue said = compute(trial.operation, trial.first, trial.second);
        if (!is_whole_number(said)) return;
        ++known;
        EXPECT_EQ(said.low, trial.result) << trial;
        EXPECT_EQ(said, of_number(trial.result)) << trial;
    });
    EXPECT_GT(known, 100);
}

/// Beyond that not every whole number is one of binary arithmetic.
constexpr double largest_whole = 9007199254740992;

/// A number as it is written, in millionths: 0.1 is 100000 of them, and no number of binary arithmetic.
long double as_written(Content content) { return std::round(content.value_or(0) * 1e6L); }

/// Whether the result is that of arithmetic without rounding; 64 binary digits hold what is looked at here.
bool is_unrounded(const Trial& trial) {
    const long double a = trial.a.value_or(0), b = trial.b.value_or(0), result = trial.result;
    switch (trial.operation) {
    case Operation::add: return result == a + b;
    case Operation::subtract: return result == a - b;
    case Operation::multiply: return result == a * b;
    case Operation::divide:
        return result * b == a || result * as_written(trial.b) == as_written(trial.a); // 2/0.1 is 20
    case Operation::power: return result == std::pow(a, b);
    default: return true; // signs, and what gives whole numbers
    }
}

TEST(Abstract, WhatIsSaidToBeExactIsNotRounded) {
    std::map<Operation, int> exact;
    for_many_results([&](const Trial& trial) {
        if (exactness_of(trial.operation, trial.first, trial.second) != Exactness::exact) return;
        if (std::abs(trial.result) >= largest_whole) return;
        ++exact[trial.operation];
        EXPECT_TRUE(is_unrounded(trial)) << trial;
    });
    using enum Operation;
    for (const Operation operation :
         {add, subtract, multiply, divide, power, negate, bit_and, Operation::round})
        EXPECT_GT(exact[operation], 10) << static_cast<int>(operation);
}

TEST(Abstract, WhatIsSaidToBeWholeIsWhole) {
    std::map<Operation, int> whole;
    for_many_results([&](const Trial& trial) {
        if (!gives_whole_numbers(trial.operation, trial.first, trial.second)) return;
        ++whole[trial.operation];
        EXPECT_EQ(std::floor(trial.result), trial.result) << trial;
    });
    using enum Operation;
    for (const Operation operation :
         {add, subtract, multiply, modulo, power, negate, absolute, bit_or, truncate})
        EXPECT_GT(whole[operation], 10) << static_cast<int>(operation);
}

TEST(Abstract, ZeroAndVacantMakeZeroWhereTheOperationKeepsIt) {
    for_many_results([](const Trial& trial) {
        if (keeps_zero(trial.operation) && (trial.a.value_or(0) == 0 || trial.b.value_or(0) == 0)) {
            EXPECT_EQ(trial.result, 0) << trial;
        }
    });
}

TEST(Abstract, OperandsCanBeExchangedWhereItIsSaid) {
    std::map<Operation, bool> differs;
    for_many_results([&](const Trial& trial) {
        const std::array exchanged{trial.b.value_or(0), trial.a.value_or(0)};
        const Result other = compute(trial.operation, std::span<const double>(exchanged));
        const auto* number = std::get_if<double>(&other);
        differs[trial.operation] |= number == nullptr || *number != trial.result;
    });
    for (const Operation operation : binary_operations)
        EXPECT_EQ(is_commutative(operation), !differs[operation]) << static_cast<int>(operation);
}

TEST(Abstract, TheJoinOfTwoAllowsWhatEitherDoes) {
    Sampler sampler;
    for (int round = 0; round < 10000; ++round) {
        const AbstractValue a = sampler.value(), b = sampler.value();
        const AbstractValue joined = join(a, b);
        EXPECT_EQ(joined, join(b, a));
        for (const AbstractValue& one : {a, b}) {
            const Content content = sampler.content(one);
            ASSERT_TRUE(allows(one, content)) << spell(content) << ": " << one;
            EXPECT_TRUE(allows(joined, content)) << spell(content) << ": " << a << "; " << b;
            EXPECT_GE(joined.exactness, one.exactness);
        }
        // What is known of both is known of the join: whether it is vacant, and that it is not 0.
        if (a.vacancy == b.vacancy) {
            EXPECT_EQ(joined.vacancy, a.vacancy);
        }
        EXPECT_EQ(joined.nonzero, !a.can_be(0) && !b.can_be(0));
    }
}

TEST(Abstract, WhatAVariableOfATypeCanHoldAllowsWhatItHolds) {
    Sampler sampler;
    int kept = 0, changed = 0;
    for (int round = 0; round < 10000; ++round) {
        const AbstractValue value = sampler.value();
        const Content content = sampler.content(value);
        EXPECT_EQ(stored_in(VariableType::text, value), value); // calculated with it is not
        for (const VariableType type : {VariableType::number, VariableType::integer, VariableType::truth}) {
            const Content held = content ? Content(stored_in(type, *content)) : content;
            const AbstractValue said = stored_in(type, value);
            EXPECT_TRUE(allows(said, held)) << spell(content) << ": " << value << ", held is " << said;
            if (type != VariableType::number && held) {
                EXPECT_EQ(std::floor(*held), *held);
            }
            if (fits(type, value)) {
                EXPECT_EQ(held, content) << value;
                ++kept;
            } else if (held != content) {
                ++changed;
            }
        }
    }
    EXPECT_GT(kept, 10000);
    EXPECT_GT(changed, 1000);
}

TEST(Abstract, VacancyOnSomePathsIsEvidenceWhateverIsKnownOfTheOthers) {
    const auto joined = [](Vacancy a, Vacancy b) {
        return join(AbstractValue{{}, a}, AbstractValue{{}, b}).vacancy;
    };
    using enum Vacancy;
    EXPECT_EQ(joined(set, vacant), maybe);
    EXPECT_EQ(joined(unknown, vacant), maybe);
    EXPECT_EQ(joined(unknown, maybe), maybe);
    EXPECT_EQ(joined(set, maybe), maybe);
    EXPECT_EQ(joined(set, unknown), unknown);
}

TEST(Abstract, ANumberAllowsItselfAndVacantNothingElse) {
    for (const double number : {-2.5, 0.0, 0.1, 3.0}) {
        EXPECT_TRUE(allows(of_number(number), number));
        EXPECT_FALSE(allows(of_number(number), number + 1));
        EXPECT_FALSE(allows(of_number(number), {}));
        EXPECT_EQ(of_number(number).constant(), number);
    }
    EXPECT_TRUE(allows(of_vacant(), {}));
    EXPECT_FALSE(allows(of_vacant(), 0));
    EXPECT_FALSE(of_vacant().constant());
    EXPECT_TRUE(of_vacant().can_be(0)); // in arithmetic
}

} // namespace
} // namespace maclint::semantics
