//! Numbers that users edit in the text of a program.
#pragma once

#include "analyzer/dataflow/domain/value.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <map>
#include <unordered_map>
#include <utility>

namespace maclint::rules {

/// Gathered in one pass over the stores of a program.
class Settings {
  public:
    explicit Settings(const ProgramAnalysis& analysis);

    /// Whether what the effect's condition reads comes from nothing but numbers that stand in the program, or
    /// in one that it calls: directly, through copies and arithmetic, or on several paths with a number each.
    [[nodiscard]] bool is_all_that_is_read(ExpressionId condition, EffectId effect) const;
    /// Whether one of the variables read there does.
    [[nodiscard]] bool is_read(EffectId effect) const;

  private:
    [[nodiscard]] bool is_setting(const dataflow::Read& read, int depth) const;
    [[nodiscard]] bool is_setting(const dataflow::Store& store, int depth) const;
    [[nodiscard]] bool is_made_of_settings(const dataflow::Store& store, int depth) const;

    const ProgramAnalysis& analysis_;
    std::unordered_map<dataflow::Key, bool>
        only_numbers_; ///< whether all assignments to a variable are numbers
    /// The answers so far, by store and by the steps that are left: sums of sums are made of few stores.
    mutable std::map<std::pair<EffectId, int>, bool> known_;
};

} // namespace maclint::rules
