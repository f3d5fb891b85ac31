//! A world whose answers depend on what is asked and how often alone, so that two programs are told the same.
#pragma once

#include "analyzer/execution/environment.hpp"
#include "tests/execution/recorded_run.hpp"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace maclint::test {

/// Numbers that matter to a program: those that it compares with, and a few that anybody tries.
[[nodiscard]] std::vector<double> numbers_of(const Program& program);

/// What is asked when a program reads the variable or the machine's value.
[[nodiscard]] std::uint64_t question_of(const Program& program, Variable variable);
[[nodiscard]] std::uint64_t question_of(const LoadMachine& owned);

class ToldWorld {
  public:
    /// The seed decides everything; `numbers` are what values are taken from.
    ToldWorld(std::uint64_t seed, std::vector<double> numbers)
        : seed_(seed)
        , numbers_(std::move(numbers)) {}

    /// The answer to a question, instead of one by chance.
    void tell(std::uint64_t question, semantics::Content answer) { told_[question] = answer; }
    /// Good as long as this world is.
    [[nodiscard]] execution::Environment environment(const ControlModel& control, bool main);

  private:
    [[nodiscard]] double number(std::uint64_t asked) const;
    [[nodiscard]] bool one_in(std::uint64_t times, std::uint64_t asked) const;
    [[nodiscard]] semantics::Content at_start(const Program& program, Variable variable) const;
    [[nodiscard]] double code(const ControlModel& control, GroupId id, bool main) const;
    [[nodiscard]] semantics::Content value_of(const Program& program, const Expression& expression);
    [[nodiscard]] execution::UnknownEffects unknown_call(const Program& program, CallKindId kind);
    [[nodiscard]] std::uint64_t again(std::uint64_t asked);

    std::uint64_t seed_;
    std::vector<double> numbers_;
    std::unordered_map<std::uint64_t, semantics::Content> told_;
    std::unordered_map<std::uint64_t, std::uint64_t> times_; ///< how often something was asked
};

} // namespace maclint::test
